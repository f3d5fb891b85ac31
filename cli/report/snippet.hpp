//! A few lines of a program with the place of a finding underlined.
#pragma once

#include "analyzer/source/source.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// One line as a terminal shows it: printable, tabs expanded, long lines cut around the marked part.
struct FrameLine {
    std::uint32_t number = 0; ///< 0: lines left out
    std::string text;
    std::string marks; ///< blanks, then at least one caret below the marked part; or empty
};

/// The lines that `span` touches; of many only the first and the last.
[[nodiscard]] std::vector<FrameLine> frame_of(const Source& source, Span span);

} // namespace maclint::cli
