//! Small pieces of sentences: numbers of things, and names of unknown encoding.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace maclint::cli {

/// "1 error", "2 errors".
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);

/// Text of unknown encoding, such as a file's name, fit for a terminal.
[[nodiscard]] std::string shown(std::string_view bytes);

} // namespace maclint::cli
