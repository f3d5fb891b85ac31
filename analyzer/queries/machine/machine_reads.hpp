//! Reads of values that the control owns.
#pragma once

#include "analyzer/program/model.hpp"

#include <string_view>
#include <vector>

namespace maclint::queries {

/// `#a1(Z,1)`
struct ControlRead {
    Span span;
    int number; ///< behind the letters, 0 to 999
};
/// The values that begin with these letters, "#a", as they are written, in any letters; in the order of the
/// text, each once.
[[nodiscard]] std::vector<ControlRead> reads_of_control(const Program& program, std::string_view letters);

/// Whether an expression behind the place, or a program that the rest calls, may read the value, "#i99" as it
/// is written, in any letters.
[[nodiscard]] bool may_be_read_behind(const Program& program, std::string_view value, Offset place);

} // namespace maclint::queries
