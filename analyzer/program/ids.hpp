//! Names for the places of a program's parts.
#pragma once

#include <cstdint>

namespace maclint {

using Id = std::uint32_t; ///< index into one of a program's arenas
using ExpressionId = Id;
using EffectId = Id;

} // namespace maclint
