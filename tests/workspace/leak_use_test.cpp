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

} // namespace
} // namespace maclint
