//! What machines read: SARIF and JSON.
#include "cli/report/heading.hpp"
#include "cli/report/uri.hpp"
#include "rules/rule.hpp"
#include "tests/cli/reports.hpp"

#include <filesystem>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace maclint::cli {
namespace {

using nlohmann::json;
using test::HandMade;
using testing::HasSubstr;

json sarif_of(HandMade& made) { return json::parse(write_sarif(made.report()))["runs"][0]; }

json first_result(HandMade& made) { return sarif_of(made)["results"][0]; }

TEST(Sarif, PlacesAResultInUtf16CodeUnits) {
    HandMade made("O1.nc", "O1\n(\xF0\x9F\x98\x80) GOTO 9\n");
    made.add("GOTO 9", Severity::error);
    const json result = first_result(made);
    EXPECT_EQ(result["ruleId"], "MAC002");
    EXPECT_EQ(result["level"], "error");
    const json region = result["locations"][0]["physicalLocation"]["region"];
    EXPECT_EQ(region["startLine"], 2);
    EXPECT_EQ(region["startColumn"], 6);
    EXPECT_EQ(region["endColumn"], 12);
    EXPECT_EQ(region["snippet"]["text"], "GOTO 9");
    EXPECT_EQ(sarif_of(made)["columnKind"], "utf16CodeUnits");
}

TEST(Sarif, PointsFromAResultToItsRuleAndFile) {
    HandMade made("O1.nc", "O1\nM30\n");
    made.add("M30", Severity::error);
    const json run = sarif_of(made);
    const json result = run["results"][0];
    const std::size_t rule = result["ruleIndex"];
    EXPECT_EQ(run["tool"]["driver"]["rules"][rule]["id"], "MAC002");
    const json location = result["locations"][0]["physicalLocation"]["artifactLocation"];
    const std::size_t artifact = location["index"];
    EXPECT_EQ(run["artifacts"][artifact]["location"]["uri"], location["uri"]);
    EXPECT_EQ(location["uriBaseId"], "%SRCROOT%");
}

TEST(Sarif, GivesMessagesAsTextAndByIdWithArguments) {
    HandMade made("O1.nc", "O1\nM{0}\n");
    made.add("M{0}", Severity::error);
    const json message = first_result(made)["message"];
    EXPECT_EQ(message["id"], "unknown");
    EXPECT_EQ(message["arguments"][0], "M{0}");
    EXPECT_THAT(message["text"].get<std::string>(), HasSubstr("'M{{0}}'"));
}

TEST(Sarif, GivesNoIdWhereTheTextSaysMoreThanTheRule) {
    HandMade made("O1.nc", "O1\nM30\n");
    made.add("M30", Severity::error).alarm = "128";
    const json message = first_result(made)["message"];
    EXPECT_THAT(message["text"].get<std::string>(), HasSubstr("(alarm 128)"));
    EXPECT_FALSE(message.contains("id"));
    EXPECT_FALSE(message.contains("arguments"));
}

TEST(Sarif, DescribesRules) {
    HandMade made("O1.nc", "O1\n");
    const json sarif = sarif_of(made);
    for (const json& rule : sarif["tool"]["driver"]["rules"]) {
        EXPECT_FALSE(rule["fullDescription"]["text"].get<std::string>().empty()) << rule["id"];
        EXPECT_FALSE(rule["help"]["markdown"].get<std::string>().empty()) << rule["id"];
        EXPECT_TRUE(rule["properties"].contains("precision")) << rule["id"];
        EXPECT_THAT(rule["name"].get<std::string>(), testing::MatchesRegex("[A-Z][A-Za-z0-9]*"));
    }
}

TEST(Sarif, ListsTheExemptionsOfRules) {
    HandMade made("O1.nc", "O1\n");
    const json sarif = sarif_of(made);
    std::size_t listed = 0;
    for (const json& rule : sarif["tool"]["driver"]["rules"]) {
        const Rule& record = *find_rule(rule["id"].get<std::string>());
        const json exemptions = rule["properties"].value("exemptions", json::array());
        ASSERT_EQ(exemptions.size(), record.exemptions.size()) << rule["id"];
        for (std::size_t i = 0; i < exemptions.size(); ++i)
            EXPECT_EQ(exemptions[i]["name"], record.exemptions[i].name);
        listed += exemptions.size();
    }
    EXPECT_EQ(listed, all_exemptions().size());
    EXPECT_GT(listed, 0U);
}

TEST(Sarif, HeadsMessagesThatBeginDifferentlyWithTheRule) {
    HandMade made("O1.nc", "O1\nM30\n");
    made.add("M30", Severity::error); // MAC002 has "Unknown rule" and "Comment for maclint …"
    const json run = sarif_of(made);
    const std::string head = "Unknown rule in suppression: ";
    EXPECT_EQ(run["results"][0]["message"]["text"],
              head + "Unknown rule: there is no 'M30'. See 'maclint rules' for the list.");
    for (const json& rule : run["tool"]["driver"]["rules"]) {
        if (rule["id"] == "MAC002") {
            EXPECT_EQ(rule["messageStrings"]["unknown"]["text"],
                      head + "Unknown rule: there is no '{0}'. See 'maclint rules' for the list.");
        }
    }
    EXPECT_EQ(heading_of(*find_rule("MAC605")), ""); // all of its messages begin alike
    EXPECT_EQ(heading_of(*find_rule("MAC211")), "Argument unused: ");
}

TEST(Sarif, RelatesRulesToAlarmsOfTheirTaxonomies) {
    HandMade made("O1.nc", "O1\n");
    const json run = sarif_of(made);
    std::map<std::string, std::set<std::string>> numbers; // by taxonomy
    for (const json& taxonomy : run["taxonomies"])
        for (const json& taxon : taxonomy["taxa"]) {
            EXPECT_TRUE(numbers[taxonomy["name"]].insert(taxon["id"]).second) << taxon["id"];
            EXPECT_FALSE(taxon["fullDescription"]["text"].get<std::string>().empty()) << taxon["id"];
        }
    ASSERT_EQ(numbers.size(), run["tool"]["driver"]["supportedTaxonomies"].size());
    EXPECT_TRUE(numbers["FANUC 30i/0i-D alarms"].contains("1300")); // one that no rule finds
    std::set<std::string> of_words;                                 // alarms of the rule whose rows name them
    for (const json& rule : run["tool"]["driver"]["rules"])
        for (const json& related : rule.value("relationships", json::array())) {
            const json& target = related["target"];
            EXPECT_TRUE(numbers[target["toolComponent"]["name"]].contains(target["id"])) << rule["id"];
            if (rule["id"] == "MAC551") of_words.insert(target["id"]);
        }
    EXPECT_TRUE(of_words.contains("007"));
}

TEST(Sarif, NamesTheAnalysisAndNoAddressThatLeadsNowhere) {
    HandMade made("O1.nc", "O1\n");
    const json run = sarif_of(made);
    EXPECT_EQ(run["automationDetails"]["id"], "maclint/");
    const bool has_address = std::string_view(MACLINT_HELP_BASE_URL).starts_with("http");
    EXPECT_EQ(run["tool"]["driver"].contains("informationUri"), has_address);
    for (const json& rule : run["tool"]["driver"]["rules"])
        EXPECT_EQ(rule.contains("helpUri"), has_address) << rule["id"];
}

TEST(Sarif, CarriesRelatedPlacesPathFixAndFingerprints) {
    HandMade made("O1.nc", "O1\nGOTO 9\nN9\nM30\n");
    Finding& finding = made.add("GOTO 9", Severity::warning);
    finding.related.push_back({made.source(), made.place_of("N9"), "N9 is here"});
    finding.path.push_back({made.source(), made.place_of("O1"), "it starts here"});
    finding.path.push_back({made.source(), made.place_of("GOTO 9"), "it ends here"});
    finding.offer(
        {"Remove the jump", Applicability::unsafe, {{made.source(), made.place_of("GOTO 9\n"), ""}}});
    const json result = first_result(made);
    EXPECT_EQ(result["relatedLocations"][0]["message"]["text"], "N9 is here.");
    const json steps = result["codeFlows"][0]["threadFlows"][0]["locations"];
    ASSERT_EQ(steps.size(), 2U);
    EXPECT_EQ(steps[1]["location"]["message"]["text"], "It ends here.");
    EXPECT_EQ(steps[1]["executionOrder"], 2);
    const json fix = result["fixes"][0];
    EXPECT_EQ(fix["description"]["text"], "Remove the jump.");
    EXPECT_EQ(fix["properties"]["applicability"], "unsafe");
    EXPECT_EQ(fix["artifactChanges"][0]["artifactLocation"]["uri"], "O1.nc");
    const json change = fix["artifactChanges"][0]["replacements"][0];
    EXPECT_EQ(change["deletedRegion"]["endLine"], 3);
    EXPECT_EQ(change["deletedRegion"]["endColumn"], 1);
    EXPECT_EQ(change["insertedContent"]["text"], "");
    EXPECT_TRUE(result["partialFingerprints"].contains("primaryLocationLineHash"));
    EXPECT_TRUE(result["partialFingerprints"].contains("maclint/v2"));
}

/// A finding at 'GOTO 9' behind a condition that is false, with an alarm and a cure.
HandMade behind_condition() {
    HandMade made("O1.nc", "O1\nIF[#13EQ0]GOTO 5\nGOTO 9\nN5 M30\n");
    Finding& finding = made.add("GOTO 9", Severity::error);
    finding.path = {{made.source(), made.place_of("[#13EQ0]"), "false"},
                    {made.source(), made.place_of("[#13EQ0]"), "true: jumps to line 4"},
                    {made.source(), made.place_of("GOTO 9"), "true friends are not conditions"}};
    finding.alarm = "128";
    made.report().read_as.emplace(made.source().get(), ReadAs{"fanuc", "fanuc-16i"});
    return made;
}

TEST(Sarif, SaysWhichConditionAStepIsAbout) {
    HandMade made = behind_condition();
    const json steps = first_result(made)["codeFlows"][0]["threadFlows"][0]["locations"];
    EXPECT_EQ(steps[0]["location"]["message"]["text"], "'[#13EQ0]' is false.");
    EXPECT_EQ(steps[1]["location"]["message"]["text"], "'[#13EQ0]' is true: jumps to line 4.");
    EXPECT_EQ(steps[2]["location"]["message"]["text"], "True friends are not conditions.");
}

TEST(JsonReport, SaysWhichConditionAStepIsAbout) {
    HandMade made = behind_condition();
    const json finding = json::parse(write_json(made.report()))["findings"][0];
    EXPECT_EQ(finding["path"][0]["text"], "'[#13EQ0]' is false");
}

TEST(JsonReport, CarriesWhatOtherToolsKnowAFindingBy) {
    HandMade made = behind_condition();
    const json finding = json::parse(write_json(made.report()))["findings"][0];
    EXPECT_EQ(finding["cure"], "See 'maclint rules' for the list.");
    EXPECT_EQ(finding["alarm"], "128");
    EXPECT_EQ(finding["dialect"], "fanuc");
    EXPECT_EQ(finding["control"], "fanuc-16i");
    EXPECT_EQ(finding["fingerprint"], first_result(made)["partialFingerprints"]["maclint/v2"]);
}

TEST(Sarif, PutsTheEditsOfOneFileTogether) {
    HandMade made("O1.nc", "O1\nGOTO 9\nN9\nM30\n");
    const auto other = std::make_shared<const Source>(Source::from_bytes("O2.nc", "O2\nM99\n"));
    made.add("GOTO 9", Severity::warning)
        .offer({"Rename it",
                Applicability::unsafe,
                {{made.source(), made.place_of("N9"), "N8"},
                 {other, {0, 2}, "O3"},
                 {made.source(), made.place_of("GOTO 9"), "GOTO 8"}}});
    const json changes = first_result(made)["fixes"][0]["artifactChanges"];
    ASSERT_EQ(changes.size(), 2U);
    ASSERT_EQ(changes[0]["replacements"].size(), 2U);
    EXPECT_EQ(changes[0]["replacements"][0]["insertedContent"]["text"], "GOTO 8");
    EXPECT_EQ(changes[1]["artifactLocation"]["uri"], "O2.nc");
    EXPECT_EQ(changes[1]["replacements"][0]["insertedContent"]["text"], "O3");
}

TEST(Sarif, MarksSuppressedResults) {
    HandMade made("O1.nc", "O1\nM30 (OK)\n");
    made.add("M30", Severity::error);
    EXPECT_EQ(first_result(made)["suppressions"].size(), 0U);
    made.report().findings[0].suppressed = Suppression{made.place_of("(OK)"), "WANTED"};
    const json suppression = first_result(made)["suppressions"][0];
    EXPECT_EQ(suppression["kind"], "inSource");
    EXPECT_EQ(suppression["justification"], "WANTED");
}

TEST(Sarif, TellsOfTheRunAndOfFilesThatWereNotRead) {
    HandMade made("O1.nc", "O1\n");
    made.report().exit_status = 2;
    made.report().notices = {{NoticeKind::unreadable, "gone.nc", "there is no such file"},
                             {NoticeKind::configuration, ".maclint.json", "wrong"}};
    const json invocation = sarif_of(made)["invocations"][0];
    EXPECT_EQ(invocation["exitCode"], 2);
    EXPECT_EQ(invocation["executionSuccessful"], false);
    EXPECT_EQ(invocation["toolExecutionNotifications"][0]["level"], "error");
    EXPECT_EQ(invocation["toolConfigurationNotifications"].size(), 1U);
    EXPECT_FALSE(invocation.contains("startTimeUtc"));
    made.report().times = RunTimes{"2025-01-31T12:00:00Z", "2025-01-31T12:00:01Z"};
    EXPECT_EQ(sarif_of(made)["invocations"][0]["startTimeUtc"], "2025-01-31T12:00:00Z");
}

TEST(Sarif, IsValidUtf8WhateverTheBytesAre) {
    HandMade made("O\xFF.nc", "O1\n(\xFF\xFE\xC3) \x80\n");
    made.add("\xFF\xFE", Severity::error).arguments = {"\xFF{raw}"};
    const std::string text = write_sarif(made.report());
    EXPECT_EQ(to_utf8(text, Encoding::utf8), text);
    EXPECT_TRUE(json::accept(text));
}

TEST(Sarif, EncodesPathsAsUris) {
    EXPECT_EQ(percent_encoded("a b/O#1%.nc"), "a%20b/O%231%25.nc");
    const std::string root = std::filesystem::current_path().string();
    EXPECT_EQ(uri_of("x/../O1.nc", root).uri, "O1.nc");
    EXPECT_TRUE(uri_of("O1.nc", root).below_root);
    EXPECT_FALSE(uri_of("../O1.nc", root).below_root);
    EXPECT_THAT(uri_of("../O1.nc", root).uri, testing::StartsWith("file:///"));
}

TEST(Sarif, NamesFilesOfEverySystemByUris) {
    EXPECT_EQ(file_uri("/shop/O 1.nc"), "file:///shop/O%201.nc");
    EXPECT_EQ(file_uri("Z:/shop/O:1.nc"), "file:///Z:/shop/O%3A1.nc");
    EXPECT_EQ(file_uri("//server/shop/O1.nc"), "file://server/shop/O1.nc");
}

TEST(Fixes, AllAreInTheReportTheBestFirst) {
    HandMade made("O1.nc", "O1\nGOTO 9\nM30\n");
    Finding& finding = made.add("GOTO 9", Severity::warning);
    finding.offer({"Name another", Applicability::safe, {{made.source(), made.place_of("9"), "8"}}});
    EXPECT_FALSE(json::parse(write_json(made.report()))["findings"][0].contains("other_fixes"));
    finding.offer(
        {"Remove the jump", Applicability::unsafe, {{made.source(), made.place_of("GOTO 9\n"), ""}}});
    const json fixes = first_result(made)["fixes"];
    ASSERT_EQ(fixes.size(), 2U);
    EXPECT_EQ(fixes[0]["description"]["text"], "Name another.");
    EXPECT_EQ(fixes[1]["properties"]["applicability"], "unsafe");
    const json out = json::parse(write_json(made.report()))["findings"][0];
    EXPECT_EQ(out["fix_title"], "Name another");
    EXPECT_EQ(out["fix_applicability"], "safe");
    EXPECT_EQ(out["fix"][0]["text"], "8");
    ASSERT_EQ(out["other_fixes"].size(), 1U);
    EXPECT_EQ(out["other_fixes"][0]["title"], "Remove the jump");
    EXPECT_EQ(out["other_fixes"][0]["applicability"], "unsafe");
    EXPECT_EQ(out["other_fixes"][0]["edits"][0]["range"]["end"]["line"], 3);
}

TEST(Json, HoldsFindingsSuppressedOnesAndTheSummary) {
    HandMade made("O1.nc", "O1\nM30\nM30\n");
    made.add("M30", Severity::error);
    made.add("O1", Severity::note);
    made.report().findings[1].suppressed = Suppression{{0, 2}, "WANTED"};
    const json out = json::parse(write_json(made.report()));
    EXPECT_EQ(out["version"], 1);
    ASSERT_EQ(out["findings"].size(), 1U);
    EXPECT_EQ(out["findings"][0]["code"], "MAC002");
    EXPECT_EQ(out["findings"][0]["range"]["start"]["line"], 2);
    EXPECT_EQ(out["findings"][0]["range"]["bytes"][0], 3);
    EXPECT_EQ(out["suppressed"][0]["suppressed"]["reason"], "WANTED");
    EXPECT_EQ(out["summary"]["errors"], 1);
    EXPECT_EQ(out["summary"]["suppressed"], 1);
}

} // namespace
} // namespace maclint::cli
