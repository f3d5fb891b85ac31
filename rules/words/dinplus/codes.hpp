//! Lists of codes that several chapters name.
#pragma once

#include "rules/words/table_text.hpp"

namespace maclint::code_books {

/// What begins a contour in the blocks behind a cycle [l.13093, l.14411].
inline constexpr TableText contour_begins =
    "G0 G1 G2 G3 G12 G13 G22 G23 G24 G34 G37 G80 G100 G101 G102 G103 G110 G111 G112 G113 G301 G302 G303 G304 "
    "G305 G307 G311 G312 G313 G314 G315 G317";
inline constexpr TableText motions = "G0 G1 G2 G3 G12 G13 G100 G101 G102 G103 G110 G111 G112 G113";

} // namespace maclint::code_books
