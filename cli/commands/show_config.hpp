//! `maclint check --show-config`: what holds for each file, and why.
#pragma once

#include "cli/command_line.hpp"
#include "cli/engine/snapshot.hpp"

#include <string>

namespace maclint::cli {

struct ShownConfig {
    std::string text;
    std::vector<Notice> notices; ///< on files that cannot be read or are not linted
};

/// Of the files that were asked for.
[[nodiscard]] ShownConfig show_config(const Snapshot& snapshot, ListFormat format);

} // namespace maclint::cli
