//! How a session begins.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// `initialize`: takes what the client can and which folders it has; gives what the server can.
[[nodiscard]] Json initialize(Session& session, const Json& params);
/// `initialized`: asks to be told of files, and begins with the folders.
Json initialized(Session& session, const Json& params);

} // namespace maclint::cli::lsp
