//! Every exemption has a program that wants it, and what exemptions hold back is told with its reason.
#include "analyzer/program/model.hpp"
#include "rules/withheld.hpp"
#include "tests/support/linted.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::Each;
using testing::Eq;
using testing::IsEmpty;
using testing::Not;

class Exemptions : public testing::TestWithParam<NamedExemption> {};

std::string test_name(const testing::TestParamInfo<NamedExemption>& info) {
    std::string name = info.param.name();
    std::ranges::replace_if(
        name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

cli::Result lint(const NamedExemption& exemption, const ExemptionChoice& choice) {
    const Example& example = exemption.record().wanted_by;
    cli::Overrides overrides;
    overrides.dialect = find_dialect(example.dialect);
    overrides.select = {std::string(exemption.rule->code)};
    overrides.complete = example.complete;
    return lint_texts({{std::string(example.file), std::string(example.text)}}, std::move(overrides), choice);
}

std::string names(const std::vector<NamedExemption>& exemptions) {
    std::string all;
    for (const NamedExemption& exemption : exemptions) all += (all.empty() ? "" : " ") + exemption.name();
    return all;
}

TEST_P(Exemptions, KeepTheirRuleSilentInTheProgramThatWantsThem) {
    EXPECT_THAT(codes(lint(GetParam(), {})), IsEmpty()) << GetParam().name();
}

TEST_P(Exemptions, AreAllThatKeepsItSilentThere) {
    const auto found = codes(lint(GetParam(), {.without = {GetParam()}}));
    EXPECT_THAT(found, Not(IsEmpty())) << GetParam().name();
    EXPECT_THAT(found, Each(Eq(GetParam().rule->code))) << GetParam().name();
}

TEST_P(Exemptions, AreToldWithWhatTheyHoldBack) {
    const auto result = lint(GetParam(), {.withheld = Withheld::listed});
    EXPECT_THAT(result.findings, Not(IsEmpty())) << GetParam().name();
    for (const auto& [finding, suppressed] : result.findings) {
        EXPECT_TRUE(suppressed.has_value());
        EXPECT_EQ(names(withheld_by(finding)), GetParam().name());
    }
}

TEST_P(Exemptions, HaveARecordThatIsComplete) {
    const RuleExemption& record = GetParam().record();
    EXPECT_NE(record.exemption, nullptr);
    EXPECT_THAT(std::string(record.name), testing::MatchesRegex("[a-z0-9]+(-[a-z0-9]+)*"));
    EXPECT_THAT(record.why, testing::EndsWith("."));
    EXPECT_EQ(find_exemption(GetParam().name()), GetParam());
}

INSTANTIATE_TEST_SUITE_P(All, Exemptions, testing::ValuesIn(all_exemptions()), test_name);

TEST(ExemptionRegistry, HasNoneTwiceInARule) {
    for (const Rule* rule : all_rules()) {
        EXPECT_LE(rule->exemptions.size(), 32U) << rule->code << ": no more bits";
        std::set<std::string_view> names;
        std::set<const Exemption*> exemptions;
        for (const RuleExemption& record : rule->exemptions) {
            EXPECT_TRUE(names.insert(record.name).second) << rule->code << " " << record.name;
            EXPECT_TRUE(exemptions.insert(record.exemption).second) << rule->code << " " << record.name;
        }
    }
}

/// Rules on words share a pass: one that is off for a rule would be off for all.
TEST(ExemptionRegistry, GivesRulesOnWordsExemptionsOfTheirOwn) {
    std::set<const Exemption*> exemptions;
    for (const Rule* rule : all_rules()) {
        if (!std::holds_alternative<WordCheck>(rule->check)) continue;
        for (const RuleExemption& record : rule->exemptions) {
            EXPECT_TRUE(exemptions.insert(record.exemption).second) << rule->code << " " << record.name;
        }
    }
}

TEST(ExemptionRegistry, FindsThemByAnyNameOfTheirRule) {
    const NamedExemption& first = all_exemptions().front();
    const std::string name = "/" + std::string(first.record().name);
    EXPECT_EQ(find_exemption(std::string(first.rule->name) + name), first);
    std::string capitals = first.name();
    std::ranges::transform(capitals, capitals.begin(), [](unsigned char c) { return std::toupper(c); });
    EXPECT_EQ(find_exemption(capitals), first);
    EXPECT_FALSE(find_exemption(std::string(first.rule->code)));
    EXPECT_FALSE(find_exemption(std::string(first.rule->code) + "/"));
    EXPECT_FALSE(find_exemption("MAC999" + name));
}

/// A rule with three exemptions that finds a place where these hold nothing back.
class Withholding : public testing::Test {
  protected:
    Withholding()
        : source_(std::make_shared<const Source>(Source::from_bytes("O1.nc", "O1\nM30\n"))) {
        static const Exemption one, two, three;
        for (const Exemption* exemption : {&one, &two, &three})
            rule_.exemptions.push_back({exemption, "name", "Why.", {"fanuc", ""}});
    }

    [[nodiscard]] Finding at(Offset place) const {
        Finding finding{.rule = &rule_,
                        .cause = Cause(file_, {}),
                        .severity = Severity::warning,
                        .source = source_,
                        .span = {place, place + 1},
                        .message_id = "",
                        .arguments = {},
                        .related = {},
                        .path = {},
                        .fixes = {}};
        return finding;
    }

    Rule rule_{.code = "MAC999",
               .name = "test",
               .summary = "",
               .why = "",
               .severity = Severity::warning,
               .precision = Precision::high,
               .messages = {},
               .bad = {},
               .good = {},
               .sources = {},
               .check = RaisedByCommand{}};
    ProgramFile file_;
    std::shared_ptr<const Source> source_;
};

constexpr ExemptionBits first = 1, second = 2, third = 4;

TEST_F(Withholding, NamesEachExemptionThatWouldDo) {
    const auto withheld = withheld_findings(rule_, 0, [&](ExemptionBits off) {
        std::vector<Finding> found{at(0)};
        if ((off & (first | third)) == (first | third)) found.push_back(at(3));
        return found;
    });
    ASSERT_EQ(withheld.size(), 1U);
    EXPECT_EQ(withheld.front().span.begin, 3U);
    EXPECT_EQ(withheld.front().withheld, first | third);
}

TEST_F(Withholding, LeavesOutWhatIsSilentAnyway) {
    const auto withheld = withheld_findings(rule_, 0, [&](ExemptionBits off) {
        std::vector<Finding> found;
        if (off != 0) found.push_back(at(3));
        for (Finding& finding : found) finding.is_silent = true;
        return found;
    });
    EXPECT_THAT(withheld, IsEmpty());
}

TEST_F(Withholding, NamesAllWhereNoneDoesAlone) {
    const auto withheld = withheld_findings(rule_, 0, [&](ExemptionBits off) {
        return (off & (first | second)) != 0 ? std::vector{at(3)} : std::vector<Finding>();
    });
    ASSERT_EQ(withheld.size(), 1U);
    EXPECT_EQ(withheld.front().withheld, first | second | third);
}

TEST_F(Withholding, LeavesOutWhatIsOffAnyway) {
    const auto found_without = [&](ExemptionBits off) {
        return (off & (first | second)) == (first | second) ? std::vector{at(3)} : std::vector<Finding>();
    };
    EXPECT_THAT(withheld_findings(rule_, first | second, found_without), IsEmpty());
    const auto withheld = withheld_findings(rule_, first, found_without);
    ASSERT_EQ(withheld.size(), 1U);
    EXPECT_EQ(withheld.front().withheld, second);
}

} // namespace
} // namespace maclint::test
