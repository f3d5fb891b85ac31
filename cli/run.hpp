//! The whole program but for `main`.
#pragma once

#include <string>
#include <vector>

namespace maclint::cli {

/// Does what the arguments (without the program's name) ask for; gives the exit status. Throws nothing.
[[nodiscard]] int run(const std::vector<std::string>& arguments) noexcept;

} // namespace maclint::cli
