//! `textDocument/rename` and `textDocument/prepareRename`: another number or name, where that is certain.
#pragma once

#include "cli/lsp/server/session.hpp"

namespace maclint::cli::lsp {

/// What would be written anew; ResponseError with the reason where nothing can be, null where nothing is
/// named.
[[nodiscard]] Json prepare_rename(Session& session, const Json& params);
/// Of a block's number, of a block's name, of a variable that the program declares for itself. ResponseError
/// where the new name has another meaning, or where the old one stands in what nobody follows.
[[nodiscard]] Json rename(Session& session, const Json& params);

} // namespace maclint::cli::lsp
