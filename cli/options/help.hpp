//! The help of commands: our own layout over what is declared to CLI11, whose own differs from version to
//! version and cuts words.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace CLI { // NOLINT(readability-identifier-naming): the library's
class App;
}

namespace maclint::cli {

/// A line to be typed, and what it does.
struct HelpExample {
    std::string_view command, what;
};

/// One command among the others.
struct HelpCommand {
    std::string command; ///< with its operands
    std::string what;
};

/// What `usage` is called with, the options in their groups, and examples, in `width` columns.
[[nodiscard]] std::string help_of(const CLI::App& app, std::string_view usage,
                                  std::span<const HelpExample> examples, std::size_t width);

/// "Commands:", a line or more each.
[[nodiscard]] std::string help_of(const std::vector<HelpCommand>& commands, std::size_t width);

/// A text in so many columns, with a line feed at the end.
[[nodiscard]] std::string paragraph(std::string_view text, std::size_t width);

} // namespace maclint::cli
