//! Blocks that others name by their sequence numbers: where they stand, and what stands between two of them.
#pragma once

#include "analyzer/program/block_view.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace maclint::queries {

/// Where the blocks with that number stand in the program, in the order of the text; skipped ones, too.
[[nodiscard]] std::vector<Span> blocks_numbered(const Program& program, std::int64_t number);

/// The number of a block that a word names; nothing where it is calculated, or can be none.
[[nodiscard]] std::optional<std::int64_t> block_number(const Word& word);

/// `visit(block, words)` for the blocks with words that begin in the part.
void for_each_block_in(const Program& program, Span part,
                       const std::function<void(const BlockView&, std::span<const Word>)>& visit);

/// The first block of the part that has no words and does more than store values: a jump, a loop, text that
/// nobody can read.
[[nodiscard]] std::optional<Span> first_statement_in(const Program& program, Span part);

} // namespace maclint::queries
