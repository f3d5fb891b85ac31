//! All that the server does on request.
#pragma once

#include "cli/lsp/server/session.hpp"

#include <span>
#include <string_view>

namespace maclint::cli::lsp {

struct Method {
    std::string_view name;
    Handler handle;
};

[[nodiscard]] std::span<const Method> feature_methods();
/// ServerCapabilities of them.
[[nodiscard]] Json feature_capabilities();

} // namespace maclint::cli::lsp
