//! A rule can be read alone: it is short, asks queries and its finders, and neither reads value tables nor
//! walks the graph.
#include "analyzer/program/tables.hpp"
#include "tests/structure/project_files.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::structure {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::ptrdiff_t most_lines = 125; ///< beside its includes and the programs that want exemptions
/// Lists of rows are as long as there is something to say.
bool is_list(std::string_view path) {
    return path == "rules/registry.cpp" || path.starts_with("rules/words/tables_") ||
           path.starts_with("rules/alarms/tables_") || path.starts_with("rules/words/dinplus/") ||
           path.starts_with("rules/words/fanuc/");
}

std::vector<ProjectFile> files_of_rules() {
    std::vector<ProjectFile> files = sources();
    std::erase_if(files, [](const ProjectFile& file) { return !file.path.starts_with("rules/"); });
    return files;
}

/// Records and checks. A finder is as long as its question, reads value tables and walks.
std::vector<ProjectFile> without_finders(std::vector<ProjectFile> files) {
    std::erase_if(files, [](const ProjectFile& file) { return is_finder(file.path); });
    return files;
}

std::vector<ProjectFile> rule_files() { return without_finders(files_of_rules()); }

/// Finders beside which no rule of their name stands: rules/flow/a_finder.hpp belongs to rules/flow/a.cpp,
/// and so does rules/flow/a_ways_finder.hpp.
std::vector<std::string> finders_without_rule(const std::vector<ProjectFile>& files) {
    const auto belongs = [](std::string_view finder, std::string_view rule) {
        if (!rule.ends_with(".cpp") || is_finder(rule)) return false;
        rule.remove_suffix(std::string_view(".cpp").size());
        return finder.starts_with(rule) && finder.substr(rule.size()).starts_with('_');
    };
    std::vector<std::string> found;
    for (const ProjectFile& file : files)
        if (is_finder(file.path) && std::ranges::none_of(files, [&](const ProjectFile& rule) {
                return belongs(file.path, rule.path);
            }))
            found.push_back(file.path);
    return found;
}

/// Finders that two files with a record include: such a question belongs in a room of the queries.
std::vector<std::string> shared_finders(const std::vector<ProjectFile>& files) {
    std::map<std::string, int> asked;
    for (const ProjectFile& file : files) {
        if (file.text.find(".code = \"") == std::string::npos) continue;
        for (const std::string& include : quoted_includes(file.text))
            if (is_finder(include)) ++asked[include];
    }
    std::vector<std::string> found;
    for (const auto& [finder, times] : asked)
        if (times > 1) found.push_back(finder);
    return found;
}

std::ptrdiff_t count_of(std::string_view text, std::string_view part) {
    std::ptrdiff_t count = 0;
    for (auto at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++count;
    return count;
}

/// The lines of a record that list exemptions: as many as there are to tell.
std::ptrdiff_t lines_of_exemptions(std::string_view text) {
    const auto begin = text.find("\n    .exemptions =");
    if (begin == std::string_view::npos) return 0;
    const auto end = text.find("\n    .", begin + 1);
    return std::ranges::count(text.substr(begin, end - begin), '\n');
}

std::vector<std::string> too_long(const std::vector<ProjectFile>& files) {
    std::vector<std::string> found;
    for (const ProjectFile& file : files) {
        const auto lines = std::ranges::count(file.text, '\n') - count_of(file.text, "\n#include ") -
                           lines_of_exemptions(file.text);
        if (lines > most_lines && !is_list(file.path))
            found.push_back(file.path + " has " + std::to_string(lines) + " lines");
    }
    return found;
}

/// The files whose code, comments left out, holds one of the texts. At a letter that begins one a word has to
/// begin: "Symbol" is no part of "aSymbol".
std::vector<std::string> holding(const std::vector<ProjectFile>& files,
                                 const std::vector<std::string_view>& texts) {
    const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0; };
    std::vector<std::string> found;
    for (const ProjectFile& file : files) {
        const std::string code = without_comments(file.text);
        for (const std::string_view text : texts)
            for (auto at = code.find(text); at != std::string::npos; at = code.find(text, at + 1)) {
                if (at != 0 && is_letter(text.front()) && is_letter(code[at - 1])) continue;
                found.push_back(file.path + " holds " + std::string(text));
                break;
            }
    }
    return found;
}

const std::vector<std::string_view> value_tables = {"table()",  "ValueTable", "Symbol",        ".symbol",
                                                    "->symbol", "Interner",   "data().origin("};
const std::vector<std::string_view> walks = {".out[", ".in[", "passable(", "graph().path("};
const std::vector<std::string_view> other_programs = {"workspace().programs()["};
const std::vector<std::string_view> languages = {"control().language", "control->language"};

