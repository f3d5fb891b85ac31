//! Why a block could not be read, in the user's words, and what it may do all the same.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/syntax/tree.hpp"

#include <span>
#include <vector>

namespace maclint::fanuc {

/// What a block that could not be read names: places that it may write, labels that it may jump to.
[[nodiscard]] UnreadableBlock names_in(const Program& program, Span block);

/// The cause of the errors in a block's tree, reported once.
void diagnose(const Program& program, Span block, std::span<const Span> comments, const syntax::Tree& tree,
              std::vector<Irregularity>& irregularities);

} // namespace maclint::fanuc
