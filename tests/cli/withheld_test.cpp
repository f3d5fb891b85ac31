//! What exemptions hold back: who is told of it, in which words, and that it does not count.
#include "tests/cli/reports.hpp"
#include "tests/support/in_repository.hpp"
#include "tests/support/linted.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace maclint::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// MAC718 would speak of line 3, but that line 2 jumps to the same place.
constexpr const char* twice_asked = "O9718(LEVELS, K)\nIF[#6GT5]GOTO1\nIF[#6GT10]GOTO1\nG90G0Z#6\nN1M99\n";
constexpr const char* exemption = "MAC718/jump-to-same-place";

class Held : public InRepository {
  protected:
    void SetUp() override {
        InRepository::SetUp();
        folder.write("O9718.nc", twice_asked);
    }
    [[nodiscard]] Finished run(std::vector<std::string> arguments) const {
        arguments.emplace_back("O9718.nc");
        return run_maclint(folder.path().string(), arguments, "");
    }
    [[nodiscard]] json report(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"--no-timestamps", "--format", "json"});
        return json::parse(run(std::move(arguments)).out);
    }
};

TEST_F(Held, IsNotToldByDefault) {
    EXPECT_THAT(run({}).out, Not(HasSubstr("MAC718")));
    EXPECT_FALSE(report({}).contains("withheld"));
}

TEST_F(Held, IsShownWithItsReasonAndFailsNoRun) {
    const Finished finished = run({"--show-withheld"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_THAT(finished.out,
                HasSubstr("withheld warning[MAC718]: Condition never true: '[#6GT10]', because of the"));
    EXPECT_THAT(finished.out, HasSubstr("--> O9718.nc:3:3"));
    EXPECT_THAT(finished.out,
                HasSubstr("= by MAC718/jump-to-same-place: An earlier test jumps to the same place"));
    EXPECT_THAT(finished.out, HasSubstr("no findings (1 checked, 1 withheld)"));
}

TEST_F(Held, HasALineOfItsOwnInTheConciseReport) {
    const Finished finished = run({"--show-withheld", "--format", "concise"});
    EXPECT_THAT(finished.out, HasSubstr("O9718.nc:3:3: warning[MAC718] Condition never true"));
    EXPECT_THAT(finished.out, HasSubstr(" Withheld by MAC718/jump-to-same-place.\n"));
}

TEST_F(Held, IsAListOfItsOwnInJson) {
    const json shown = report({"--show-withheld"});
    EXPECT_THAT(shown["findings"], IsEmpty());
    ASSERT_EQ(shown["withheld"].size(), 1U);
    EXPECT_EQ(shown["withheld"][0]["code"], "MAC718");
    EXPECT_EQ(shown["withheld"][0]["exemptions"], json::array({exemption}));
    EXPECT_EQ(shown["summary"]["withheld"], 1);
    EXPECT_EQ(shown["summary"]["suppressed"], 0);
}

TEST_F(Held, IsASuppressedResultInSarif) {
    const json sarif = json::parse(run({"--show-withheld", "--format", "sarif"}).out);
    const json result = sarif["runs"][0]["results"][0];
    EXPECT_EQ(result["ruleId"], "MAC718");
    ASSERT_EQ(result["suppressions"].size(), 1U);
    EXPECT_EQ(result["suppressions"][0]["kind"], "external");
    EXPECT_EQ(result["suppressions"][0]["status"], "accepted");
    EXPECT_EQ(result["suppressions"][0]["properties"]["exemption"], exemption);
}

TEST_F(Held, CountsWhenTheExemptionIsOff) {
    EXPECT_EQ(run({"--without-exemption", "constant-condition/JUMP-to-same-place"}).status, 1);
    const json shown = report({"--without-exemption", exemption, "--show-withheld"});
    EXPECT_EQ(shown["findings"].size(), 1U);
    EXPECT_THAT(shown["withheld"], IsEmpty());
}

TEST_F(Held, IsNotToldWhereItsRuleIsOffOrACommentAllowsIt) {
    EXPECT_THAT(report({"--show-withheld", "--ignore", "MAC718"})["withheld"], IsEmpty());
    folder.write("O9718.nc", "(MACLINT ALLOW-FILE MAC718 - AS MEANT)\n" + std::string(twice_asked));
    const json shown = report({"--show-withheld"});
    EXPECT_THAT(shown["withheld"], IsEmpty());
    EXPECT_EQ(shown["findings"][0]["code"], "MAC001") << "the comment allows nothing that counts";
}

TEST_F(Held, HasTheSeverityThatTheConfigurationGives) {
    EXPECT_EQ(report({"--show-withheld", "--severity", "MAC718=error"})["withheld"][0]["severity"], "error");
    EXPECT_EQ(run({"--show-withheld", "--severity", "MAC718=error"}).status, 0);
}

TEST_F(Held, IsNoPartOfABaseline) {
    (void)run({"--show-withheld", "--write-baseline", "known.json"});
    EXPECT_THAT(report({"--baseline", "known.json", "--without-exemption", exemption})["findings"],
                testing::SizeIs(1));
}

TEST_F(Held, AnswersAWordThatNamesNoExemption) {
    const Finished finished = run({"--without-exemption", "MAC718/jump-to-same-plase"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err,
                HasSubstr("--without-exemption does not know 'MAC718/jump-to-same-plase'. Did you "
                          "mean 'MAC718/jump-to-same-place'?"));
}

TEST_F(Held, IsExplained) {
    const auto page = [&](const std::string& word) {
        return run_maclint(folder.path().string(), {"explain", word}, "").out;
    };
    EXPECT_THAT(page("MAC718"), HasSubstr("MAC718/jump-to-same-place: An earlier test jumps to the same"));
    EXPECT_THAT(page(exemption), HasSubstr("IF[#6GT10]GOTO1"));
}

/// MAC702 yields to MAC210 where that speaks, which it does not.
TEST(Withheld, OwnsNoCauseOfAnotherRule) {
    const LintedText text{"O0210.nc",
                          "O0210(PLATE)\nG65P9210Z-5.\nM30\nO9210(DRILL, Z R)\nIF[#18GT10.]GOTO9\n"
                          "#1=5/#18\nG90G1Z[#26+#1]F100.\nM99\nN9#3000=1(R TOO HIGH)\n"};
    const auto listed = lint_texts({text}, {}, {.withheld = Withheld::listed});
    EXPECT_THAT(codes(listed), ElementsAre("MAC702"));
    EXPECT_EQ(listed.findings.size(), 2U);
    EXPECT_THAT(codes(lint_texts({text}, {}, {.without = {*find_exemption("MAC210/compared-somewhere")}})),
                ElementsAre("MAC210"));
}

TEST(Withheld, IsListedBesideWhatCounts) {
    const LintedText text{"O9718.nc", std::string(twice_asked) + "O9212(STUB)\nGOTO9\nM99\n"};
    const auto listed = lint_texts({text}, {}, {.withheld = Withheld::listed});
    EXPECT_THAT(codes(listed), ElementsAre("MAC301"));
    EXPECT_EQ(codes(lint_texts({text}, {})), codes(listed));
    EXPECT_EQ(listed.findings.size(), 2U);
}

} // namespace
} // namespace maclint::test
