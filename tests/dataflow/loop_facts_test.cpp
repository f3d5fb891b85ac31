//! What loops tell: counters, what calls change, which ways make sense.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/loops/loop_counter.hpp"
#include "tests/support/analysed.hpp"

#include <gtest/gtest.h>

namespace maclint {
namespace {

std::optional<queries::Counter> counter(const ProgramAnalysis& analysis) {
    return queries::counter_of(analysis, analysis.loops().front());
}

TEST(LoopCounter, IsTheVariableThatAllWaysOutDependOn) {
    const auto workspace =
        test::analyse_fanuc("O9001\n#33=0\nWHILE[#33LT#1]DO1\n#33=#33+#6\nIF[#33EQ#2]GOTO9\n"
                            "IF[#33GT#1]THEN#33=#1\nEND1\nN9 M99\n");
    const auto found = counter(workspace->programs().front());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->variable.number, 33);
    EXPECT_EQ(found->tests.size(), 2U);
    EXPECT_EQ(found->steps.size(), 1U);
    EXPECT_EQ(found->clamps.size(), 1U);
    EXPECT_EQ(found->tests.front().stays, Operation::less);
    EXPECT_EQ(found->tests.back().stays, Operation::not_equal);
}

TEST(LoopCounter, OnTheRightOrNegatedIsReadFromItsOwnSide) {
    const auto workspace = test::analyse_fanuc("O9001\n#33=0\nWHILE[#1GT-#33]DO1\n#33=#33+1\nEND1\nM99\n");
    const auto found = counter(workspace->programs().front());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->tests.front().stays, Operation::greater);
}

TEST(LoopCounter, IsNoneWhenTheBoundMovesToo) {
    const auto workspace =
        test::analyse_fanuc("O9001\n#33=0\nWHILE[#33LT#1]DO1\n#33=#33+1\n#1=#1-1\nEND1\nM99\n");
    EXPECT_FALSE(counter(workspace->programs().front()));
}

TEST(LoopCounter, IsNoneWhenACallCanChangeIt) {
    const auto workspace = test::analyse_fanuc(
        "O9001\n#100=0\nWHILE[#100LT9]DO1\n#100=#100+1\nG65P9002\nEND1\nM99\nO9002\n#100=0\nM99\n");
    EXPECT_FALSE(counter(workspace->programs().front()));
}

TEST(Summary, SaysWhetherAProgramMayStop) {
    const auto workspace =
        test::analyse_fanuc("O9001\nG65P9002\nM99\nO9002\n#100=1\nM99\nO9003\nG65P9004\nM99\n"
                            "O9004\nIF[#1EQ#0]THEN#3000=1(A MISSING)\nM99\n");
    const auto& programs = workspace->programs();
    EXPECT_FALSE(programs[0].summary().may_stop);
    EXPECT_FALSE(programs[1].summary().may_stop);
    EXPECT_TRUE(programs[2].summary().may_stop);
    EXPECT_TRUE(programs[3].summary().may_stop);
}

TEST(Entry, LocalsOfASubprogramAreItsCallers) {
    const auto workspace = test::analyse_fanuc("O1\n#10=1\nM98P2\nM30\nO2\nG0X#10Y#11\nM99\n");
    const auto& reads = workspace->programs()[1].facts().all<dataflow::Read>();
    ASSERT_EQ(reads.size(), 2U);
    EXPECT_EQ(reads[0].value.vacancy, dataflow::Vacancy::unknown);
    EXPECT_EQ(reads[1].value.vacancy, dataflow::Vacancy::maybe); // another caller may set it
}

TEST(Entry, ArgumentsMayBeMissingAndOtherLocalsAreVacant) {
    const auto workspace = test::analyse_fanuc("O9001\nG0X#24Y#10\nM99\n");
    const auto& reads = workspace->programs().front().facts().all<dataflow::Read>();
    ASSERT_EQ(reads.size(), 2U);
    EXPECT_EQ(reads[0].value.vacancy, dataflow::Vacancy::maybe);
    EXPECT_EQ(reads[1].value.vacancy, dataflow::Vacancy::vacant);
}

TEST(EvaluateWords, ThatPassNotZeroMayBeVacantAndCountAsZero) {
    const auto workspace = test::analyse_fanuc("O1\nIF[#501EQ1]GOTO10\n#1=ROUND[ABS[#5003]]\n"
                                               "N10IF[#1NE0]GOTO20\nM30\nN20IF[#1LT1]GOTO30\nM30\n"
                                               "N30M30\n");
    EXPECT_TRUE(workspace->programs().front().facts().all<dataflow::Comparison>().back().truth.can_hold);
}

TEST(EvaluateWords, ThatAModalCallLeavesDifferFromMoveToMoveAndComeFromTheCall) {
    const auto workspace = test::analyse_fanuc("O1\nG66P9010A1.\n#501=7\nX1.Y2.\n#1=#100\nX3.\n#2=#100\n"
                                               "G67\nM30\nO9010\nIF[#501EQ0]GOTO5\n#100=#0\nM99\n"
                                               "N5#100=#1\nM99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto& stores = analysis.facts().all<dataflow::Store>();
    ASSERT_EQ(stores.size(), 3U);
    EXPECT_NE(stores[1].value.symbol, stores[2].value.symbol);
    const dataflow::Origin& origin = analysis.data().origin(stores[1].value.vacancy_origin);
    ASSERT_EQ(origin.kind, dataflow::Origin::Kind::effect);
    EXPECT_TRUE(std::holds_alternative<Call>(analysis.program().effects[origin.id].what));
}

TEST(Loops, HoldNothingThatTheirHeadDoesNotReach) {
    // GOTO20 leads into the middle of the loop; #501 above it decides nothing in it.
    const auto workspace = test::analyse_fanuc("O1\nIF[#501EQ1]GOTO20\n#501=#501+1\nN10G0X1.\nN20G0X2.\n"
                                               "IF[#502EQ1]GOTO10\nM30\n");
    const auto& loops = workspace->programs().front().loops();
    ASSERT_EQ(loops.size(), 1U);
    EXPECT_EQ(loops.front().body.size(), 4U); // IF and its GOTO are a node each
    EXPECT_EQ(loops.front().exit_edges.size(), 1U);
}

TEST(Solver, EndsInALoopThatIsEnteredInItsMiddle) {
    // N10 is reached by the jump back alone; #100 has no bound.
    const auto workspace = test::analyse_fanuc("O1\n#100=0\nGOTO20\nN10G0X1.\nN20#100=#100+1\n"
                                               "IF[#100LT#500]GOTO10\nM30\n");
    const auto& loops = workspace->programs().front().loops();
    ASSERT_EQ(loops.size(), 1U);
    const auto found = counter(workspace->programs().front());
    ASSERT_TRUE(found);
    EXPECT_EQ(found->variable.number, 100);
}

TEST(EvaluateWords, OfSumsAreTheSameInEitherOrder) {
    const auto workspace = test::analyse_fanuc("O9001\n#31=#1+#2\n#32=#2+#1\n#33=#1-#2\nM99\n");
    const auto& stores = workspace->programs().front().facts().all<dataflow::Store>();
    ASSERT_EQ(stores.size(), 3U);
    EXPECT_EQ(stores[0].value.symbol, stores[1].value.symbol);
    EXPECT_NE(stores[0].value.symbol, stores[2].value.symbol);
}

} // namespace
} // namespace maclint
