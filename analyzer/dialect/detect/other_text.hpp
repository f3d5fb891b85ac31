//! Text that is no NC program of any kind.
#pragma once

#include <optional>
#include <string_view>

namespace maclint::detect {

/// "JSON", "C source"; nothing for what may be an NC program.
[[nodiscard]] std::optional<std::string_view> find_other_text(std::string_view text);

} // namespace maclint::detect
