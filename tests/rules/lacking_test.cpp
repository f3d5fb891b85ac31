//! MAC124: what other controls of the family have, by the control that is named.
#include "tests/support/linted.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// "error MAC124 (113)" for each finding of a macro with that block.
std::vector<std::string> lacking_found(const std::string& block, std::string_view control) {
    static constexpr const char* severities[] = {"note", "warning", "error"};
    cli::Overrides overrides;
    overrides.control = std::string(control);
    std::vector<std::string> all;
    const std::string text =
        "O9001(MACRO, A B)\nIF[#1EQ#0]THEN #1=1\nIF[#2EQ#0]THEN #2=1\n" + block + "\nM99\n";
    for (const auto& [finding, suppressed] :
         test::lint_texts({{"O1.nc", text}}, std::move(overrides)).findings)
        all.push_back(std::string(severities[static_cast<int>(finding.severity)]) + " " +
                      std::string(finding.rule->code) +
                      (finding.alarm.empty() ? "" : " (" + std::string(finding.alarm) + ")"));
    return all;
}

TEST(Functions, ThatTheNamedControlLacksStopIt) {
    EXPECT_THAT(lacking_found("G0 X[POW[#1,3]]", "fanuc-16i"), ElementsAre("error MAC124 (113)"));
    EXPECT_THAT(lacking_found("G0 X[PRM[3411]]", "fanuc-0i-c"), ElementsAre("error MAC124 (113)"));
    EXPECT_THAT(lacking_found("G0 X[#1MOD#2]", "fanuc-16i"), ElementsAre("warning MAC124"));
    EXPECT_THAT(lacking_found("G0 X[LN[2]]", "haas"), ElementsAre("warning MAC124"));
    EXPECT_THAT(lacking_found("G0 X[EXP[#1]]", "fanuc-16i"), IsEmpty());
    for (const char* block : {"G0 X[POW[#1,3]]", "G0 X[#1MOD3]", "G0 A[ATAN[#1]]", "G0 A[ATAN[#1,#2]]"}) {
        EXPECT_THAT(lacking_found(block, "fanuc-30i"), IsEmpty()) << block;
        EXPECT_THAT(lacking_found(block, "fanuc"), IsEmpty()) << block;
    }
}

TEST(Forms, OfFunctionsDiffer) {
    EXPECT_THAT(lacking_found("G0 A[ATAN[#1,#2]]", "fanuc-16i"), ElementsAre("error MAC124"));
    EXPECT_THAT(lacking_found("G0 A[ATAN[#1]]", "fanuc-16i"), ElementsAre("warning MAC124"));
    EXPECT_THAT(lacking_found("G0 A[ATAN[#1]/[2]]", "fanuc-16i"), IsEmpty());
    EXPECT_THAT(lacking_found("G0 A[ATAN[#1]]", "haas"), IsEmpty());
}

TEST(Conditions, CompareOnAFanucAndNeedNotOnAHaas) {
    EXPECT_THAT(lacking_found("IF[#1]GOTO9\nG0 X1.\nN9", "fanuc-16i"), ElementsAre("error MAC124"));
    EXPECT_THAT(lacking_found("IF[#1]GOTO9\nG0 X1.\nN9", "fanuc"), ElementsAre("warning MAC124"));
    EXPECT_THAT(lacking_found("IF[#1]GOTO9\nG0 X1.\nN9", "haas"), IsEmpty());
    EXPECT_THAT(lacking_found("IF[[#1EQ1]OR[#2EQ5]]GOTO9\nG0 X1.\nN9", "fanuc-30i"), IsEmpty());
}

TEST(Variables, WithNamesAreOfNewerSeries) {
    EXPECT_THAT(lacking_found("G0 X[#_ABSIO[1]]", "fanuc-16i"), ElementsAre("error MAC124"));
    EXPECT_THAT(lacking_found("G0 X[#_ABSIO[1]]", "haas"), ElementsAre("warning MAC124"));
    EXPECT_THAT(lacking_found("G0 X[#_ABSIO[1]]", "fanuc-30i"), IsEmpty());
}

} // namespace
} // namespace maclint
