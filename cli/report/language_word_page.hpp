//! What a word of a language means: for `explain`.
#pragma once

#include "analyzer/dialect/dialect.hpp"
#include "cli/report/plain_page.hpp"

#include <string>
#include <string_view>

namespace maclint::cli {

/// A page on the keyword, the function, the cycle, the variable that has a name and so on, in capitals or
/// not; empty where the language has no such word.
[[nodiscard]] std::string plain_language_word_page(const Dialect& dialect, std::string_view word,
                                                   const PageStyle& style);

} // namespace maclint::cli
