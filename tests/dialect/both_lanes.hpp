//! Reads a text through the plain lane and without it: both must make the same of it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace maclint::test {

/// A text, and the same with a comment at each of its plain blocks that keeps it from the plain lane.
struct BothLanes {
    std::string grammar_only;
    std::size_t plain = 0;
};
[[nodiscard]] BothLanes forbid_plain_lane(std::string_view text, std::string_view control);

/// The first thing that the lanes read differently; nothing when they agree.
[[nodiscard]] std::optional<std::string> difference_of_lanes(std::string_view text, std::string_view control,
                                                             std::string_view name);

} // namespace maclint::test
