//! Text that is no NC program of any kind.
#pragma once

#include <optional>
#include <string_view>

namespace maclint::detect {

/// "JSON", "C source", "Python source"; nothing for what may be an NC program.
[[nodiscard]] std::optional<std::string_view> find_other_text(std::string_view text);

/// "PNG image", by the first bytes of a file that is no text; nothing for what is not known.
[[nodiscard]] std::optional<std::string_view> find_binary_kind(std::string_view bytes);

} // namespace maclint::detect
