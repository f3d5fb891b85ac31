//! What becomes of a modal state that a program leaves behind is searched for in its callers, and the search
//! ends.
#include "analyzer/workspace/leak_use.hpp"
#include "tests/support/analysed.hpp"

#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace maclint {
namespace {

/// Whether somebody works under the distance mode that O1 leaves.
bool matters_in(const std::string& callers) {
    const auto workspace = test::analyse_fanuc(callers + "O1\nG91\nM99\n");
    const ProgramAnalysis& callee = workspace->programs().back();
    for (const dataflow::GroupChange& change : callee.summary().groups)
        return leak_use_of(callee, change.group).matters;
    throw std::runtime_error("O1 changes nothing");
}

TEST(LeakUse, AMoveBehindTheCallCounts) {
    EXPECT_TRUE(matters_in("O3\nG90\nM98P1\nG0X1.\nM30\n"));
    EXPECT_FALSE(matters_in("O3\nG90\nM98P1\nG90\nG0X1.\nM30\n"));
}

TEST(LeakUse, ACallerThatCallsItselfIsAskedOnce) {
    EXPECT_FALSE(matters_in("O3\nG90G0X1.\nM98P2\nG90G0X1.\nM30\n"
                            "O2\nM98P1\nIF[#500GT5]GOTO9\nGOTO8\nN9 M99\nN8 M98P2\n"));
}

/// The same for the distance mode, with O1 called once and this after the call.
bool matters_behind_call(const std::string& blocks) {
    return matters_in("O3\nG90\nM98P1\n" + blocks + "M30\n");
}

TEST(LeakUse, PlainBlocksMoveAndSetInTheirOrder) {
    EXPECT_TRUE(matters_behind_call("G40\nX1.\nG90\n"));
    EXPECT_FALSE(matters_behind_call("G40\nG90X1.\nX2.\n"));
    EXPECT_FALSE(matters_behind_call("G40\n"));
}

TEST(LeakUse, WordsThatComputeMoveAndSetToo) {
    EXPECT_TRUE(matters_behind_call("X#500\n"));
    EXPECT_FALSE(matters_behind_call("G90X#500\nX1.\n"));
    EXPECT_FALSE(matters_behind_call("G#500\nX1.\n")); // it may be the word that sets it
    EXPECT_TRUE(matters_behind_call("M#500\nX1.\n"));  // of other letters none is
}

TEST(LeakUse, EveryBranchBehindTheCallIsLookedAt) {
    EXPECT_TRUE(matters_behind_call("IF[#500EQ1]GOTO5\nG90\nN5X1.\n"));
    EXPECT_FALSE(matters_behind_call("IF[#500EQ1]GOTO5\nG90\nGOTO6\nN5G90\nN6X1.\n"));
    EXPECT_FALSE(matters_behind_call("GOTO6\nX1.\nN6G90\nX2.\n")); // which no path reaches
}

TEST(LeakUse, ProgramsCalledBehindTheCallMoveOrSet) {
    const std::string caller = "O3\nG90\nM98P1\nM98P2\nX1.\nM30\n";
    EXPECT_TRUE(matters_in(caller + "O2\nX5.\nG90\nM99\n"));
    EXPECT_FALSE(matters_in(caller + "O2\nG90\nX5.\nM99\n"));
    EXPECT_TRUE(matters_in(caller + "O2\nG40\nM99\n"));
    EXPECT_FALSE(matters_behind_call("M98P77\nX1.\n")); // of an unknown program nothing is claimed
}

TEST(LeakUse, TheCallersOfTheCallerAreAskedWhenItReturns) {
    const std::string between = "O2\nM98P1\nM99\n";
    EXPECT_TRUE(matters_in("O3\nG90\nM98P2\nX1.\nM30\n" + between));
    EXPECT_FALSE(matters_in("O3\nG90\nM98P2\nG90\nX1.\nM30\n" + between));
    EXPECT_TRUE(matters_in("O3\nG90\nM98P2\nG90\nM30\nO4\nM98P2\nX1.\nM30\n" + between));
    EXPECT_TRUE(matters_in(between)); // it is unknown who calls O2
}

/// Whether somebody works under the feed that O1 leaves.
bool feed_matters(const std::string& blocks) {
    const auto workspace = test::analyse_fanuc("O3\nG0F9\nM98P1\n" + blocks + "M30\nO1\nF100\nM99\n");
    const ProgramAnalysis& callee = workspace->programs().back();
    return leak_use_of(callee, *callee.control().group_with(ModalRole::feed)).matters;
}

TEST(LeakUse, AFeedMattersToMovesThatHaveOne) {
    EXPECT_TRUE(feed_matters("G1X1.\n"));
    EXPECT_FALSE(feed_matters("G0X1.\n"));
    EXPECT_TRUE(feed_matters("G0X1.\nG1X2.\n"));
    EXPECT_FALSE(feed_matters("G0X1.\nG1F50X2.\n"));
    EXPECT_TRUE(feed_matters("G0X#500\nG1X#500\n"));
    EXPECT_FALSE(feed_matters("G28X#500\n")); // at rapid traverse
}

} // namespace
} // namespace maclint
