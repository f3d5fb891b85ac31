//! A local variable that a program has left over.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint::rules {

/// The last local variable that the program names nowhere and that no single argument letter sets; nothing
/// when all are taken, or where the language numbers none.
[[nodiscard]] std::optional<Variable> find_free_local(const ProgramAnalysis& analysis);

} // namespace maclint::rules
