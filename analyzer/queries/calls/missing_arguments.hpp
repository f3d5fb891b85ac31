//! Arguments that a program calculates with, and no call of it passes.
#pragma once

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::queries {

/// By which an argument that no call passes may be read.
namespace exemptions {
inline constexpr Exemption compared_somewhere;
} // namespace exemptions

struct MissingArgument {
    const dataflow::Read* read; ///< the first that calculates with it
    const Caller* call;         ///< that leaves it out and goes there, as all known ones leave it out
};

/// One for each variable that a letter of a call reaches: all known callers open a set of locals for the
/// program and leave it out, the program calculates with it as it was at the start on a path that one of them
/// goes, and nowhere compares it, or a copy, with anything.
[[nodiscard]] std::vector<MissingArgument> find_missing_arguments(const ProgramAnalysis& analysis);

} // namespace maclint::queries
