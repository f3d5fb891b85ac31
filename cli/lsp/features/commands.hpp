//! `workspace/executeCommand`.
#pragma once

#include "cli/lsp/server/session.hpp"

#include <string>
#include <vector>

namespace maclint::cli::lsp {

[[nodiscard]] std::vector<std::string> command_names_of_server();
[[nodiscard]] Json execute_command(Session& session, const Json& params);

} // namespace maclint::cli::lsp
