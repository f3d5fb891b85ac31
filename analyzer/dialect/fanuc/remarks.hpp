//! What remarks of a program say of it.
#pragma once

#include <cstdint>
#include <string_view>

namespace maclint::fanuc {

/// Whether a remark at the head of the text shows how program `number` is called: `(G65 P9993 A B C)`.
[[nodiscard]] bool shows_own_call(std::string_view text, std::int64_t number);

} // namespace maclint::fanuc
