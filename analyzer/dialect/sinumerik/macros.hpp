//! What stands behind AS in `DEFINE NAME AS …`.
#pragma once

#include "analyzer/program/given.hpp"

#include <string>
#include <string_view>

namespace maclint::sinumerik {

/// The name as a word, with what its body does: where that is codes, numbers of axes, F, S, D, M6, and
/// functions that only switch something of the machine. Any other body may do anything.
[[nodiscard]] GivenWord read_macro(std::string name, std::string_view body);

} // namespace maclint::sinumerik
