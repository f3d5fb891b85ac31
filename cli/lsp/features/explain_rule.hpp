//! `maclint.explain CODE`: a page as `maclint explain` has it.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// `{"markdown": …, "url": …}`; the address only where pages are published.
[[nodiscard]] Json explain_rule(Session& session, const Json& arguments);

} // namespace maclint::cli::lsp
