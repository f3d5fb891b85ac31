//! Reports for build services: their structure, and texts that could break it.
#include "analyzer/source/encoding.hpp"
#include "cli/report/service.hpp"
#include "cli/report/statistics.hpp"
#include "cli/report/xml.hpp"
#include "rules/rule.hpp"
#include "tests/cli/reports.hpp"
#include "tests/support/lines.hpp"

#include <algorithm>
#include <filesystem>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace maclint::cli {
namespace {

using nlohmann::json;
using test::HandMade;
using test::lines_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A path and a text with all that formats have to escape, and with bytes that are no UTF-8.
HandMade nasty() {
    HandMade made("O1,a:b%<&\">\x01\r\n\xFF.nc", "O1\nGOTO9(\x02<&\">%\xFF)\nM30\n");
    made.add("GOTO9(\x02<&\">%\xFF)", Severity::error).arguments = {"\x02<&\">%\r\n\xEF\xBF\xBE"};
    return made;
}

/// The elements of XML as "<name", "/name", or what is wrong with it.
std::vector<std::string> elements_of(const std::string& xml) {
    std::vector<std::string> elements, open;
    for (std::size_t at = xml.find('<'); at != std::string::npos; at = xml.find('<', at + 1)) {
        const std::string tag = xml.substr(at + 1, xml.find('>', at) - at - 1);
        if (tag.starts_with('?')) continue;
        if (std::ranges::count(tag, '"') % 2 != 0) return {"open quotes: " + tag};
        const std::string name = tag.substr(0, tag.find_first_of(" /", 1));
        elements.push_back(name);
        if (tag.starts_with('/')) {
            if (open.empty() || "/" + open.back() != tag) return {"not open: " + tag};
            open.pop_back();
        } else if (!tag.ends_with('/')) {
            open.push_back(name);
        }
    }
    return open.empty() ? elements : std::vector<std::string>{"not closed: " + open.back()};
}

void expect_clean(const std::string& text) {
    EXPECT_EQ(to_utf8(text, Encoding::utf8), text);
    for (const char c : text) EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20) << text;
}

TEST(Xml, EscapesAndLeavesOutWhatItHasNoPlaceFor) {
    EXPECT_EQ(xml_escaped("a<b>&\"c\"\tx\ny"), "a&lt;b&gt;&amp;&quot;c&quot;&#9;x\ny");
    EXPECT_EQ(xml_escaped(std::string("\0\x1B", 2)), "\\x00\\x1B");
    EXPECT_EQ(xml_escaped("a\r\nb"), "a&#13;\nb");
    EXPECT_EQ(xml_escaped("\uFFFD\uFFFE\uFFFF"), "\uFFFD\\u{FFFE}\\u{FFFF}");
    EXPECT_EQ(xml_escaped("\xED\xA0\x80 \xC0\xAF"),
              "\uFFFD\uFFFD\uFFFD \uFFFD\uFFFD");                           // a surrogate, overlong
    EXPECT_EQ(xml_escaped("\xF4\x90\x80\x80"), "\uFFFD\uFFFD\uFFFD\uFFFD"); // above U+10FFFF
    EXPECT_EQ(xml_attribute("name", "a\"b"), " name=\"a&quot;b\"");
}

/// "Char" of XML 1.0 (fifth edition), production 2.
bool is_xml_char(char32_t c) {
    return c == 0x9 || c == 0xA || c == 0xD || (c >= 0x20 && c <= 0xD7FF) || (c >= 0xE000 && c <= 0xFFFD) ||
           (c >= 0x10000 && c <= 0x10FFFF);
}

std::string utf8_of(char32_t c) {
    const auto byte = [](char32_t value) { return static_cast<char>(value); };
    const auto tail = [&](unsigned shift) { return byte(0x80U | ((c >> shift) & 0x3FU)); };
    if (c < 0x80) return {byte(c)};
    if (c < 0x800) return {byte(0xC0U | (c >> 6U)), tail(0)};
    if (c < 0x10000) return {byte(0xE0U | (c >> 12U)), tail(6), tail(0)};
    return {byte(0xF0U | (c >> 18U)), tail(12), tail(6), tail(0)};
}

