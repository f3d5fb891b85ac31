//! `textDocument/references` and `textDocument/documentHighlight`: all places that mean the same.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// Of a block and of a tool in the text; of a program all calls in the folders; of a variable in its program,
/// or in all that share it.
[[nodiscard]] Json references(Session& session, const Json& params);
/// Those in the text, with what is read and what is written.
[[nodiscard]] Json document_highlight(Session& session, const Json& params);

} // namespace maclint::cli::lsp
