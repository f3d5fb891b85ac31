//! Words in one case: users write them in any.
#pragma once

#include <string>
#include <string_view>

namespace maclint::cli {

[[nodiscard]] std::string in_lower_case(std::string_view text);
[[nodiscard]] std::string in_upper_case(std::string_view text);

} // namespace maclint::cli