TEST(Xml, HoldsNoCharacterThatItHasNoPlaceForWhateverThePrograms) {
    for (char32_t c = 0; c <= 0x10FFFF; ++c) {
        const std::string escaped = xml_escaped(utf8_of(c));
        for (std::string_view rest = escaped; !rest.empty();) {
            const auto [character, length] = first_character(rest);
            ASSERT_TRUE(is_xml_char(character)) << std::hex << static_cast<std::uint32_t>(c);
            rest.remove_prefix(length);
        }
        const bool is_markup = c == '&' || c == '<' || c == '>' || c == '"' || c == '\t' || c == '\r';
        const bool is_surrogate = c >= 0xD800 && c <= 0xDFFF;
        if (is_xml_char(c) && !is_markup && !is_surrogate) {
            ASSERT_EQ(escaped, utf8_of(c));
        }
    }
}

TEST(XmlReports, ShowNoncharactersAsEscapes) {
    HandMade made("O\uFFFF.nc", "O1\nGOTO9(\uFFFE)\nM30\n");
    made.add("GOTO9(\uFFFE)", Severity::error).arguments = {"\uFFFE \U0001FFFF \uFDD0 \xED\xA0\x80"};
    for (const std::string& xml : {write_junit(made.report(), {}), write_checkstyle(made.report())}) {
        EXPECT_THAT(xml, HasSubstr("O\\u{FFFF}.nc"));
        EXPECT_THAT(xml, HasSubstr("'\\u{FFFE} \\u{1FFFF} \\u{FDD0} \uFFFD\uFFFD\uFFFD'"));
        EXPECT_THAT(xml, Not(HasSubstr("\xEF\xBF\xBE")));
        EXPECT_THAT(xml, Not(HasSubstr("\xEF\xBF\xBF")));
    }
}

TEST(Github, WritesACommandForEachFinding) {
    HandMade made("mill/O1.nc", "O1\nGOTO 9\nM30\n");
    Finding& finding = made.add("GOTO 9", Severity::warning);
    finding.related.push_back({made.source(), made.place_of("M30"), "it ends here"});
    made.add("M30", Severity::note).span = {3, 13}; // two lines
    made.add("O1", Severity::error);
    EXPECT_THAT(
        lines_of(write_github(made.report(), {})),
        ElementsAre("::warning file=mill/O1.nc,line=2,endLine=2,col=1,endColumn=7,title=MAC002 "
                    "unknown-rule-in-suppression::Unknown rule: there is no 'GOTO 9'. See 'maclint rules' "
                    "for the list.%0Amill/O1.nc:3: it ends here",
                    StartsWith("::notice file=mill/O1.nc,line=2,endLine=3,title=MAC002"),
                    StartsWith("::error file=mill/O1.nc,line=1,endLine=1,col=1,endColumn=3,title="),
                    "1 error, 1 warning, 1 note in 1 file (1 checked)"));
    TextStyle quiet;
    quiet.summary = Summary::left_out;
    quiet.path = PathDetail::none;
    EXPECT_THAT(write_github(made.report(), quiet), Not(HasSubstr("checked")));
    EXPECT_THAT(write_github(made.report(), quiet), Not(HasSubstr("it ends here")));
}

TEST(Github, SaysWhichConditionAStepIsAbout) {
    HandMade made("O1.nc", "O1\nIF[#13EQ0]GOTO 5\nGOTO 9\nN5 M30\n");
    made.add("GOTO 9", Severity::error).path = {{made.source(), made.place_of("[#13EQ0]"), "false"},
                                                {made.source(), made.place_of("GOTO 9"), ""}};
    EXPECT_THAT(write_github(made.report(), {}), HasSubstr("%0AO1.nc:2: '[#13EQ0]' is false"));
}

