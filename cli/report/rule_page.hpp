//! A rule's page: what `explain` shows, `rules --write-docs` writes and SARIF carries as help.
#pragma once

#include "cli/report/measured_precision.hpp"
#include "cli/report/plain_page.hpp"
#include "rules/rule.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// The file of markdown_index(), and the sentence in it by which a folder of pages is known again.
inline constexpr std::string_view index_name = "README.md";
inline constexpr std::string_view generated_mark = "Made from the rules by `maclint rules --write-docs`.";

/// Markdown with a heading of the first level.
[[nodiscard]] std::string markdown_page(const Rule& rule);
/// Lines (from 1) of each bad example that the rule speaks of.
using MarkedLines = std::vector<std::vector<std::uint32_t>>;

/// The same for a terminal or a plain-text viewer.
[[nodiscard]] std::string plain_page(const Rule& rule, const PageStyle& style, const MarkedLines& marked);
enum class ListedRows : std::uint8_t { left_out, shown };
/// The rules by their families, with their rows, in so many columns; 0: the reader wraps lines. What a rule
/// or a row says stands below its name.
[[nodiscard]] std::string plain_list(std::span<const Rule* const> rules, ListedRows rows, std::size_t width);
/// What stands below a name in such a list.
[[nodiscard]] std::string below_name(std::string_view text, std::size_t width);
/// Table of all rules with links to their pages.
[[nodiscard]] std::string markdown_index();

/// "MAC303.md".
[[nodiscard]] std::string page_name(const Rule& rule);
/// Address of the folder of pages; empty until one is published (MACLINT_HELP_BASE_URL of the build).
[[nodiscard]] std::string_view help_base();
/// Of the rule's page; empty where none is published.
[[nodiscard]] std::string page_url(const Rule& rule);
/// "loops and jumps".
[[nodiscard]] std::string_view family_of(const Rule& rule);
/// "very-high".
[[nodiscard]] std::string_view name_of(Precision precision);
/// How precise the rule is and on what that rests: findings that were read (nullptr: too few of them), or
/// what its author expects.
[[nodiscard]] std::string precision_of(const Rule& rule, const MeasuredRule* entry);
/// The summary as a sentence.
[[nodiscard]] std::string summary_sentence(const Rule& rule);

} // namespace maclint::cli
