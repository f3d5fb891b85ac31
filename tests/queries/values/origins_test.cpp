//! An origin stands for a place of the program, whatever it is an origin of.
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/values/origins.hpp"
#include "tests/support/analysed.hpp"

#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

/// The one thing that the distance mode can be at the program's only exit.
dataflow::ModalPart mode_at_exit(const ProgramAnalysis& analysis) {
    const auto group = analysis.control().group_with(ModalRole::distance);
    const auto exits = analysis.facts().all<dataflow::ExitState>();
    EXPECT_EQ(exits.size(), 1U);
    const dataflow::ModalValue value = analysis.data().modal(exits.front(), group.value());
    EXPECT_EQ(value.parts.end() - value.parts.begin(), 1);
    return value.parts.front();
}

TEST(Origins, OfAnEffectStandWhereItStands) {
    const auto workspace = test::analyse_fanuc("O9001\n#1=5\nG91 Z#1\nM99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const dataflow::OriginId origin = mode_at_exit(analysis).origin;
    const auto effect = effect_of_origin(analysis, origin);
    ASSERT_TRUE(effect);
    EXPECT_EQ(test::line_of_effect(analysis, *effect), 3U);
    EXPECT_EQ(test::text_of(analysis, span_of_origin(analysis, origin)), "G91");
    EXPECT_EQ(analysis.graph().node_of(*effect), node_of_origin(analysis, origin));
    EXPECT_FALSE(is_plain_origin(analysis, origin));
    EXPECT_FALSE(is_made_by_call(analysis, origin));
}

TEST(Origins, OfARunAreTheLastBlockThatSetsTheGroup) {
    const auto workspace = test::analyse_fanuc("O9001\nG90\nG91 Z1.\nX1.\nM99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const dataflow::OriginId origin = mode_at_exit(analysis).origin;
    EXPECT_TRUE(is_plain_origin(analysis, origin));
    EXPECT_FALSE(effect_of_origin(analysis, origin));
    EXPECT_EQ(test::line_of(analysis, span_of_origin(analysis, origin).begin), 3U);
}

TEST(Origins, OfWhatWasSoAtTheStartAreTheProgramsName) {
    const auto workspace = test::analyse_fanuc("O9001\n#2=1\nG0 X#1\nM99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const dataflow::OriginId origin = test::last_read(analysis).vacancy_origin;
    EXPECT_EQ(variable_of_origin(analysis, origin), (Variable{0, 1}));
    EXPECT_EQ(node_of_origin(analysis, origin), 0U);
    EXPECT_EQ(test::text_of(analysis, span_of_origin(analysis, origin)), "O9001");
    EXPECT_FALSE(effect_of_origin(analysis, origin));
}

TEST(Origins, OfWhatACalledProgramLeavesAreItsCall) {
    const auto workspace = test::analyse_fanuc("O1\nG90\nM98P2\nM30\nO2\nG91\nM99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    EXPECT_TRUE(is_made_by_call(analysis, mode_at_exit(analysis).origin));
}

} // namespace
} // namespace maclint::queries