TEST(Github, EscapesWhatEndsAMessageOrAProperty) {
    HandMade made = nasty();
    const std::string text = write_github(made.report(), {});
    expect_clean(text);
    EXPECT_THAT(text, StartsWith("::error file=O1%2Ca%3Ab%25<&\">\\x01\\r\\n\xC3\xBF.nc,line=2,"));
    EXPECT_THAT(text, HasSubstr("'\\x02<&\">%25\\r\\n"));
}

TEST(Gitlab, WritesIssuesThatAreToldApart) {
    HandMade made("O1.nc", "O1\nM30\nM30\n");
    made.add("M30", Severity::error);
    made.add("M30", Severity::warning).span = {7, 10};
    made.add("O1", Severity::note);
    made.report().findings.push_back(made.report().findings.front());
    made.report().findings.back().suppressed = Suppression{{0, 2}, "WANTED"};
    const json issues = json::parse(write_gitlab(made.report(), {}));
    ASSERT_EQ(issues.size(), 3U);
    EXPECT_EQ(issues[0]["check_name"], "MAC002");
    EXPECT_EQ(issues[0]["severity"], "critical");
    EXPECT_EQ(issues[1]["severity"], "major");
    EXPECT_EQ(issues[2]["severity"], "info");
    EXPECT_EQ(issues[1]["location"], (json{{"path", "O1.nc"}, {"lines", {{"begin", 3}, {"end", 3}}}}));
    EXPECT_EQ(issues[0]["description"], "Unknown rule: there is no 'M30'. See 'maclint rules' for the list.");
    std::set<std::string> prints;
    for (const json& issue : issues) prints.insert(issue["fingerprint"].get<std::string>());
    EXPECT_EQ(prints.size(), 3U);
    HandMade other("O2.nc", "O1\nM30\nM30\n");
    other.add("M30", Severity::error);
    EXPECT_NE(json::parse(write_gitlab(other.report(), {}))[0]["fingerprint"], issues[0]["fingerprint"]);
    HandMade none("O1.nc", "O1\n");
    EXPECT_EQ(write_gitlab(none.report(), {}), "[]\n");
}

TEST(Gitlab, KnowsAnIssueAgainHoweverItsFileIsNamed) {
    const auto prints = [](const std::string& path) {
        HandMade made(path, "O1\nM30\n");
        made.add("M30", Severity::error);
        made.report().notices = {{NoticeKind::unreadable, path, "there is no such file"}};
        const json issues = json::parse(write_gitlab(made.report(), {}));
        EXPECT_EQ(issues.size(), 2U);
        return std::vector<json>{issues[0]["location"]["path"], issues[0]["fingerprint"],
                                 issues[1]["location"]["path"], issues[1]["fingerprint"]};
    };
    EXPECT_EQ(prints("mill/O1.nc"), prints((std::filesystem::current_path() / "mill/O1.nc").string()));
    EXPECT_NE(prints("mill/O1.nc")[1], prints("O1.nc")[1]);
}

TEST(Gitlab, IsJsonWhateverTheTextsAre) {
    HandMade made = nasty();
    const std::string text = write_gitlab(made.report(), {});
    expect_clean(text);
    EXPECT_EQ(json::parse(text)[0]["location"]["path"], "O1,a:b%<&\">\\x01\\r\\n\xC3\xBF.nc");
}

