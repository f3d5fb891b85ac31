//! `textDocument/codeAction`: what can be done about findings.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// For each finding that the range touches its fixes, a comment that allows it, and its rule's page; all safe
/// fixes of the document at once.
[[nodiscard]] Json code_actions(Session& session, const Json& params);

} // namespace maclint::cli::lsp
