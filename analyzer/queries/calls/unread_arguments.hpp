//! Values that a call passes and the called program never reads.
#pragma once

#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <vector>

namespace maclint::queries {

/// By which an argument that is not read is let pass.
namespace exemptions {
inline constexpr Exemption program_to_be_written;
} // namespace exemptions

struct UnreadArgument {
    EffectId call;
    const ProgramAnalysis* called;
    const Argument* argument;
    Variable variable;                   ///< of the called program
    std::optional<EffectId> overwritten; ///< there, before anything reads it; empty: nothing names it
    std::vector<Caller> others;          ///< that pass it, too
};

/// In the order of the program's calls. Of several calls that pass the same to one program the first is told,
/// of those in files that somebody asked for; calls within a cycle do not count, nor does what may arrive as
/// another variable (K1.I2.). Nothing where the called program may read any of its local variables: through
/// an index, in a program that shares them, in a block that nobody can read; where it reads no argument at
/// all, or a remark of it tells of the variable.
[[nodiscard]] std::vector<UnreadArgument> unread_arguments(const ProgramAnalysis& analysis);

} // namespace maclint::queries
