//! Lists in the fields of rows: words that blanks separate.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

[[nodiscard]] std::vector<std::string_view> words_of(std::string_view list);

[[nodiscard]] bool has_word(std::string_view list, std::string_view word);

/// 83 of "G83".
[[nodiscard]] double code_number_of(std::string_view code);

/// "X", "X or Z", "X, Z or PZ".
[[nodiscard]] std::string either_of(std::string_view list);
/// "X, Z and PZ".
[[nodiscard]] std::string all_of(std::string_view list);

} // namespace maclint
