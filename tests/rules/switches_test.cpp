//! What programs switch on and off, along their paths and through calls, and what is said of it.
#include "tests/rules/din_findings.hpp"

#include <string>

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
    EXPECT_THAT(refused_in("L\"SUB\"\nG910\nG912 Q1\nG913\n", ""), IsEmpty()) << "an empty program";
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

TEST(Meetings, EndWhereAllSlidesCome) {
    const std::string head = "PROGRAM HEAD\n#SLIDE $1$2\nMACHINING\n";
    EXPECT_THAT(din_lines("DIN903", head + "$1$2 M97\n$1$2 M97\nM30\nEND\n"), IsEmpty());
    EXPECT_THAT(din_lines("DIN903", head + "$1 G62 Q2 H1\n$1 G162 H2\n$2 G162 H1\n$2 G62 Q1 H2\nM30\nEND\n"),
                IsEmpty());
    EXPECT_THAT(din_lines("DIN903", head + "$1 G62 Q2 H1\n$1 G162 H2\n$2 G62 Q1 H2\n$2 G162 H1\nM30\nEND\n"),
                ElementsAre(4));
    EXPECT_THAT(din_lines("DIN903", head + "$1 M97 Q12\nM30\nEND\n"), IsEmpty())
        << "the manual's own example";
    EXPECT_THAT(din_lines("DIN903", head + "WHILE #g1<3\n$1 M97\nENDWHILE\nM30\nEND\n"), IsEmpty())
        << "a loop may change the order";
}

} // namespace
} // namespace maclint::test
