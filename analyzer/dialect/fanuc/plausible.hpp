//! Which blocks are worth the parser's time: recovering from an error costs it a hundred times what a good
//! block costs.
#pragma once

#include "analyzer/source/span.hpp"

#include <string_view>

namespace maclint::fanuc {

/// Whether a block can be parsed in time that anybody waits for. In what people write, a digit is never far
/// and values do not follow one another in dozens; the parser's time grows with the square of such rows.
[[nodiscard]] bool is_plausible(std::string_view text, Span block);

} // namespace maclint::fanuc
