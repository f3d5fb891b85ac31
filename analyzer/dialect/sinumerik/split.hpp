//! Cuts a SINUMERIK file into blocks: a block is a line.
#pragma once

#include "analyzer/dialect/raw_block.hpp"
#include "analyzer/source/span.hpp"

#include <string_view>

namespace maclint::sinumerik {

/// The block that begins at `begin`, the head of a line.
void cut_block(std::string_view text, Offset begin, RawBlock& block);

} // namespace maclint::sinumerik
