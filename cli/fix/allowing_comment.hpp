//! Comments that allow findings, as a language writes comments.
#pragma once

#include "rules/finding.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {
struct Dialect;
}

namespace maclint::cli {

/// "(MACLINT ALLOW MAC301 - PROVEN)"; in capitals where the language has no small letters in its comments.
/// `reason` may be empty.
[[nodiscard]] std::string allowing_comment(const Dialect& dialect, const std::vector<std::string>& codes,
                                           std::string_view reason);

/// Where such a comment goes in a line: before the mark that ends a block and blanks.
[[nodiscard]] std::size_t end_of_words(std::string_view line);

/// Writes it, without a reason, at the end of the line that holds the place.
[[nodiscard]] Edit allowing_edit(const std::shared_ptr<const Source>& source, Offset place,
                                 const Dialect& dialect, const std::vector<std::string>& codes);

} // namespace maclint::cli
