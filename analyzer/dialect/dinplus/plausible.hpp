//! Which blocks are worth the parser's time: noise costs it quadratic time.
#pragma once

#include "analyzer/source/span.hpp"

#include <string_view>

namespace maclint::dinplus {

/// Whether the block of the file can be parsed in time that anybody waits for. What people write does not
/// hold dozens of operators without operands, of brackets left open, or of keywords.
[[nodiscard]] bool is_plausible(std::string_view text, Span block);

} // namespace maclint::dinplus
