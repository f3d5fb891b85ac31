//! Patterns for paths: * and ? inside a name, ** across folders, [a-z] for one character.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// Whether one name, without '/', matches.
[[nodiscard]] bool matches_name(std::string_view pattern, std::string_view name);

/// The names of a path, without "." and empty ones.
[[nodiscard]] std::vector<std::string_view> names_of(std::string_view path);

/// Whether all the names of a path match, pattern by pattern; "**" stands for any number of names, at the end
/// for one at least.
[[nodiscard]] bool matches_names(std::span<const std::string> pattern,
                                 std::span<const std::string_view> names);

/// A pattern and the folder that it is relative to.
struct Glob {
    std::string pattern;
    std::string folder; ///< absolute
};

} // namespace maclint::cli
