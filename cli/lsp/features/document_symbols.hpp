//! `textDocument/documentSymbol`: the outline of a file.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// Programs, and in them sections, tools as they are called, with the comment beside, and names of blocks.
[[nodiscard]] Json document_symbols(Session& session, const Json& params);

} // namespace maclint::cli::lsp
