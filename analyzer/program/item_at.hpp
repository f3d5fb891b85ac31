//! The item of a program at a place.
#pragma once

#include "analyzer/program/model.hpp"

namespace maclint {

/// The first of the items that ends behind the place; the one behind them all where none does.
[[nodiscard]] inline ItemId item_at(const Program& program, Slice items, Offset place) {
    ItemId first = items.first;
    ItemId last = items.first + items.count;
    while (first < last) {
        const ItemId middle = first + (last - first) / 2;
        if (program.span_of(middle).end <= place)
            first = middle + 1;
        else
            last = middle;
    }
    return first;
}

} // namespace maclint
