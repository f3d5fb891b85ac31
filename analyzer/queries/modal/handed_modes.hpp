//! Modal states that a program leaves to its callers on purpose.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

namespace maclint::queries {

/// Whether the program can be there for nothing but the modes that it sets: it does not move, calls no other,
/// changes no tool and stores nothing that others read.
[[nodiscard]] bool only_sets_modes(const Program& program);

/// Whether every caller that the workspace knows, or that may be one, ends what the program left in the
/// group: after the call it cancels the group, alone or with a move, or calls a program that does, on every
/// path to its own end. A block that cancels several groups at once is the custom at the start of a tool, and
/// tells nothing. False, too, where that would take too long to find out.
[[nodiscard]] bool callers_cancel(const ProgramAnalysis& analysis, GroupId group);

} // namespace maclint::queries
