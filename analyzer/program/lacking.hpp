//! What a control lacks that others of its family have: SyntaxError::fault of a missing_construct.
#pragma once

#include "analyzer/program/syntax_error.hpp"

#include <string_view>

namespace maclint::lacking {

constexpr std::string_view function = "lacks-function", ///< POW
    form = "lacks-form",                                ///< of a function that it has: ATAN[#1,#2]
    condition = "lacks-condition",                      ///< IF[#1]: without a comparison
    name = "lacks-name",                                ///< [#_ABSIO[1]]: variables with names
    macro_a = "lacks-macro-a";                          ///< G65 H02 P#102: what macro A calculates with

/// Whether the error is one of these, and no construct that no control of the family has.
[[nodiscard]] constexpr bool is_one(const SyntaxError& error) {
    return error.kind == SyntaxErrorKind::missing_construct && error.fault.starts_with("lacks-");
}

} // namespace maclint::lacking
