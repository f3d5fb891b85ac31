//! Comments that allow what is found, written into the programs.
#pragma once

#include "cli/fix/fix_programs.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace maclint::cli {

struct AddedSuppressions {
    FixedPrograms programs;
    std::size_t allowed = 0; ///< findings that comments have silenced
};

/// Writes a comment for each finding that counts and is at least so severe: at the end of its line, and where
/// that does not silence it alone on the line before. What neither does is left, and a notice names it.
[[nodiscard]] AddedSuppressions add_suppressions(const Snapshot& snapshot, const std::string& reason,
                                                 Severity least, const Analyse& analyse);

/// What is wrong with a reason, "what. Cure."; nothing where all comments of programs can hold it.
[[nodiscard]] std::optional<std::string> wrong_reason(std::string_view reason);

} // namespace maclint::cli
