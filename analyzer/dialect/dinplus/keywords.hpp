//! The words of the language that are no addresses, and what somebody meant who wrote another one.
#pragma once

#include <string>
#include <string_view>

namespace maclint::dinplus {

/// Keywords, functions, operators: capitals.
[[nodiscard]] bool is_keyword(std::string_view capitals);
/// Whether a block with the word may open, divide or close a construct.
[[nodiscard]] bool is_structural(std::string_view capitals);
/// SIN, SQRT: what stands before its argument in ( ).
[[nodiscard]] bool is_function(std::string_view capitals);
/// The word that was meant by one that is none, section words included; empty when it is unknown. Capitals,
/// UTF-8.
[[nodiscard]] std::string meant_by(std::string_view capitals);
/// Whether the name without its underscores is one of the control's own constants: n95_f.
[[nodiscard]] bool is_internal_constant(std::string_view name);

} // namespace maclint::dinplus
