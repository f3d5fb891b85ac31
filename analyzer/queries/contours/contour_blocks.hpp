//! The blocks of contours that words name by their numbers.
#pragma once

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/numbered_blocks.hpp"

#include <functional>
#include <optional>
#include <span>

namespace maclint::queries {

/// The one block of the file's contours that bears the number; nothing where none or several do. The file
/// must be indexed.
[[nodiscard]] std::optional<NumberedBlock> find_contour_block(const ProgramFile& file, double number);

/// `visit(BlockView, words)` for the numbered block.
void read_block(const NumberedBlock& block,
                const std::function<void(const BlockView&, std::span<const Word>)>& visit);

} // namespace maclint::queries
