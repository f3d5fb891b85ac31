//! What remarks of a program say of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace maclint::fanuc {

/// Whether a remark at the head of the text shows how program `number` is called: `(G65 P9993 A B C)`.
[[nodiscard]] bool shows_own_call(std::string_view text, std::int64_t number);

/// Whether a remark begins with the '#' at `at`, as on a PC: words for people up to the end of its line, and
/// nothing like a variable with a name.
[[nodiscard]] bool begins_sharp_remark(std::string_view text, std::size_t at);

/// Whether the `;` at `at` stands in a remark that holds brackets, which opens at `open`: `(A(B) C; D)`. The
/// remark ends at its first ')' all the same.
[[nodiscard]] bool is_in_nested_remark(std::string_view text, std::size_t open, std::size_t at);

} // namespace maclint::fanuc
