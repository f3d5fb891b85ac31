//! The blocks of a section in the order of the text, for questions on what stands behind what.
#pragma once

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/model.hpp"

#include <optional>
#include <vector>

namespace maclint::queries {

struct TextBlock {
    BlockView block;
    std::vector<Word> words;
    /// It branches, calls, ends or cannot be read: what stood before it says nothing of what comes.
    bool breaks = false;

    /// Its G code, where it is the first one; nothing where there is none, or a calculated one.
    [[nodiscard]] std::optional<double> code() const;
};

/// Nothing of a section that a CAM system wrote: its blocks are too many to be kept.
[[nodiscard]] std::optional<std::vector<TextBlock>> blocks_in_order(const Program& program,
                                                                    const Section& section);

} // namespace maclint::queries
