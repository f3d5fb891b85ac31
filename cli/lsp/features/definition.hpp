//! `textDocument/definition`: where that is which a place names.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// Blocks, programs of the folders, stores of variables, declarations, parameters; null where there is none.
[[nodiscard]] Json definition(Session& session, const Json& params);

} // namespace maclint::cli::lsp
