//! What kinds of loops and choices there are.
#pragma once

#include <cstdint>

namespace maclint {

enum class RegionKind : std::uint8_t {
    while_loop,
    endless_loop,
    choice,
    selection,
    unit,
    counting_loop, ///< FOR: its start value is stored before it opens, its step before it closes
    until_loop,    ///< REPEAT: the condition stands at its close and ends it
};
[[nodiscard]] constexpr bool is_loop(RegionKind region_kind) {
    return region_kind == RegionKind::while_loop || region_kind == RegionKind::endless_loop ||
           region_kind == RegionKind::counting_loop || region_kind == RegionKind::until_loop;
}

} // namespace maclint
