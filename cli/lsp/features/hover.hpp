//! `textDocument/hover`: what the word at a place means.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// The shop's own words first, then what the tables say, then where a variable is set; null where nothing is
/// known.
[[nodiscard]] Json hover(Session& session, const Json& params);

} // namespace maclint::cli::lsp
