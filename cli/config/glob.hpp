//! Patterns for paths: * and ? inside a name, ** across folders, [a-z] for one character.
#pragma once

#include <string_view>

namespace maclint::cli {

/// Whether `path`, relative and with '/', matches. A pattern without '/' is tried on every name of the path,
/// so that "old" and "*.bak" hold at any depth; one that matches a folder matches all that is in it.
[[nodiscard]] bool matches(std::string_view pattern, std::string_view path);

} // namespace maclint::cli
