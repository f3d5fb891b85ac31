//! The program at the head of a text: line noise after it tells nothing about its language.
#pragma once

#include <string_view>

namespace maclint::detect {

/// The text up to the end of its first program, when that is whole: a program number alone in its line, then
/// nothing but blocks up to M02, M30 or M99; or a program name or section word, and the word END. Empty for
/// all other texts.
[[nodiscard]] std::string_view first_program(std::string_view text);

} // namespace maclint::detect
