//! `textDocument/prepareCallHierarchy`, `callHierarchy/incomingCalls` and `outgoingCalls`.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// The programs that a call here may mean, else the program that the place lies in; null where there is none.
[[nodiscard]] Json prepare_call_hierarchy(Session& session, const Json& params);
/// Programs of the folders that call the item's, each with its calls.
[[nodiscard]] Json incoming_calls(Session& session, const Json& params);
/// Programs of the folders that the item's program calls.
[[nodiscard]] Json outgoing_calls(Session& session, const Json& params);

} // namespace maclint::cli::lsp
