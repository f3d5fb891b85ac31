//! Guards that an earlier guard has decided, and what none of them asks for.
#include "analyzer/dataflow/facts/condition.hpp"
#include "analyzer/queries/conditions/guards_before.hpp"
#include "tests/support/analysed.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace maclint {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// For each condition: "-", or the line of the guard that decides it, and what it always is.
std::vector<std::string> decided(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::vector<std::string> out;
    for (const auto& condition : analysis.facts().all<dataflow::Condition>()) {
        const auto guard = queries::guard_that_decides(analysis, condition);
        out.push_back(!guard ? "-"
                             : std::to_string(test::line_of_effect(analysis, guard->effect)) +
                                   (guard->same ? " same " : " ") + (guard->makes ? "true" : "false"));
    }
    return out;
}

TEST(GuardThatDecides, IsTheNearestThatSaysEnough) {
    EXPECT_THAT(decided("O1\nIF[#6GT5]GOTO9\nIF[#6GT10]GOTO8\nIF[#6LT20]GOTO9\nN8\nN9M99\n"),
                ElementsAre("-", "2 false", "3 true"));
    EXPECT_THAT(decided("O1\nIF[#6EQ#0]GOTO9\nIF[#6EQ#0]GOTO8\nN8\nN9M99\n"),
                ElementsAre("-", "2 same false"));
}

TEST(GuardThatDecides, KnowsThatVacantIsNotEqualToZero) {
    // NE 0 is true of vacant, which LT takes for 0
    EXPECT_THAT(decided("O1\nIF[#6NE0]GOTO9\nIF[#6GE0]GOTO8\nN8\nN9M99\n"), ElementsAre("-", "2 true"));
    EXPECT_THAT(decided("O1\nIF[#6LT0]GOTO9\nIF[#6GT0]GOTO9\nIF[#6EQ0]GOTO8\nN8\nN9M99\n"),
                ElementsAre("-", "-", "-"));
}

TEST(GuardThatDecides, IsNoneWhereTheProgramComesInBetween) {
    EXPECT_THAT(decided("O1\nIF[#1EQ1]GOTO5\nIF[#6GT5]GOTO9\nN5IF[#6GT10]GOTO8\nN8\nN9M99\n"),
                ElementsAre("-", "-", "-"));
}

std::vector<int> untested(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    std::vector<int> numbers;
    for (const Variable variable : queries::untested_arguments(workspace->programs().front()))
        numbers.push_back(variable.number);
    return numbers;
}

TEST(UntestedArguments, AreThoseThatAreUsedAsGiven) {
    EXPECT_THAT(untested("O9001\nIF[#24EQ#0]GOTO9\nIF[0GT#7]GOTO9\nG0X#24Y#25Z[#26+#7]\nX#25\nN9M99\n"),
                ElementsAre(25, 26));
    EXPECT_THAT(untested("O9001\n#25=#26\nG0X#24Y#25Z#101\nM99\n"), ElementsAre(24));
    EXPECT_THAT(untested("O9001\nG0X1.\nM30\n"), IsEmpty());
}

} // namespace
} // namespace maclint
