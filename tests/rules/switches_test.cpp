//! What programs switch on and off, along their paths and through calls, and what is said of it.
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/program/word_condition.hpp"
#include "rules/words/rule_row.hpp"
#include "tests/rules/din_findings.hpp"

#include <set>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Of a whole program.
const std::string head = "PROGRAM HEAD\n";

/// Lines on which MAC527 speaks of a whole program, whose blocks begin on line 3.
std::vector<std::uint32_t> refused(const std::string& blocks) {
    return din_lines("MAC527", head + "MACHINING\n" + blocks + "END\n");
}
std::vector<std::uint32_t> left_on(const std::string& blocks) {
    return din_lines("MAC586", head + "MACHINING\n" + blocks + "END\n");
}

TEST(Switches, AreFollowedAlongThePaths) {
    EXPECT_THAT(refused("M14\nG110 C0\nM15\nM30\n"), IsEmpty());
    EXPECT_THAT(refused("G110 C0\nM30\n"), ElementsAre(3));
    EXPECT_THAT(refused("M14\nM15\nG110 C0\nM30\n"), ElementsAre(5));
    EXPECT_THAT(refused("IF #g1==1\nTHEN\nM14\nENDIF\nG110 C0\nM30\n"), IsEmpty()) << "on some path it is on";
    EXPECT_THAT(refused("IF #g1==1\nTHEN\nM14\nM15\nENDIF\nG110 C0\nM30\n"), ElementsAre(8))
        << "on none of them";
    EXPECT_THAT(refused("WHILE #g1<3\nG110 C0\nM14\nENDWHILE\nM15\nM30\n"), IsEmpty())
        << "from the second round on";
}

TEST(Switches, AreUnknownBehindWhatNobodyHas) {
    EXPECT_THAT(refused("L\"EXTERNAL\" V1\nG110 C0\nM30\n"), IsEmpty());
    EXPECT_THAT(refused("M714\nG110 C0\nM30\n"), IsEmpty()) << "a function of the builder's";
    EXPECT_THAT(refused("M8\nG110 C0\nM30\n"), ElementsAre(4)) << "one of the manual's";
    EXPECT_THAT(din_lines("MAC527", "N1 G110 C0\n"), IsEmpty()) << "a fragment";
}

TEST(Switches, PassThroughCalls) {
    const auto refused_in = [](const std::string& main, const std::string& sub) {
        return din_lines("MAC527",
                         head + "MACHINING\n" + main + "M30\nSUBPROGRAM \"SUB\"\n" + sub + "RETURN\nEND\n");
    };
    EXPECT_THAT(refused_in("L\"SUB\"\nG912 Q1\nG913\n", "G910\n"), IsEmpty());
    EXPECT_THAT(refused_in("G910\nL\"SUB\"\nG912 Q1\n", "G913\n"), ElementsAre(5));
    EXPECT_THAT(refused_in("G910\nL\"SUB\"\nG913\n", "G912 Q1\n"), IsEmpty())
        << "its caller has switched it on";
    EXPECT_THAT(refused_in("L\"SUB\"\n", "G912 Q1\n"), ElementsAre(6)) << "none of its callers has";
    EXPECT_THAT(refused_in("L\"SUB\"\nG910\nL\"SUB\"\nG913\n", "G912 Q1\n"), IsEmpty()) << "one of them has";
    EXPECT_THAT(refused_in("G910\nL\"SUB\"\nG912 Q1\n", "IF #g1==1\nTHEN\nG913\nENDIF\n"), IsEmpty())
        << "on some path it is left alone";
    EXPECT_THAT(refused_in("L\"SUB\"\nG912 Q1\n", "IF #g1==1\nTHEN\nG910\nG913\nENDIF\n"), ElementsAre(4))
        << "off on both";
    EXPECT_THAT(refused_in("L\"SUB\"\nG910\nG912 Q1\nG913\n", ""), IsEmpty()) << "an empty program";
}

