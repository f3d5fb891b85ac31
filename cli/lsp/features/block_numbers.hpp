//! Numbers of blocks and the words that name them: where they are, who names them, and new ones.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// Of a word that names a block that block; null where no number of a block is.
[[nodiscard]] Json block_definition(Session& session, const Json& params);
/// All words of the file that name the block; null likewise.
[[nodiscard]] Json block_references(Session& session, const Json& params);
/// The block's number and those words; null likewise.
[[nodiscard]] Json block_highlight(Session& session, const Json& params);
/// The digits; null likewise.
[[nodiscard]] Json block_digits(Session& session, const Json& params);
/// Another number for the block. ResponseError where another block has it, or where a computed jump or
/// another file's program could name the block.
[[nodiscard]] Json rename_block(Session& session, const Json& params);
/// `maclint.renumber` URI START STEP: an edit that numbers all blocks anew.
[[nodiscard]] Json renumber(Session& session, const Json& arguments);

} // namespace maclint::cli::lsp
