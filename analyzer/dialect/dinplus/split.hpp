//! Cuts a DIN PLUS file into blocks: lines, comments over several lines, texts.
#pragma once

#include "analyzer/dialect/raw_block.hpp"
#include "analyzer/source/span.hpp"

#include <string_view>

namespace maclint::dinplus {

/// The block that begins at `begin`, the head of a line. It ends at the line end; a comment that nobody
/// closes ends with the line before which blocks visibly begin again.
void cut_block(std::string_view text, Offset begin, RawBlock& block);

} // namespace maclint::dinplus
