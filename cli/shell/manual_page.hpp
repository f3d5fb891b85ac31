//! The manual page: `man maclint`.
#pragma once

#include "cli/shell/command_list.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// The page in the language of man(7).
[[nodiscard]] std::string manual_page(const std::vector<CommandText>& commands, std::string_view version);

} // namespace maclint::cli
