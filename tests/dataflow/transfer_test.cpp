//! What single blocks change: steps of a counter, stores through an index, calls of known programs, codes.
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "tests/support/analysed.hpp"

#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using dataflow::Exactness;
using dataflow::Step;
using dataflow::Vacancy;
using dataflow::Value;

/// How the store in #1 changes it, when it is a step.
std::optional<Step> step_in(const std::string& block) {
    const auto workspace = test::analyse_fanuc("O0001\n#1=3\n#2=4\n" + block + "\nM30\n");
    return workspace->programs().front().facts().all<dataflow::Store>()[2].step;
}

TEST(Steps, AreOfAVariableByAnAmount) {
    for (const std::string block : {"#1=#1+5", "#1=5+#1"}) {
        const auto step = step_in(block);
        ASSERT_TRUE(step) << block;
        EXPECT_EQ(step->operation, Operation::add) << block;
        EXPECT_EQ(step->amount.constant(), 5) << block;
    }
    const auto back = step_in("#1=#1-#2");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->operation, Operation::subtract);
    EXPECT_EQ(back->amount.constant(), 4);
}

TEST(Steps, AreNotOfOtherVariablesOrOperations) {
    for (const std::string block : {"#1=#2+5", "#1=5+#2", "#1=5-#1", "#1=#1*2", "#1=#2-#1", "#1=5"})
        EXPECT_FALSE(step_in(block)) << block;
}

/// What the last word reads in the first program.
Value last_read_of_first(const std::string& text) {
    const auto workspace = test::analyse_files({{"O0001.nc", text}}, {.complete = true, .jobs = 1});
    return workspace->programs().front().facts().all<dataflow::Read>().back().value;
}
Value after_call_of(const std::string& called) {
    return last_read_of_first("O0001\n#100=9\nG65P2A3\nX#100\nM30\nO0002\n" + called + "\nM99\n");
}

TEST(CallsOfKnownPrograms, LeaveWhatTheyStore) {
    const Value one = after_call_of("#100=5");
    EXPECT_EQ(one.constant(), 5);
    EXPECT_EQ(one.vacancy, Vacancy::set);
    EXPECT_EQ(one.exactness, Exactness::exact);
    EXPECT_TRUE(one.integer);
    EXPECT_FALSE(after_call_of("IF[#1EQ3]GOTO5\n#100=2\nN5").constant());
    EXPECT_EQ(after_call_of("#101=5").constant(), 9);
}

TEST(CallsOfKnownPrograms, MayLeaveAVariableVacant) {
    EXPECT_EQ(after_call_of("#100=#0").vacancy, Vacancy::vacant);
    const Value either = after_call_of("IF[#501EQ3]GOTO5\n#100=#0\nN5");
    EXPECT_EQ(either.vacancy, Vacancy::maybe);
    EXPECT_NE(either.vacancy_origin, 0U);
}

TEST(CallsOfKnownPrograms, RoundElsewhere) {
    // Where it was rounded is in the other program, so nothing is said of it here.
    const Value rounded = after_call_of("#100=1/3");
    EXPECT_EQ(rounded.exactness, Exactness::unknown);
    EXPECT_EQ(rounded.rounding, 0U);
    EXPECT_FALSE(rounded.integer);
}

TEST(CallsOfKnownPrograms, HaveTheirOwnLocalsUnlessTheyAreSubprograms) {
    const std::string sub = "X#1\nM30\nO0002\n#1=5\nM99\n";
    EXPECT_EQ(last_read_of_first("O0001\n#1=9\nG65P2\n" + sub).constant(), 9);
    EXPECT_EQ(last_read_of_first("O0001\n#1=9\nM98P2\n" + sub).constant(), 5);
}

TEST(CallsOfKnownPrograms, GiveTwoVariablesTwoValues) {
    const auto workspace = test::analyse_files(
        {{"O0001.nc",
          "O0001\nG65P2A#500\n#1=#100\n#2=#101\n#3=#100\nM30\nO0002\n#100=#1\n#101=#5003\nM99\n"}},
        {.complete = true, .jobs = 1});
    const auto& stores = workspace->programs().front().facts().all<dataflow::Store>();
    ASSERT_EQ(stores.size(), 3U);
    EXPECT_NE(stores[0].value.symbol, stores[1].value.symbol);
    EXPECT_EQ(stores[0].value.symbol, stores[2].value.symbol);
}

TEST(StoresThroughAnIndex, ReachTheVariablesThatTheIndexCanMeanAndNoOthers) {
    const auto after = [](const std::string& read) {
        return last_read_of_first(
                   "O0001\n#5=5\n#7=7\n#9=9\n#150=3\n#1=6\nIF[#500EQ1]GOTO1\n#1=8\nN1#[#1]=2\nX" + read +
                   "\nM30\n")
            .constant();
    };
    EXPECT_EQ(after("#5"), 5);
    EXPECT_FALSE(after("#7"));
    EXPECT_EQ(after("#9"), 9);
    EXPECT_EQ(after("#150"), 3);
    EXPECT_EQ(last_read_of_first("O0001\n#1=5\n#[#1]=2\nX#5\nM30\n").constant(), 2);
    EXPECT_EQ(last_read_of_first("O0001\n#1=5\n#[#1+1]=2\n#6=#6+1\nX#6\nM30\n").constant(), 3);
}

