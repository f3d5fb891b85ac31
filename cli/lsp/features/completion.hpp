//! `textDocument/completion` and `completionItem/resolve`: words that may stand at a place, with what they
//! mean.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// Programs behind the words that call, blocks behind those that jump; else variables, words of the block's
/// codes, codes and words of the language. Some hundred at most, the rest as somebody types on.
[[nodiscard]] Json completion(Session& session, const Json& params);
/// Adds to an item what hover says of it.
[[nodiscard]] Json resolve_completion(Session& session, const Json& item);

} // namespace maclint::cli::lsp
