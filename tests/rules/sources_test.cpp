//! Every key by which a rule names its source is explained.
#include "cli/report/sources.hpp"
#include "rules/rule.hpp"
#include "rules/words/code_pages.hpp"
#include "rules/words/rule_row.hpp"
#include "tests/support/folder.hpp"

#include <set>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

/// The keys in the first column of the table: "| NCT-171, NCT-173 | …".
std::set<std::string> explained_keys() {
    std::set<std::string> keys;
    std::istringstream lines(test::read_file(std::string(MACLINT_SOURCE_DIR) + "/docs/sources.md"));
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("| ") || line.starts_with("| key ")) continue;
        std::istringstream column(line.substr(2, line.find(" |") - 2));
        for (std::string key; std::getline(column >> std::ws, key, ',');) keys.insert(key);
    }
    return keys;
}

/// "SEED-001" of "SEED-001:206,582", "T" of "T: search order".
std::string key_of(std::string_view source) {
    constexpr std::string_view own = "maclint's own";
    return std::string(source.starts_with(own) ? own : source.substr(0, source.find_first_of(": ")));
}

TEST(Sources, AreExplainedKeyByKey) {
    const auto keys = explained_keys();
    for (const Rule* rule : all_rules())
        for (const std::string_view source : rule->sources)
            EXPECT_TRUE(keys.contains(key_of(source))) << rule->code << ": " << source;
    for (const RuleRow& row : all_rule_rows())
        for (const RowForCode& one : row.rows)
            EXPECT_TRUE(keys.contains(key_of(one.row->source)))
                << row.name() << ": " << one.row->source.view();
    for (const CodePage& page : all_code_pages())
        for (const BookLine& line : page.lines)
            EXPECT_TRUE(line.source.empty() || keys.contains(key_of(line.source))) << line.source.view();
}

TEST(Sources, AreNamedInThePagesOfTheTerminalAsInTheTable) {
    const std::string table = test::read_file(std::string(MACLINT_SOURCE_DIR) + "/docs/sources.md");
    for (const std::string& key : explained_keys())
        EXPECT_THAT(table, testing::HasSubstr(" | " + std::string(cli::document_of(key)) + " |\n")) << key;
    EXPECT_EQ(cli::document_of("SEED-001:206"), cli::document_of("SEED-001"));
    EXPECT_EQ(cli::document_of("SEED"), "");
}

} // namespace
} // namespace maclint
