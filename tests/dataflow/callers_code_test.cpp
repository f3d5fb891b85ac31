//! The modal codes that a program finds in force when it is called: unknown until it asks.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/program/tables.hpp"
#include "tests/dataflow/expect.hpp"
#include "tests/support/analysed.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace maclint {
namespace {

using dataflow::expect_truth;
using dataflow::Truth;

/// How the last comparison of a macro with unknown callers turns out.
Truth last_comparison(const std::string& text) {
    const auto workspace = test::analyse_fanuc("O9001\n" + text + "N8M99\nN9M99\n");
    return workspace->programs().front().facts().all<dataflow::Comparison>().back().truth;
}

TEST(CallersCode, IsKnownWhereTheProgramHasAskedForIt) {
    expect_truth(last_comparison("IF[#4003EQ90]GOTO9\n"), true, true);
    expect_truth(last_comparison("IF[#4003NE90]GOTO9\nIF[#4003EQ90]GOTO9\n"), true, false);
    expect_truth(last_comparison("IF[90NE#4003]GOTO9\nIF[#4003EQ90]GOTO9\n"), true, false);
}

TEST(CallersCode, OfAGroupOfTwoThatIsNotTheOneIsTheOther) {
    expect_truth(last_comparison("IF[#4003EQ90]GOTO9\nIF[#4003EQ91]GOTO9\n"), true, false);
    expect_truth(last_comparison("IF[#4003EQ91]GOTO9\nIF[#4003EQ90]GOTO9\n"), true, false);
    expect_truth(last_comparison("IF[#4003EQ55]GOTO9\nIF[#4003EQ90]GOTO9\n"), true, true); // no member
    expect_truth(last_comparison("IF[#4001EQ0]GOTO9\nIF[#4001EQ1]GOTO9\n"), true, true);   // more members
}

TEST(CallersCode, IsKnownFromASavedCopyToo) {
    expect_truth(last_comparison("#1=#4003\nIF[#1EQ90]GOTO9\nIF[#4003EQ91]GOTO9\n"), true, false);
    expect_truth(last_comparison("#1=#4003\nIF[#1NE90]GOTO9\nIF[#4003EQ90]GOTO9\n"), true, false);
    expect_truth(last_comparison("#1=#4003\nIF[#1NE90]GOTO9\nIF[#1EQ#4003]GOTO9\n"), true, false);
    expect_truth(last_comparison("#1=#4003\nIF[#1GT90]GOTO9\nIF[#4003EQ90]GOTO9\n"), true, true);
}

TEST(CallersCode, IsTheSavedOneWhetherItWasPutBackOrNeverChanged) {
    // Put back where it is known to be 90, and not touched where it is not.
    expect_truth(last_comparison("#1=#4003\nIF[#4003NE90]GOTO1\nG91\nG90\nN1IF[#4003EQ#1]GOTO9\n"), true,
                 false);
    expect_truth(last_comparison("#1=#4003\nIF[#500EQ1]GOTO1\nG90\nIF[#1NE90]GOTO9\nN1IF[#4003EQ#1]GOTO9\n"),
                 true, false);
    expect_truth(last_comparison("#1=#4003\nIF[#500EQ1]GOTO1\nG90\nN1IF[#4003EQ#1]GOTO9\n"), true, true);
}

/// Whether the group is the caller's at every end of the program.
bool puts_back(const std::string& text) {
    const auto workspace = test::analyse_fanuc("O9001\n" + text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    const GroupId group = *analysis.control().group_with(ModalRole::distance);
    const auto& exits = analysis.facts().all<dataflow::ExitState>();
    return !exits.empty() && std::ranges::all_of(exits, [&](const dataflow::ExitState& exit) {
        const auto value = analysis.data().modal(exit, group);
        return !value.unknown && std::ranges::all_of(value.parts, [&](const dataflow::ModalPart& part) {
            return analysis.data().table().entry_group_of(part.symbol) == group;
        });
    });
}

TEST(CallersCode, IsPutBackBySavingItOrByAskingForIt) {
    EXPECT_TRUE(puts_back("#1=#4003\nG91\nG#1\nM99\n"));
    EXPECT_TRUE(puts_back("#1=#4003\nG91\nIF[#1NE90]GOTO1\nG#1\nN1M99\n"));
    EXPECT_TRUE(puts_back("IF[#4003EQ90]GOTO1\nG90\nG91\nM99\nN1G91\nG90\nM99\n"));
    EXPECT_FALSE(puts_back("IF[#4003EQ90]GOTO1\nG90\nG91\nM99\nN1G90\nG91\nM99\n"));
    EXPECT_FALSE(puts_back("G91\nM99\n"));
}

TEST(CallersCode, ThatTheProgramHasSetBeforeItAskedIsTheCallersToo) {
    // G90 is set; after the question it is known that this is what the caller had.
    EXPECT_TRUE(puts_back("#1=#4003\nG90\nIF[#1NE90]GOTO1\nM99\nN1G91\nM99\n"));
    EXPECT_FALSE(puts_back("#1=#4003\nG90\nIF[#1NE90]GOTO1\nM99\nN1M99\n"));
    EXPECT_FALSE(puts_back("#1=#4003\nG90\nIF[#1EQ90]GOTO1\nM99\nN1M99\n"));
}

} // namespace
} // namespace maclint
