//! Scripts that let a shell complete commands, options and their values.
#pragma once

#include "cli/shell/command_list.hpp"

#include <string>
#include <vector>

namespace maclint::cli {

[[nodiscard]] std::string bash_completions(const std::vector<CommandText>& commands);
[[nodiscard]] std::string zsh_completions(const std::vector<CommandText>& commands);
[[nodiscard]] std::string fish_completions(const std::vector<CommandText>& commands);

/// `text` between single quotes, as bash and zsh read it.
[[nodiscard]] std::string quoted(const std::string& text);
/// The words with a blank between two.
[[nodiscard]] std::string joined(const std::vector<std::string>& words);
[[nodiscard]] std::string command_names(const std::vector<CommandText>& commands);

} // namespace maclint::cli
