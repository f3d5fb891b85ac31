//! `textDocument/foldingRange`.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// Programs, sections, loops and branches of more than one line.
[[nodiscard]] Json folding_ranges(Session& session, const Json& params);

} // namespace maclint::cli::lsp
