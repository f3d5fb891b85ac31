//! Who is silent where two rules speak of one cause.
#include "cli/filter/one_cause.hpp"
#include "tests/support/program_file.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;

Rule rule(std::string_view code, std::string_view yields_to) {
    return {.code = code,
            .name = code,
            .summary = "",
            .why = "",
            .severity = Severity::error,
            .precision = Precision::high,
            .yields_to = yields_to,
            .messages = {},
            .bad = {},
            .good = {},
            .sources = {},
            .check = RaisedByCommand{}};
}

const Rule owner = rule("X1", ""), second = rule("X2", "X3 X1"), third = rule("X3", "X9 X2");

/// The findings that are left of those of these rules at these bytes of one file.
std::vector<std::string> left(const std::vector<std::pair<const Rule*, Offset>>& raised,
                              const Rule* off = nullptr) {
    const auto file = test::file_of(std::make_shared<const Source>(Source::from_bytes("O1.nc", "")));
    std::vector<Finding> findings;
    for (const auto& [by, at] : raised) {
        Reporter reporter(*by);
        reporter.report({*file, {at, at + 1}}, {at, at + 1}, "plain", {});
        findings.push_back(reporter.take().front());
    }
    cli::drop_yielding(findings, [&](const Finding& asked) { return asked.rule != off; });
    std::vector<std::string> codes;
    for (const Finding& finding : findings) codes.emplace_back(finding.rule->code);
    return codes;
}

TEST(OneCause, TheRuleThatYieldsIsSilent) {
    EXPECT_THAT(left({{&second, 1}, {&owner, 1}}), ElementsAre("X1"));
    EXPECT_THAT(left({{&owner, 1}, {&second, 1}}), ElementsAre("X1"));
}

TEST(OneCause, WhatIsAboutSomethingElseStays) {
    EXPECT_THAT(left({{&owner, 1}, {&second, 2}}), ElementsAre("X1", "X2"));
    EXPECT_THAT(left({{&owner, 1}, {&third, 1}}), ElementsAre("X1", "X3"));
    EXPECT_THAT(left({{&second, 1}, {&second, 1}}), ElementsAre("X2", "X2"));
}

TEST(OneCause, ARuleThatIsOffOwnsNothing) {
    EXPECT_THAT(left({{&owner, 1}, {&second, 1}}, &owner), ElementsAre("X1", "X2"));
}

TEST(OneCause, AnOwnerThatYieldsItselfIsStillTheOwner) {
    EXPECT_THAT(left({{&owner, 1}, {&second, 1}, {&third, 1}}), ElementsAre("X1"));
}

} // namespace
} // namespace maclint
