//! What a maker's programs are told of, with the built executable.
#include "tests/support/in_repository.hpp"

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

/// A warning, MAC209 on line 6, and what `more` is.
std::string macro(const std::string& number, const std::string& remark, const std::string& more = "") {
    return "%\nO" + number + "(BORE)\n" + remark + "\nIF[#24EQ#0]GOTO5\n#31=#24\nN5G0X#31\n" + more +
           "M99\n%\n";
}
constexpr const char* maker = "(COPYRIGHT*1990-2022*MAKER*PLC.*ALL*RIGHTS*RESERVED)";

class VendorCode : public InRepository {
  protected:
    void SetUp() override {
        InRepository::SetUp();
        folder.write("probe/O9810.nc", macro("9810", maker));
        folder.write("probe/O9811.nc", macro("9811", maker, "IF[#500EQ1]GOTO77\n"));
        folder.write("own/O9001.nc", macro("9001", "(FOR THE BORE)"));
    }

    [[nodiscard]] Finished run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"--format", "concise", "--select", "MAC209,MAC301"});
        return run_maclint(folder.path().string(), arguments, "");
    }
    /// File and code of what is shown.
    [[nodiscard]] std::vector<std::string> shown(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"--format", "json", "--select", "MAC209,MAC301"});
        const json report = json::parse(run_maclint(folder.path().string(), arguments, "").out);
        std::vector<std::string> findings;
        for (const json& finding : report["findings"])
            findings.push_back(finding["file"].get<std::string>() + " " + finding["code"].get<std::string>());
        return findings;
    }
    static constexpr const char* withheld =
        "maclint: note: 2 warnings in 2 programs of a maker (vendor code) not shown: --vendor shows them.\n";
};

TEST_F(VendorCode, IsToldOfErrorsOnlyAndTheRestIsCounted) {
    EXPECT_THAT(shown({"."}), ElementsAre("own/O9001.nc MAC209", "probe/O9811.nc MAC301"));
    const Finished finished = run({"."});
    EXPECT_EQ(finished.err, withheld);
    EXPECT_THAT(finished.out, HasSubstr("1 error, 1 warning in 2 files (3 checked)"));
    EXPECT_EQ(run({"."}).status, 1);
    EXPECT_EQ(run({"--fail-on", "warning", "probe/O9810.nc", "."}).status, 1);
}

TEST_F(VendorCode, DoesNotFailARun) {
    folder.write("own/O9001.nc", macro("9001", maker));
    folder.write("probe/O9811.nc", macro("9811", maker));
    EXPECT_EQ(run({"."}).status, 0);
    EXPECT_EQ(run({"--vendor", "."}).status, 1);
}

TEST_F(VendorCode, IsShownByTheOptionAndToWhoeverNamesTheFile) {
    EXPECT_THAT(shown({"--vendor", "."}), ElementsAre("own/O9001.nc MAC209", "probe/O9810.nc MAC209",
                                                      "probe/O9811.nc MAC209", "probe/O9811.nc MAC301"));
    EXPECT_EQ(run({"--vendor", "."}).err, "");
    EXPECT_THAT(shown({"probe/O9810.nc"}), ElementsAre("probe/O9810.nc MAC209"));
    EXPECT_THAT(shown({"probe"}), ElementsAre("probe/O9811.nc MAC301"));
    // Hooks name what they find.
    EXPECT_THAT(shown({"--force-exclude", "probe/O9810.nc"}), IsEmpty());
}

TEST_F(VendorCode, IsWhatTheConfigurationSays) {
    folder.write(".maclint.json", R"({ "vendor": [ "own/**", "!probe/O9810.nc" ] })");
    EXPECT_THAT(shown({"."}), ElementsAre("probe/O9810.nc MAC209", "probe/O9811.nc MAC301"));
    folder.write(".maclint.json", R"({ "vendor": false })");
    EXPECT_THAT(shown({"."}).size(), 4U);
    folder.write(".maclint.json", R"({ "vendor": [ "**", "!own/**" ] })");
    EXPECT_THAT(shown({"."}), ElementsAre("own/O9001.nc MAC209", "probe/O9811.nc MAC301"));
    folder.write(".maclint.json", R"({ "vendor": "probe" })");
    EXPECT_THAT(run({"."}).err, HasSubstr("'vendor' must be a list of globs"));
    folder.write(".maclint.json", R"({ "vendor": [ "!" ] })");
    EXPECT_THAT(run({"."}).err, HasSubstr("'!' alone"));
}

TEST_F(VendorCode, IsListedInJsonAndSuppressedInSarif) {
    const auto report_as = [&](const std::string& format) {
        return json::parse(
            run_maclint(folder.path().string(), {"--format", format, "--select", "MAC209,MAC301", "."}, "")
                .out);
    };
    const json report = report_as("json");
    ASSERT_EQ(report["vendor"].size(), 2U);
    EXPECT_EQ(report["vendor"][0]["file"], "probe/O9810.nc");
    EXPECT_EQ(report["summary"]["vendor"], 2);
    EXPECT_EQ(report["summary"]["suppressed"], 0);
    EXPECT_EQ(report["summary"]["warnings"], 1);
    const json sarif = report_as("sarif");
    std::vector<std::string> kinds;
    for (const json& result : sarif["runs"][0]["results"])
        for (const json& suppression : result["suppressions"]) kinds.push_back(suppression["kind"]);
    EXPECT_THAT(kinds, ElementsAre("external", "external"));
    EXPECT_THAT(sarif["runs"][0]["invocations"].dump(), HasSubstr("NOTE008"));
}

TEST_F(VendorCode, IsKnownToABaselineLikeAllOther) {
    ASSERT_EQ(run({"--write-baseline", "base.json", "."}).status, 0);
    const Finished known = run({"--baseline", "base.json", "--vendor", "."});
    EXPECT_EQ(known.status, 0);
    EXPECT_THAT(known.out, HasSubstr("4 known findings of base.json not shown"));
    EXPECT_EQ(run({"--baseline", "base.json", "."}).err, "");
}

TEST_F(VendorCode, IsSaidWithItsReasonByShowConfig) {
    EXPECT_THAT(run_maclint(folder.path().string(), {"--show-config", "probe"}, "").out,
                HasSubstr("vendor code    only errors count (the remark on line 3)"));
    EXPECT_THAT(run_maclint(folder.path().string(), {"--show-config", "own"}, "").out,
                Not(HasSubstr("vendor code")));
    folder.write(".maclint.json", R"({ "vendor": [ "own" ] })");
    EXPECT_THAT(run_maclint(folder.path().string(), {"--show-config", "own"}, "").out,
                HasSubstr("only errors count (.maclint.json: vendor)"));
}

} // namespace
} // namespace maclint::test