/// How long a file is and whose language it is are asked for in one place each.
std::vector<ProjectFile> checks_of_rules() {
    std::vector<ProjectFile> files = files_of_rules();
    // It writes down the severity that a record names for a language.
    std::erase_if(files, [](const ProjectFile& file) { return file.path == "rules/reporter.cpp"; });
    return files;
}

TEST(RuleFiles, AreShortEnoughToBeReadAlone) {
    EXPECT_THAT(rule_files(), SizeIs(testing::Gt(90U)));
    EXPECT_THAT(too_long(rule_files()), IsEmpty());
}

TEST(RuleFiles, ReadNoValueTables) { EXPECT_THAT(holding(rule_files(), value_tables), IsEmpty()); }

TEST(RuleFiles, WalkNoGraph) { EXPECT_THAT(holding(rule_files(), walks), IsEmpty()); }

TEST(RuleFiles, AskQueriesForOtherPrograms) { EXPECT_THAT(holding(rule_files(), other_programs), IsEmpty()); }

TEST(RuleFiles, HaveFindersBesideThem) {
    EXPECT_THAT(files_of_rules(), SizeIs(testing::Gt(rule_files().size())));
    EXPECT_THAT(finders_without_rule(files_of_rules()), IsEmpty());
}

TEST(RuleFiles, AskFindersOfTheirOwn) { EXPECT_THAT(shared_finders(files_of_rules()), IsEmpty()); }

TEST(RuleFiles, AskNotWhichLanguageTheyLookAt) {
    EXPECT_THAT(holding(checks_of_rules(), languages), IsEmpty());
}

TEST(RuleFilesCheck, FindsALongFileButNotTheRegistry) {
    const std::string lines = std::string(126, '\n') + "\n#include <span>";
    const std::string exemptions =
        "\n    .exemptions = {\n{},\n},\n    .sources = {}\n"; // 3 lines that do not count
    EXPECT_THAT(too_long({{"rules/flow/a.cpp", lines},
                          {"rules/flow/b.cpp", lines.substr(1)},
                          {"rules/flow/c.cpp", lines.substr(3) + exemptions},
                          {"rules/flow/d.cpp", lines.substr(2) + exemptions},
                          {"rules/registry.cpp", lines}}),
                ElementsAre("rules/flow/a.cpp has 126 lines", "rules/flow/d.cpp has 126 lines"));
}

TEST(RuleFilesCheck, AsksFindersForNoLength) {
    const std::string lines(200, '\n');
    EXPECT_THAT(too_long(without_finders({{"rules/flow/a_finder.cpp", lines},
                                          {"rules/flow/a_finders.cpp", lines},
                                          {"rules/flow/finder.cpp", lines}})),
                ElementsAre("rules/flow/a_finders.cpp has 200 lines", "rules/flow/finder.cpp has 200 lines"));
}

TEST(RuleFilesCheck, FindsAFinderBesideWhichItsRuleDoesNotStand) {
    EXPECT_THAT(finders_without_rule({{"rules/flow/a.cpp", ""},
                                      {"rules/flow/a_finder.hpp", ""},
                                      {"rules/flow/a_ways_finder.cpp", ""},
                                      {"rules/flow/ab_finder.cpp", ""},
                                      {"rules/calls/a_finder.cpp", ""}}),
                ElementsAre("rules/flow/ab_finder.cpp", "rules/calls/a_finder.cpp"));
}

TEST(RuleFilesCheck, FindsAFinderThatTwoRulesAsk) {
    const std::string a = "#include \"rules/flow/a_finder.hpp\"\n";
    const std::string b = "#include \"rules/flow/b_finder.hpp\"\n";
    const std::string record = "extern const Rule rule{.code = \"MAC000\"};\n";
    EXPECT_THAT(shared_finders({{"rules/flow/a.cpp", a + b + record},
                                {"rules/flow/b.cpp", b + record},
                                {"rules/flow/words.hpp", a},
                                {"rules/flow/a_finder.cpp", a}}),
                ElementsAre("rules/flow/b_finder.hpp"));
}

TEST(RuleFilesCheck, FindsValueTablesInCodeButNotInComments) {
    const std::vector<ProjectFile> files = {
        {"rules/a.cpp", "const auto& s = analysis.data().table().symbols[value.symbol];"},
        {"rules/b.cpp", "// the Symbol of its value\nsymbolic(value);"},
        {"rules/c.cpp", "dataflow::SymbolId id;"}};
    EXPECT_THAT(
        holding(files, value_tables),
        ElementsAre("rules/a.cpp holds table()", "rules/a.cpp holds .symbol", "rules/c.cpp holds Symbol"));
}

TEST(RuleFilesCheck, FindsAWalkOverTheGraph) {
    EXPECT_THAT(holding({{"rules/a.cpp", "for (auto id : analysis.graph().out[node]) visit(id);"}}, walks),
                ElementsAre("rules/a.cpp holds .out["));
}

} // namespace
} // namespace maclint::structure
