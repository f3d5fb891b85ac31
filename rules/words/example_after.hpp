//! The blocks after an example's, which its row or another one of its code wants.
#pragma once

#include "rules/words/example_block.hpp"
#include "rules/words/example_frames.hpp"

#include <string>
#include <string_view>

namespace maclint {

/// Where an example is written.
struct ExamplePlace {
    const ControlModel& control;
    const ExampleFrame& frame;
    std::string_view section;
};

/// With their ends of line; `kept`: such as the row wants them, else not, where the row is about them.
[[nodiscard]] std::string blocks_after(const RowForCode& row, const ExampleBlock& block,
                                       const ExamplePlace& place, bool kept);

} // namespace maclint
