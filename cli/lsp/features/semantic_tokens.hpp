//! `textDocument/semanticTokens/full` and `/range`: what names are, where letters alone do not show it.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// Names of the document; none of a text that is longer than editors colour in one piece.
[[nodiscard]] Json semantic_tokens(Session& session, const Json& params);
/// Those that touch the range, in a text of any length.
[[nodiscard]] Json semantic_tokens_in_range(Session& session, const Json& params);
/// SemanticTokensOptions.
[[nodiscard]] Json semantic_tokens_options();

} // namespace maclint::cli::lsp
