//! From what is declared to CLI11 to the texts for the manual page and for shells.
#pragma once

#include "cli/shell/command_list.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI { // NOLINT(readability-identifier-naming): the library's
class App;
}

namespace maclint::cli {

/// Words that an option takes, by its name ("--format") or what stands for it ("RULE"); empty for any.
using KnownWords = std::function<std::vector<std::string>(std::string_view option)>;

[[nodiscard]] CommandText describe(const CLI::App& app, std::string text, const KnownWords& known);

} // namespace maclint::cli
