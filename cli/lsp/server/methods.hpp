//! Which message has which handler.
#pragma once

#include "cli/lsp/server/session.hpp"

#include <string_view>

namespace maclint::cli::lsp {

/// nullptr: there is no such method.
[[nodiscard]] Handler request_handler(std::string_view method);
[[nodiscard]] Handler notification_handler(std::string_view method);

} // namespace maclint::cli::lsp
