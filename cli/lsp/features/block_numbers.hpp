//! Numbers of blocks and the words that name them: where they are, who names them, and new ones.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// `textDocument/definition`: of a word that names a block that block.
[[nodiscard]] Json definition(Session& session, const Json& params);
/// `textDocument/references`: all words of the file that name the block.
[[nodiscard]] Json references(Session& session, const Json& params);
/// `textDocument/documentHighlight`: the block's number and those words.
[[nodiscard]] Json document_highlight(Session& session, const Json& params);
/// `textDocument/prepareRename`: the digits; null where no number of a block is.
[[nodiscard]] Json prepare_rename(Session& session, const Json& params);
/// `textDocument/rename`: another number for the block. ResponseError where another block has it, or where a
/// computed jump or another file's program could name the block.
[[nodiscard]] Json rename(Session& session, const Json& params);
/// `maclint.renumber` URI START STEP: an edit that numbers all blocks anew.
[[nodiscard]] Json renumber(Session& session, const Json& arguments);

} // namespace maclint::cli::lsp
