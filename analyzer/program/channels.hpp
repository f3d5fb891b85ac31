//! The numbers of channels.
#pragma once

#include "analyzer/program/model.hpp"

#include <bit>
#include <cstdint>

namespace maclint {

/// `visit(channel)` for each of them, in the order of their numbers.
template<class Visit>
void for_each_channel(Channels channels, const Visit& visit) {
    for (unsigned rest = channels; rest != 0; rest &= rest - 1)
        visit(static_cast<std::uint8_t>(std::countr_zero(rest)));
}

} // namespace maclint