/// So many subprograms that call the next one `calls` times; the last holds the block.
std::string chain(int programs, int calls, const std::string& last) {
    std::string text;
    for (int i = 0; i < programs; ++i) {
        text += "SUBPROGRAM \"S" + std::to_string(i) + "\"\n";
        for (int call = 0; call < calls && i + 1 < programs; ++call)
            text += "L\"S" + std::to_string(i + 1) + "\"\n";
        text += (i + 1 < programs ? "" : last) + "RETURN\n";
    }
    return text;
}

TEST(Switches, PassThroughChainsOfCalls) {
    const auto refused_in = [](const std::string& begin, const std::string& subs) {
        return din_lines("MAC527", head + "MACHINING\n" + begin + "L\"S0\"\nM30\n" + subs + "END\n").size();
    };
    EXPECT_EQ(refused_in("", chain(6, 1, "G912 Q1\n")), 1);
    EXPECT_EQ(refused_in("G910\n", chain(6, 1, "G912 Q1\n")), 0);
    EXPECT_EQ(refused_in("", chain(8, 40, "G912 Q1\n")), 1) << "each caller is asked once";
    EXPECT_EQ(refused_in("", chain(3000, 1, "G912 Q1\n")), 0) << "deeper than any control goes";
}

TEST(Switches, AreAllNamedByRows) {
    const ControlModel& control = *find_control("dinplus");
    std::set<std::string_view> named;
    for (const RuleRow& row : all_rule_rows())
        for (const RowForCode& one : row.rows) {
            named.insert(one.row->while_on);
            for_each_part(one.row->while_off, ',', [&](std::string_view name) { named.insert(name); });
        }
    named.erase("");
    std::set<std::string_view> there;
    for (const Switch& one : control.switches) {
        there.insert(one.name);
        EXPECT_FALSE(one.source.empty()) << one.name;
    }
    EXPECT_EQ(named, there);
}

TEST(Switches, ThatSlidesShareAreUnknownWhereSeveralRun) {
    EXPECT_THAT(
        din_lines("MAC527", "PROGRAM HEAD\n#SLIDE $1$2\nMACHINING\n$1 M14\n$2 G110 C0\n$1 M15\nM30\nEND\n"),
        IsEmpty());
    EXPECT_THAT(
        din_lines("MAC527", "PROGRAM HEAD\n#SLIDE $1$2\nMACHINING\n$1 G910\n$2 G912 Q1\n$1 G913\nM30\nEND\n"),
        ElementsAre(5))
        << "the probe of the other slide";
}

TEST(Switches, AreOffAtTheEnd) {
    EXPECT_THAT(left_on("G720 C0 S0 H1 Q1 F1\nM30\n"), ElementsAre(3));
    EXPECT_THAT(left_on("G720 C0 S0 H1 Q1 F1\nG720\nM30\n"), IsEmpty());
    EXPECT_THAT(left_on("G720 C0 S0 H1 Q1 F1\nG720 H0\nM30\n"), IsEmpty());
    EXPECT_THAT(left_on("G720 C0 S0 H1 Q1 F1\nL\"EXTERNAL\" V1\nM30\n"), IsEmpty()) << "it may end it";
}

TEST(Switches, AreOffAtTheNextTool) {
    EXPECT_THAT(left_on("G725 H1 Q0 R5 C0\nT2\nG725 H0 Q0\nM30\n"), ElementsAre(3));
    EXPECT_THAT(left_on("G725 H1 Q0 R5 C0\nG725 H0 Q0\nT2\nM30\n"), IsEmpty());
}

TEST(Switches, OfContoursLastToTheEndOfTheirSection) {
    const std::string rest = "MACHINING\nM30\nEND\n";
    EXPECT_THAT(din_lines("MAC586", "FINISHED\nN1 G0 X0 Z0\nN2 G95 F0.1\nN3 G1 Z-5\n" + rest),
                ElementsAre(3));
    EXPECT_THAT(din_lines("MAC586", "FINISHED\nN1 G0 X0 Z0\nN2 G95 F0.1\nN3 G1 Z-5\nN4 G95\n" + rest),
                IsEmpty());
}

