//! `textDocument/formatting`, `textDocument/rangeFormatting`.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// Edits of blanks as the configuration has chosen them; none where it has not.
[[nodiscard]] Json formatting(Session& session, const Json& params);
/// The same in the blocks that the range touches.
[[nodiscard]] Json range_formatting(Session& session, const Json& params);

} // namespace maclint::cli::lsp
