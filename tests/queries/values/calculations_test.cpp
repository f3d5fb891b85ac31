//! Which calculation a value is the result of, and what is calculated with.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/queries/values/amounts.hpp"
#include "analyzer/queries/values/calculations.hpp"
#include "tests/support/analysed.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

/// The operation of what #5 holds after these blocks.
std::optional<Operation> operation_after(const std::string& text) {
    const auto workspace = test::analyse_fanuc("O9001\n" + text + "X#5\nM99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    return operation_of(analysis, test::last_read(analysis));
}

TEST(Calculations, AreFollowedThroughVariables) {
    EXPECT_EQ(operation_after("#5=#501/3\n"), Operation::divide);
    EXPECT_EQ(operation_after("#4=#501*3\n#5=#4\n"), Operation::multiply);
    EXPECT_EQ(operation_after("#5=FIX[#501]\n"), Operation::truncate);
}

TEST(Calculations, AreNoneOfNumbersAndOfWhatIsRead) {
    EXPECT_EQ(operation_after("#5=3\n"), std::nullopt);
    EXPECT_EQ(operation_after("#5=#501\n"), std::nullopt);
    EXPECT_EQ(operation_after(""), std::nullopt);
    EXPECT_EQ(operation_after("#5=#501/3\nIF[#502EQ1]GOTO7\n#5=#501/4\nN7"), std::nullopt);
}

TEST(RoundedResults, AreThoseOfTheVeryValue) {
    const auto left_is_rounded_right = [](const std::string& sides) {
        const auto workspace = test::analyse_fanuc("O9001\nIF[" + sides + "]GOTO9\nX1.\nN9M99\n");
        const ProgramAnalysis& analysis = workspace->programs().front();
        const dataflow::Comparison& test = analysis.facts().all<dataflow::Comparison>().front();
        return is_rounded_result(analysis, test.left, test.right);
    };
    EXPECT_TRUE(left_is_rounded_right("FIX[#501]EQ#501"));
    EXPECT_TRUE(left_is_rounded_right("FUP[#501]EQ#501"));
    EXPECT_TRUE(left_is_rounded_right("ROUND[#501]EQ#501"));
    EXPECT_FALSE(left_is_rounded_right("ABS[#501]EQ#501"));
    EXPECT_FALSE(left_is_rounded_right("FIX[#502]EQ#501"));
    EXPECT_FALSE(left_is_rounded_right("#501EQFIX[#501]"));
}

/// The texts that are calculated with as amounts, each with the calculation.
std::vector<std::string> amounts_in(const std::string& expression) {
    const auto workspace = test::analyse_fanuc("O9001\n#5=" + expression + "\nM99\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const Program& program = analysis.program();
    const auto found = calculations_with_amounts(program);
    std::vector<std::string> texts;
    for (ExpressionId id = 0; id < found.size(); ++id)
        if (found[id])
            texts.push_back(test::text_of(analysis, program.expressions[id].span) + " in " +
                            test::text_of(analysis, program.expressions[*found[id]].span));
    return texts;
}

TEST(Amounts, AreMultipliedDividedOrGivenToAFunction) {
    using testing::IsEmpty;
    using testing::UnorderedElementsAre;
    EXPECT_THAT(amounts_in("#1*#2"), UnorderedElementsAre("#1 in #1*#2", "#2 in #1*#2"));
    EXPECT_THAT(amounts_in("SIN[#1]"), UnorderedElementsAre("[#1] in SIN[#1]"));
    EXPECT_THAT(amounts_in("#1-53"), IsEmpty());
    EXPECT_THAT(amounts_in("FIX[#1]"), IsEmpty());
}

TEST(Amounts, AreLookedForBehindTheSignAndRounding) {
    EXPECT_THAT(amounts_in("SIN[FIX[-#1]]"), testing::ElementsAre("#1 in SIN[FIX[-#1]]"));
}

} // namespace
} // namespace maclint::queries
