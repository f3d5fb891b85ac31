//! `maclint check --show-config`: what holds for each file, and why.
#pragma once

#include "cli/input/read.hpp"

#include <string>
#include <vector>

namespace maclint::cli {

[[nodiscard]] std::string show_config(const std::vector<ReadFile>& files);

} // namespace maclint::cli