TEST(Junit, HasASuiteForEachFileAndACaseForEachFinding) {
    HandMade made("O1.nc", "O1\nM30\n");
    made.report().fail_on = Severity::warning;
    made.add("M30", Severity::error);
    made.add("M30", Severity::error); // the same once more
    made.add("O1", Severity::note);
    const auto clean = std::make_shared<const Source>(Source::from_bytes("O2.nc", "O2\n"));
    made.report().files.push_back(clean);
    const std::string text = write_junit(made.report(), {});
    const std::string message = "Unknown rule: there is no 'M30'. See 'maclint rules' for the list.";
    EXPECT_THAT(text, HasSubstr(R"(<testsuites name="maclint" tests="4" failures="2" errors="0">)"));
    EXPECT_THAT(text, HasSubstr(R"(<testsuite name="O1.nc" tests="3" failures="2" errors="0" skipped="1")"));
    EXPECT_THAT(text, HasSubstr("<testcase classname=\"maclint.MAC002\" name=\"O1.nc:2:1 "
                                "unknown-rule-in-suppression\" time=\"0\">\n      <failure type=\"error\" "
                                "message=\"" +
                                message + "\">O1.nc:2:1: " + message + "</failure>"));
    EXPECT_THAT(text, HasSubstr("unknown-rule-in-suppression (2)\""));
    EXPECT_THAT(text, HasSubstr(R"(<skipped type="note")"));
    EXPECT_THAT(text, HasSubstr(R"(<testcase classname="maclint.checked" name="O2.nc" time="0"/>)"));
    made.report().fail_on.reset();
    EXPECT_THAT(write_junit(made.report(), {}), HasSubstr(R"(tests="4" failures="0")"));
}

TEST(Checkstyle, ListsAllFilesWithTheirErrors) {
    HandMade made("mill/O1.nc", "O1\nM30\n");
    made.add("M30", Severity::warning);
    made.add("O1", Severity::note);
    made.report().files.push_back(std::make_shared<const Source>(Source::from_bytes("O2.nc", "O2\n")));
    EXPECT_THAT(
        lines_of(write_checkstyle(made.report())),
        ElementsAre(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>", "<checkstyle version=\"4.3\">",
            "  <file name=\"mill/O1.nc\">",
            "    <error line=\"2\" column=\"1\" severity=\"warning\" message=\"Unknown rule: there is "
            "no 'M30'. See 'maclint rules' for the list.\" "
            "source=\"maclint.input-and-suppressions.MAC002\"/>",
            testing::AllOf(StartsWith("    <error line=\"1\""), HasSubstr("severity=\"info\"")), "  </file>",
            "  <file name=\"O2.nc\"/>", "</checkstyle>"));
}

TEST(XmlReports, AreWellFormedWhateverTheTextsAre) {
    HandMade made = nasty();
    made.report().fail_on = Severity::warning;
    made.report().notices = {{NoticeKind::unreadable, "gone<\x01&.nc", "there is \"no\" <such> file\x1B"},
                             {NoticeKind::left_out, "", "a note that services need not hear"}};
    const std::string checkstyle = write_checkstyle(made.report());
    expect_clean(checkstyle);
    EXPECT_THAT(elements_of(checkstyle),
                ElementsAre("checkstyle", "file", "error", "/file", "file", "error", "/file", "/checkstyle"));
    const std::string junit = write_junit(made.report(), {});
    expect_clean(junit);
    for (const std::string& text : {checkstyle, junit}) EXPECT_THAT(text, Not(HasSubstr("\xEF\xBF\xBE")));
    EXPECT_THAT(elements_of(junit), ElementsAre("testsuites", "testsuite", "testcase", "error", "/error",
                                                "/testcase", "/testsuite", "testsuite", "testcase", "failure",
                                                "/failure", "/testcase", "/testsuite", "/testsuites"));
}

TEST(ServiceReports, LeaveOutWhatACommentAllows) {
    HandMade made("O1.nc", "O1\nM30\n");
    made.add("M30", Severity::error);
    made.report().findings.back().suppressed = Suppression{{0, 2}, "WANTED"};
    EXPECT_EQ(write_github(made.report(), {.summary = Summary::left_out}), "");
    EXPECT_EQ(write_gitlab(made.report(), {}), "[]\n");
    EXPECT_THAT(write_junit(made.report(), {}), HasSubstr("maclint.checked"));
    EXPECT_THAT(write_checkstyle(made.report()), HasSubstr("<file name=\"O1.nc\"/>"));
}