// ---- codes

struct AtEnd {
    std::vector<double> codes; ///< that the group can have at the program's end, and is known to
    bool unknown;              ///< or any other
};

/// Of the first program; the others can be called.
AtEnd at_end(const std::string& text, ModalRole role, const std::string& others = "") {
    const auto workspace = test::analyse_fanuc("O0001\n" + text + "M30\n" + others);
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto value = analysis.data().modal(analysis.facts().all<dataflow::ExitState>()[0],
                                             *analysis.control().group_with(role));
    AtEnd found{{}, value.unknown};
    for (const dataflow::ModalPart& part : value.parts)
        if (const auto code = analysis.data().table().number_of(part.symbol)) found.codes.push_back(*code);
    return found;
}

TEST(Codes, FromAVariableAreKnownWhereItsNumberIs) {
    const AtEnd found = at_end("G91\n#1=90\nG#1\n", ModalRole::distance);
    EXPECT_THAT(found.codes, testing::ElementsAre(90));
    EXPECT_FALSE(found.unknown);
    EXPECT_THAT(at_end("G91\n#1=40\nG#1\n", ModalRole::distance).codes, testing::ElementsAre(91));
    EXPECT_THAT(at_end("G90\nIF[#500EQ1]GOTO1\nG91\nN1\n", ModalRole::distance).codes,
                testing::UnorderedElementsAre(90, 91));
}

TEST(Codes, AreSetByASystemVariableHoweverItIsNamed) {
    for (const std::string block : {"#3003=1\n", "#[3003]=1\n", "#1=3000\n#[#1+3]=1\n"}) {
        const AtEnd found = at_end(block, ModalRole::single_block);
        EXPECT_THAT(found.codes, testing::ElementsAre(1)) << block;
        EXPECT_FALSE(found.unknown) << block;
    }
    EXPECT_THAT(at_end("#3003=1\n#3003=0\n", ModalRole::single_block).codes, testing::ElementsAre(0));
    EXPECT_THAT(at_end("#3003=1\n", ModalRole::feed_hold).codes,
                testing::IsEmpty()); // kept until the power is off
}

TEST(Codes, OfAnUnknownNumberMayBeOfAnyGroupOfTheirLetter) {
    EXPECT_TRUE(at_end("G90\nG40\nG#500\n", ModalRole::distance).unknown);
    EXPECT_TRUE(at_end("G90\nG40\nG#500\n", ModalRole::cutter_compensation).unknown);
    EXPECT_FALSE(at_end("G90\nF100\nG#500\n", ModalRole::feed).unknown);
    EXPECT_FALSE(at_end("G90\nG#0\n", ModalRole::distance).unknown); // a vacant word is ignored
}

TEST(Codes, AreThoseThatACalledProgramLeaves) {
    const auto after = [](const std::string& called) {
        return at_end("G90\nG65P2\n", ModalRole::distance, "O0002\n" + called + "M99\n");
    };
    EXPECT_THAT(after("G91\n").codes, testing::ElementsAre(91));
    EXPECT_FALSE(after("G91\n").unknown);
    EXPECT_THAT(after("IF[#500EQ1]THENG91\n").codes, testing::UnorderedElementsAre(90, 91));
    EXPECT_THAT(after("#1=#4003\nG91\nG#1\n").codes, testing::ElementsAre(90));
    EXPECT_TRUE(after("G#500\n").unknown);
    const AtEnd feed = at_end("F100\nG65P2\n", ModalRole::feed, "O0002\nF#500\nM99\n");
    EXPECT_THAT(feed.codes, testing::IsEmpty());
    EXPECT_TRUE(feed.unknown);
}

TEST(Codes, OfAModalCallStayUntilTheyAreCancelled) {
    const std::string others = "O0002\nM99\nO0003\nM99\n";
    EXPECT_THAT(at_end("G66P2\n", ModalRole::macro_call, others).codes, testing::ElementsAre(66));
    EXPECT_THAT(at_end("G66P2\nG65P3\n", ModalRole::macro_call, others).codes, testing::ElementsAre(66));
    EXPECT_THAT(at_end("G66P2\nM98P3\n", ModalRole::macro_call, others).codes, testing::ElementsAre(66));
    EXPECT_THAT(at_end("G66P2\nG67\n", ModalRole::macro_call, others).codes, testing::ElementsAre(67));
}

TEST(Codes, AreWatchedInTheGroupsThatRulesAskFor) {
    const auto workspace = test::analyse_text(
        "dinplus", "MACHINING\nN1 G18\nN2 G41\nN3 G30 H1 Q1\nN4 G54\nN5 F0.2\nN6 M30\nEND\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::vector<std::uint32_t> lines;
    for (const dataflow::PointState& point : analysis.facts().all<dataflow::BeforeWatchedWord>())
        lines.push_back(test::line_of_effect(analysis, point.effect));
    EXPECT_THAT(lines, testing::ElementsAre(2)); // the plane
}

} // namespace
} // namespace maclint
