//! The programs of the document that a request names.
#pragma once

#include "cli/lsp/server/session.hpp"

#include <memory>

namespace maclint::cli::lsp {

/// nullptr: it is no program that maclint reads.
[[nodiscard]] std::shared_ptr<const ReadText> read_document(Session& session, const Json& params);

} // namespace maclint::cli::lsp
