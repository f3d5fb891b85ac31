//! Which program a call means: the nearest one of its name, seen from the file of the call.
#include "analyzer/dialect/fanuc/tables.hpp"
#include "tests/support/analysed.hpp"
#include "tests/support/lines.hpp"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace maclint {
namespace {

constexpr test::FolderOptions open_workspace{.complete = false, .jobs = 1};

struct Meant {
    std::string program; ///< "SUB in a/SUB.ncs"; empty: unknown
    std::size_t candidates;
    friend bool operator==(const Meant&, const Meant&) = default;
    friend void PrintTo(const Meant& meant, std::ostream* out) {
        *out << "'" << meant.program << "' of " << meant.candidates;
    }
};

/// What the first call in the first of the files means.
Meant meant(const std::vector<test::NamedText>& files) {
    const auto workspace = test::analyse_files(files, open_workspace);
    const auto& calls = workspace->programs().front().calls();
    if (calls.empty()) throw std::runtime_error("no call");
    const CallSite& site = calls.front();
    if (!site.target) return {"", site.candidates};
    const ProgramAnalysis& called = workspace->programs()[*site.target];
    return {called.program().name + " in " + called.file().source->path(), site.candidates};
}

TEST(Resolve, FoldersOfTheControlAreFoldersOfTheFile) {
    const std::string mtb = "&F=/MTB/\nO1\nM98P2\nM30\nO2\nM99\n";
    const std::string user = "&F=/USER/\nO2\nG0X1.\nM99\n";
    EXPECT_EQ(meant({{"a.nc", mtb + user}}), (Meant{"O2 in a.nc", 2}));
    // Without folder of its own it lies around both, and they are equally near.
    EXPECT_EQ(meant({{"a.nc", "O1\nM98P2\nM30\n&F=/MTB/\nO2\nM99\n" + user}}), (Meant{"", 2}));
    EXPECT_EQ(meant({{"a.nc", mtb + "&F=\nO2\nM99\n"}, {"b.nc", "O2\nM99\n"}}), (Meant{"O2 in a.nc", 3}));
}

TEST(Resolve, TwoProgramsOfOneNumberInAFileMeanUnknown) {
    EXPECT_EQ(meant({{"a.nc", "O1\nM98P2\nM30\nO2\nM99\nO2\nG0X1.\nM99\n"}}), (Meant{"", 2}));
    EXPECT_EQ(meant({{"a.nc", "O1\nM98P2\nM30\nO2\nM99\n"}, {"b.nc", "O2\nM99\n"}}),
              (Meant{"O2 in a.nc", 2}));
    EXPECT_EQ(meant({{"a.nc", "O1\nM98P2\nM30\n"}, {"b.nc", "O3\nM99\n"}}), (Meant{"", 0}));
}

TEST(Resolve, ANumberIsANumberHoweverItIsWritten) {
    EXPECT_EQ(meant({{"a.nc", "O1\nM98P0020\nM30\nO0020\nM99\n"}}).candidates, 1U);
    EXPECT_EQ(meant({{"a.nc", "O1\nM98P20\nM30\nO0020\nM99\n"}}).candidates, 1U);
    EXPECT_EQ(meant({{"a.nc", "O1\nM98P[10+10]\nM30\nO20\nM99\n"}}), (Meant{"", 0})); // computed
}

const std::string fragment = "MACHINING\nRETURN\n"; ///< in a file that is not started by hand

TEST(Resolve, WhatIsStartedByHandIsCalledWhereNothingElseIsAsNear) {
    const test::NamedText main{"a/main.nc", "MACHINING\nL\"SUB\" V1\nM30\n"};
    EXPECT_EQ(meant({main, {"a/SUB.nc", fragment}, {"a/SUB.ncs", fragment}}), (Meant{"SUB in a/SUB.ncs", 2}));
    EXPECT_EQ(meant({main, {"a/SUB.nc", fragment}}), (Meant{"SUB in a/SUB.nc", 1}));
    EXPECT_EQ(meant({main, {"a/SUB.nc", fragment}, {"b/SUB.ncs", fragment}}), (Meant{"SUB in a/SUB.nc", 2}));
}

TEST(Resolve, ALocalSubprogramComesFirstUnlessTheCallAsksForAFile) {
    const std::string local = "SUBPROGRAM \"SUB\"\nRETURN\n";
    const auto calling = [&](const std::string& how) {
        return test::NamedText{"main.nc", "MACHINING\nL\"SUB\"" + how + "\nM30\n" + local};
    };
    EXPECT_EQ(meant({calling("")}), (Meant{"SUB in main.nc", 1}));
    EXPECT_EQ(meant({calling(""), {"SUB.ncs", fragment}}), (Meant{"SUB in main.nc", 2}));
    EXPECT_EQ(meant({calling(" V1"), {"SUB.ncs", fragment}}), (Meant{"SUB in SUB.ncs", 2}));
    EXPECT_EQ(meant({calling(" V1"), {"a/SUB.ncs", fragment}}), (Meant{"SUB in a/SUB.ncs", 2}));
    EXPECT_EQ(meant({calling(" V1")}), (Meant{"SUB in main.nc", 1}));
}

TEST(Resolve, ASubprogramOfAnotherFileIsNoCandidate) {
    const std::string local = "SUBPROGRAM \"SUB\"\nRETURN\n";
    EXPECT_EQ(meant({{"main.nc", "MACHINING\nL\"SUB\"\nM30\n"}, {"other.nc", "MACHINING\nM30\n" + local}}),
              (Meant{"", 0}));
    EXPECT_EQ(
        meant({{"main.nc", "MACHINING\nL\"SUB\"\nM30\n" + local}, {"other.nc", "MACHINING\nM30\n" + local}}),
        (Meant{"SUB in main.nc", 1}));
}

TEST(Resolve, ASubprogramMayHaveTheNameOfItsFile) {
    EXPECT_EQ(meant({{"MAIN.nc", "MACHINING\nL\"MAIN\"\nM30\nSUBPROGRAM \"MAIN\"\nRETURN\n"}}),
              (Meant{"MAIN in MAIN.nc", 2}));
    const auto workspace = test::analyse_files(
        {{"MAIN.nc", "MACHINING\nL\"MAIN\"\nM30\nSUBPROGRAM \"MAIN\"\nRETURN\n"}}, open_workspace);
    EXPECT_FALSE(workspace->programs()[0].is_recursive()); // what is started by hand is not meant
    EXPECT_EQ(workspace->programs()[1].callers().size(), 1U);
}

TEST(Resolve, UnknownCallsKnowTheirCandidates) {
    const auto workspace = test::analyse_files({{"main.nc", "O1\nM98P2\nM98P2\nM30\n"},
                                                {"a/sub.nc", "O2\nM99\n"},
                                                {"b/sub.nc", "O2\nM99\n"},
                                                {"b/c/sub.nc", "O2\nM99\n"}},
                                               open_workspace);
    const auto callers_of = [&](std::string_view path) {
        for (const ProgramAnalysis& analysis : workspace->programs())
            if (analysis.file().source->path() == path) return analysis.possible_callers().first.size();
        throw std::runtime_error("no such file");
    };
    EXPECT_EQ(callers_of("a/sub.nc"), 2U);
    EXPECT_EQ(callers_of("b/sub.nc"), 2U);
    EXPECT_EQ(callers_of("b/c/sub.nc"), 0U); // two others are nearer
    EXPECT_EQ(callers_of("main.nc"), 0U);
    const ProgramAnalysis& main = workspace->programs().front();
    EXPECT_EQ(main.calls().front().candidates, 3U);
}

TEST(Resolve, OfManyUnknownCallsTheFirstHundredAreKnown) {
    const auto callers = [](std::size_t calls) {
        const auto workspace =
            test::analyse_files({{"a/sub.nc", "O2\nM99\n"},
                                 {"b/sub.nc", "O2\nM99\n"},
                                 {"main.nc", "O1\n" + test::copies_of("M98P2\n", calls) + "M30\n"}},
                                open_workspace);
        return workspace->programs().front().possible_callers();
    };
    EXPECT_EQ(callers(99).first.size(), 99U);
    EXPECT_TRUE(callers(100).all);
    EXPECT_EQ(callers(101).first.size(), 100U);
    EXPECT_FALSE(callers(101).all);
}

TEST(Resolve, WhatSomeUnknownCallPassesMayBeThere) {
    const auto workspace = test::analyse_files({{"main.nc", "O1\nG65P2B1.A1.\nG65P2A2.\nM30\n"},
                                                {"a/sub.nc", "O2\nM99\n"},
                                                {"b/sub.nc", "O2\nM99\n"}},
                                               {.complete = true, .jobs = 1});
    const dataflow::Analysis& sub = workspace->programs()[1].data();
    const auto local = [](std::int32_t number) { return Variable{fanuc::spaces::local, number}; };
    EXPECT_FALSE(sub.is_vacant_at_entry(local(1)));
    EXPECT_FALSE(sub.is_vacant_at_entry(local(2)));
    EXPECT_TRUE(sub.is_vacant_at_entry(local(10)));
}

} // namespace
} // namespace maclint