TEST(ServiceReports, TellOfWhatTheRunCouldNotDo) {
    HandMade made("O1.nc", "O1\n");
    made.report().notices = {{NoticeKind::unreadable, "gone.nc", "there is no such file"},
                             {NoticeKind::configuration, "", "something is wrong"},
                             {NoticeKind::left_out, "x", "a note"}};
    EXPECT_THAT(lines_of(write_github(made.report(), {})),
                ElementsAre("::error title=maclint,file=gone.nc::there is no such file",
                            "::error title=maclint::something is wrong", "no findings (1 checked)"));
    const json issues = json::parse(write_gitlab(made.report(), {}));
    ASSERT_EQ(issues.size(), 2U);
    EXPECT_EQ(issues[0]["severity"], "blocker");
    EXPECT_NE(issues[0]["fingerprint"], issues[1]["fingerprint"]);
    EXPECT_THAT(write_junit(made.report(), {}), HasSubstr("errors=\"2\""));
    EXPECT_THAT(write_checkstyle(made.report()), HasSubstr("message=\"something is wrong\""));
}

TEST(Statistics, CountFindingsByRuleAndByFile) {
    HandMade made("O1.nc", "O1\nM30\n");
    made.add("M30", Severity::error);
    made.add("M30", Severity::warning);
    made.add("O1", Severity::warning);
    made.add("O1", Severity::warning);
    made.report().findings.back().suppressed = Suppression{{0, 2}, "WANTED"};
    Report& report = made.report();
    report.not_shown.push_back(report.findings[1]);
    const std::string table = "findings by rule:\n"
                              "  3  MAC002 unknown-rule-in-suppression (warning)\n"
                              "  1  MAC002 unknown-rule-in-suppression (error)\n"
                              "findings by file:\n"
                              "  4  O1.nc\n";
    EXPECT_EQ(statistics_text(report), table);
    EXPECT_FALSE(json::parse(write_json(report)).contains("statistics"));
    EXPECT_THAT(write_concise(report, {}), Not(HasSubstr("by rule")));
    report.statistics = true;
    EXPECT_THAT(write_concise(report, {}), HasSubstr(table + "1 error, 3 warnings"));
    EXPECT_THAT(write_text(report, {}), HasSubstr(table));
    const json statistics = json::parse(write_json(report))["statistics"];
    EXPECT_EQ(statistics["rules"][0]["findings"], 3);
    EXPECT_EQ(statistics["rules"][0]["code"], "MAC002");
    EXPECT_EQ(statistics["files"][0], (json{{"file", "O1.nc"}, {"findings", 4}}));
}

TEST(Statistics, NameTheFilesWithMostFindingsAndCountTheOthers) {
    HandMade made("O1.nc", "O1\nM30\n");
    for (int i = 10; i < 32; ++i) {
        made.add("M30", Severity::error).source =
            std::make_shared<const Source>(Source::from_bytes("O" + std::to_string(i) + ".nc", "O1\nM30\n"));
        if (i == 31) made.report().findings.push_back(made.report().findings.back());
    }
    const std::string text = statistics_text(made.report());
    EXPECT_THAT(text, HasSubstr("findings by file:\n  2  O31.nc\n  1  O10.nc\n"));
    EXPECT_THAT(text, testing::EndsWith("  1  O28.nc\n  and 2 more files\n"));
    EXPECT_EQ(statistics_of(made.report()).files.size(), 22U);
    HandMade none("O1.nc", "O1\n");
    EXPECT_EQ(statistics_text(none.report()), "findings by rule:\n  none\nfindings by file:\n  none\n");
}

} // namespace
} // namespace maclint::cli
