//! Marks by which the channels of a program wait for each other.
#pragma once

#include "analyzer/program/model.hpp"

#include <optional>
#include <vector>

namespace maclint::queries {

/// A block that waits until another channel has set a mark.
struct MarkWait {
    double mark;
    std::optional<unsigned> channel; ///< that is to set it, where the block names it
    Span span;
};

/// Those of a file whose mark no block sets that the channel may run. Nothing where a number is calculated:
/// then any mark may be meant.
[[nodiscard]] std::vector<MarkWait> waits_for_nothing(const ProgramFile& file);

} // namespace maclint::queries
