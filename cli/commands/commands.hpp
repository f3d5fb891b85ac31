//! The commands; each gives the exit status.
#pragma once

#include "cli/command_line.hpp"

namespace maclint::cli {

[[nodiscard]] int run_check(const CheckRequest& request);
[[nodiscard]] int run_rules_command(const RulesRequest& request);
[[nodiscard]] int run_explain(const ExplainRequest& request);
[[nodiscard]] int run_controls(const ControlsRequest& request);
[[nodiscard]] int run_init(const InitRequest& request);
[[nodiscard]] int run_renumber(const RenumberRequest& request);
[[nodiscard]] int run_lsp(const LspRequest& request);

} // namespace maclint::cli
