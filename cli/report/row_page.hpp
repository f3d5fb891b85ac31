//! What users read of the rows of rules: tables, lists, and a page for each.
#pragma once

#include "cli/report/plain_page.hpp"
#include "rules/words/rule_row.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace maclint::cli {

/// The rows of the rule as a chapter of its page; empty where it has none.
[[nodiscard]] std::string markdown_rows(const Rule& rule);
[[nodiscard]] std::string plain_rows(const Rule& rule, const PageStyle& style);

/// The rows, as beside the rules of a list, in so many columns; 0: the reader wraps lines.
[[nodiscard]] std::string list_of_rows(std::span<const RuleRow* const> rows, std::size_t width);
/// Those of one rule, under its own lines.
[[nodiscard]] std::string list_below(const Rule& rule, std::size_t width);

/// Where the row holds: "fanuc mills, on fanuc-30i, under G41 or G42".
[[nodiscard]] std::string where_of(const RowForCode& row);

/// Lines (from 1) of the bad example of each entry of a row at which it has its findings.
using MarkedRows = std::vector<std::vector<std::uint32_t>>;
[[nodiscard]] std::string plain_row_page(const RuleRow& row, const PageStyle& style,
                                         const MarkedRows& marked);

} // namespace maclint::cli
