//! The first block of a program whose number a rule wants.
#pragma once

#include "analyzer/program/block_view.hpp"

#include <cstdint>
#include <optional>
#include <variant>

namespace maclint::rules {

struct NumberOfBlock {
    std::int64_t number;
    Span span;
};

/// The first number of the program outside of the two. Plain blocks are read again only where one of them
/// has such a number.
inline std::optional<NumberOfBlock> first_number_outside(const Program& program, std::int64_t least,
                                                         std::int64_t most) {
    std::optional<NumberOfBlock> found;
    const auto look = [&](const BlockView& block) {
        if (block.number && (*block.number < least || *block.number > most))
            found = {*block.number, block.number_span};
        return !found.has_value();
    };
    for (const Item& item : program.items) {
        const auto* run = std::get_if<PlainRun>(&item);
        const bool within = run != nullptr && (!run->has_numbers() ||
                                               (run->lowest_number >= least && run->highest_number <= most));
        if (!within && !blocks::visit_item(program, item, look)) break;
    }
    return found;
}

} // namespace maclint::rules
