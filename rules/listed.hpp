//! Lists as a sentence has them.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace maclint::rules {

/// "1, 2 or 3", where `last` is " or ".
[[nodiscard]] std::string listed(std::span<const std::string> words, std::string_view last);

} // namespace maclint::rules
