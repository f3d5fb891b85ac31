//! Whether a block can be given to the parser, whose time grows with the square of some mistakes.
#pragma once

#include "analyzer/source/span.hpp"

#include <string_view>

namespace maclint::sinumerik {

/// False for line noise: dozens of signs that stand where none can, brackets in brackets without end.
[[nodiscard]] bool is_plausible(std::string_view text, Span block);

} // namespace maclint::sinumerik
