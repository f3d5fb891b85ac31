//! `textDocument/inlayHint`: letters of arguments beside the variables that they reach.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// Beside reads of a variable that only a call can have set: the program goes back to a caller, and stores
/// nothing in it.
[[nodiscard]] Json inlay_hints(Session& session, const Json& params);

} // namespace maclint::cli::lsp
