//! Edits of programs as the protocol has them.
#pragma once

#include "cli/lsp/server/session.hpp"
#include "rules/finding.hpp"

#include <map>
#include <span>
#include <string>

namespace maclint::cli::lsp {

/// Edits of any files, those of documents with their version where the client knows versions. Lines are
/// counted in each edit's own source.
[[nodiscard]] Json workspace_edit(const Session& session, std::span<const Edit> edits);

} // namespace maclint::cli::lsp
