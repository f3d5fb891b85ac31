//! The whole of maclint on text in memory, and the parser alone: the two things that benchmarks compare.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::bench {

/// Reads, analyses and runs all default rules over the files as one workspace; the number of findings.
[[nodiscard]] std::size_t lint(const std::vector<std::string>& files, std::string_view dialect = "fanuc");

/// The same with a rule more, which looks at the value of every word.
[[nodiscard]] std::size_t lint_every_value(const std::vector<std::string>& files,
                                           std::string_view dialect = "fanuc");

/// The same with a thousand rows of the table of words more, ten for each G code below 100.
[[nodiscard]] std::size_t lint_thousand_rows(const std::vector<std::string>& files);

/// tree-sitter with our grammar of the dialect on the text in one piece; the number of nodes under the root.
[[nodiscard]] std::size_t parse_in_one_piece(const std::string& text, std::string_view dialect = "fanuc");

} // namespace maclint::bench
