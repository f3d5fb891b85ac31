//! Which reads find a variable that nothing has set.
#include "analyzer/dataflow/facts/application.hpp"
#include "analyzer/queries/vacancy/unset_reads.hpp"
#include "analyzer/source/budget.hpp"
#include "tests/support/analysed.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

/// The numbers of the variables that the last program of the text reads unset.
std::vector<std::int32_t> unset_in(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    std::vector<std::int32_t> numbers;
    for (const UnsetReads& found : find_unset_reads(workspace->programs().back())) {
        numbers.push_back(found.first.read->variable.number);
        for (const dataflow::Read* other : found.others) numbers.push_back(other->variable.number);
    }
    return numbers;
}

using testing::ElementsAre;
using testing::IsEmpty;

TEST(UnsetReads, AreTheFirstOfEachVariable) {
    EXPECT_THAT(unset_in("O1\nX#10\nX#10\nY#11\n#12=1\nZ#12\nM30\n"), ElementsAre(10, 11));
}

TEST(UnsetReads, HaveAPathAroundEveryAssignment) {
    EXPECT_THAT(unset_in("O1\nIF[#501EQ1]GOTO5\n#10=1\nN5X#10\nM30\n"), ElementsAre(10));
    EXPECT_THAT(unset_in("O1\nIF[#501EQ1]GOTO5\n#10=1\nN5IF[#501EQ1]GOTO6\nX#10\nN6M30\n"), IsEmpty());
}

TEST(UnsetReads, AreNoQuestionsAndNoCounting) {
    EXPECT_THAT(unset_in("O1\nIF[#10EQ#0]GOTO5\nG0X1.\nN5M30\n"), IsEmpty());
    EXPECT_THAT(unset_in("O1\n#10=#10+1\nX#10\nM30\n"), IsEmpty());
    EXPECT_THAT(unset_in("O1\n#10=#11+1\nX#10\nM30\n"), ElementsAre(11));
}

TEST(UnsetReads, AreNotWhatCallersMayPassOrShare) {
    EXPECT_THAT(unset_in("O9001\nX#24\nM99\n"), IsEmpty()); // a letter
    EXPECT_THAT(unset_in("O9001\nX#24Y#10\nM99\n"), ElementsAre(10));
    EXPECT_THAT(unset_in("O1\n#10=1\nM98P2\nM30\nO2\nX#10Y#11\nM99\n"), ElementsAre(11)); // the locals of O1
    // I, J and K for the third time, of a caller that is unknown: only somebody who reads all of them expects
    // them.
    EXPECT_THAT(unset_in("O9001\nX#4Y#5Z#6\nX#7Y#8Z#9\nX#10Y#11Z#12\nM99\n"), IsEmpty());
    EXPECT_THAT(unset_in("O9001\nX#4Y#5Z#6\nX#7Y#8Z#9\nX#10Y#11\nM99\n"), ElementsAre(10));
    EXPECT_THAT(unset_in("O9001\nX#4Y#5Z#6\nX#10Y#11Z#12\nM99\n"), ElementsAre(10, 12));
}

TEST(UnsetReads, OfNamesThatNothingSetsAreLookedThroughOnce) {
    constexpr int names = 2000;
    std::string text = "MACHINING\n";
    for (int i = 0; i < names; ++i) text += "#l1=#x" + std::to_string(i) + "+1\n";
    const auto workspace =
        test::analyse_files({{"x.ncs", text + "M30\nEND\n"}}, {.complete = false, .jobs = 1});
    const Budget budget(20 * std::size_t{names});
    (void)find_unset_reads(workspace->programs().front());
    EXPECT_FALSE(budget.is_spent());
}

/// Whether the divisor of the last division is what it is for want of a value.
bool lacks_value(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text + "M30\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto& division = analysis.facts().all<dataflow::Application>().back();
    return is_owed_to_missing_value(analysis, division.effect, division.right_expression);
}

TEST(MissingValues, AreFollowedBackThroughAssignments) {
    EXPECT_TRUE(lacks_value("O1\n#1=5/#10\n"));
    EXPECT_TRUE(lacks_value("O1\n#2=#10*2\n#3=#2\n#1=5/#3\n"));
    EXPECT_FALSE(lacks_value("O1\n#2=0\n#1=5/#2\n"));
    EXPECT_FALSE(lacks_value("O1\n#2=0\n#1=#10/#2\n")); // the divisor alone counts
    EXPECT_FALSE(lacks_value("O1\n#2=#0\n#1=5/#2\n"));  // made vacant on purpose
}

} // namespace
} // namespace maclint::queries