TEST(Switches, AFeedIsNoTimeAndNoneOfAContour) {
    const auto lines = [](const std::string& blocks) {
        return din_lines("MAC527", "PROGRAM HEAD\nTURRET 1\nT4 ID\"A\"\n"
                                   "FINISHED\nN1 G0 X60 Z0\nN2 G1 Z-10\nN3 G95 F0.1\nN4 G1 Z-40\nN5 G95\n"
                                   "MACHINING\nN10 T4\nN11 G97 S800 M3\n" +
                                       blocks + "N15 M30\nEND\n");
    };
    EXPECT_THAT(lines("N12 G4 F2\nN13 G1 Z-5\n"), ElementsAre(14));
    EXPECT_THAT(lines("N12 G95 F0.2\nN13 G1 Z-5\n"), IsEmpty());
    EXPECT_THAT(lines("N12 F0.2\nN13 G1 Z-5\n"), IsEmpty());
}

TEST(Meetings, EndWhereAllSlidesCome) {
    const std::string head = "PROGRAM HEAD\n#SLIDE $1$2\nMACHINING\n";
    EXPECT_THAT(din_lines("DIN903", head + "$1$2 M97\n$1$2 M97\nM30\nEND\n"), IsEmpty());
    EXPECT_THAT(din_lines("DIN903", head + "$1 G62 Q2 H1\n$1 G162 H2\n$2 G162 H1\n$2 G62 Q1 H2\nM30\nEND\n"),
                IsEmpty());
    EXPECT_THAT(din_lines("DIN903", head + "$1 G62 Q2 H1\n$1 G162 H2\n$2 G62 Q1 H2\n$2 G162 H1\nM30\nEND\n"),
                ElementsAre(4));
    EXPECT_THAT(din_lines("DIN903", head + "$1 M97 Q12\nM30\nEND\n"), IsEmpty())
        << "the manual's own example";
    // Who has met goes on: the next meeting is another.
    EXPECT_THAT(din_lines("DIN903", head + "$1$2 M97\n$1 M97\n$2 G0 X50\n$1$2 M97\nM30\nEND\n"),
                ElementsAre(5));
    EXPECT_THAT(din_lines("DIN903", head + "$1 M97\n$2 WHILE #l1<3\n$2 #l1=#l1+1\n$2 ENDWHILE\nM30\nEND\n"),
                ElementsAre(4))
        << "a loop without meetings changes nothing";
    EXPECT_THAT(
        din_lines("DIN903", head + "$1 M97\n$2 WHILE #l1<3\n$2 M97\n$2 #l1=#l1+1\n$2 ENDWHILE\nM30\nEND\n"),
        IsEmpty());
    EXPECT_THAT(din_lines("DIN903", head + "$2 G62 Q1 H7 O1 X100\n$1$2 M97\nM30\nEND\n"), IsEmpty())
        << "a coordinate ends a wait, too";
    EXPECT_THAT(din_lines("DIN903", head + "$1 M97 Q-1\n$2 M97 Q1E20\nM30\nEND\n"), IsEmpty());
    EXPECT_THAT(din_lines("DIN903", head + "WHILE #g1<3\n$1 M97\nENDWHILE\nM30\nEND\n"), IsEmpty())
        << "a loop may change the order";
}

TEST(Results, AreAskedForBehindTheCycleAndNotInAComment) {
    const std::string probe = "MACHINING\nT5\nG770 R2 D0 K-8 AC50 BD0.2 O0\n";
    EXPECT_THAT(din_lines("DIN930", probe + "[#i99 is not read]\nM30\nEND\n"), ElementsAre(3));
    EXPECT_THAT(din_lines("DIN930", probe + "#l1=#I99\nM30\nEND\n"), IsEmpty());
    EXPECT_THAT(din_lines("DIN930", probe + "#l1=#i9\nM30\nEND\n"), ElementsAre(3));
    EXPECT_THAT(din_lines("DIN930", "MACHINING\nT5\n#l1=#i99\nG770 R2 D0 K-8 AC50 BD0.2 O0\nM30\nEND\n"),
                ElementsAre(4))
        << "read before";
    EXPECT_THAT(din_lines("DIN930", probe + "L\"ASKS\" V1\nM30\nEND\n"), IsEmpty()) << "it may ask";
}

} // namespace
} // namespace maclint::test
