//! `textDocument/inlayHint`: letters of arguments beside the variables that they reach, blocks beside jumps
//! whose label is calculated.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// Beside reads of a variable that only a call can have set: the program goes back to a caller, and stores
/// nothing in it. Behind `GOTO#1` the blocks, where the analysis knows them.
[[nodiscard]] Json inlay_hints(Session& session, const Json& params);

} // namespace maclint::cli::lsp
