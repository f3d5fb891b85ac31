//! Numbers of a text that stand for something, and those that are too long for that.
#include "analyzer/program/whole_number.hpp"
#include "tests/support/linted.hpp"

#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(WholeNumber, IsNoFractionAndHasFifteenFiguresAtMost) {
    EXPECT_EQ(whole_number(-3), -3);
    EXPECT_EQ(whole_number(1e15), 1'000'000'000'000'000);
    for (const double none : {2.5, 1.1e15, -1e20, std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(whole_number(none), std::nullopt) << none;
}

/// The sanitizers would refuse it.
TEST(WholeNumber, IsAskedForWhereBlocksProgramsAndGroupsAreNamed) {
    const std::string many(25, '9');
    const auto found = [](const std::string& name, const std::string& text) {
        std::vector<std::string_view> codes;
        for (const auto& [finding, suppressed] : test::lint_texts({{name, text}}, {}).findings)
            codes.push_back(finding.rule->code);
        return codes;
    };
    EXPECT_THAT(found("A.NCS", "MACHINING\nN1 G860 NS" + many + " NE8" + many + "\nN2 G31 NS" + many +
                                   "\nN3 G3" + many + " X5\nN30 M30\nEND\n"),
                ElementsAre("MAC123"));
    EXPECT_THAT(found("A.NC", "O1\nM98 P" + many + "\nM97 P1 Q" + many + "\nIF[#1EQ" + many + "]THEN #2=#[" +
                                  many + "]\nM30\n"),
                ElementsAre("MAC301"));
    EXPECT_THAT(
        found("A.MPF", "DEF REAL LIST[" + many + "]\nG[" + many + "]=2\nR1=$P_GG[" + many + "]\nM30\n"),
        IsEmpty());
}

} // namespace
} // namespace maclint
