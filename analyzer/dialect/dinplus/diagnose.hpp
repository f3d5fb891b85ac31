//! Says why a block cannot be read, in the user's words.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/syntax/tree.hpp"

#include <string_view>
#include <vector>

namespace maclint::dinplus {

/// Appends one irregularity: the most exact cause that is found for the errors in the block's tree.
void diagnose(std::string_view text, Span block, const syntax::Tree& tree,
              std::vector<Irregularity>& irregularities);

/// Whether a block is worth parsing. Noise costs the parser quadratic time.
[[nodiscard]] bool is_plausible(std::string_view text, Span block);

/// What an unreadable block may do, judged by the words in it.
[[nodiscard]] UnreadableBlock names_in(const Program& program, Span block);

} // namespace maclint::dinplus
