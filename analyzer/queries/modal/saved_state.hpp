//! What a program keeps of its callers' modal state, to put it back.
#pragma once

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <vector>

namespace maclint::queries {

/// The assignments that save what is in force in some group for later: nothing is decided or calculated with
/// it, words may put it back. Groups that no custom asks to put back, and units, which programs only ask for,
/// do not count.
[[nodiscard]] std::vector<const dataflow::Store*> saves_of(const ProgramAnalysis& analysis);

/// Whether the program saves something of its callers' modal state.
[[nodiscard]] bool keeps_callers_state(const ProgramAnalysis& analysis);

/// The only assignment to a variable that saves what is in force in the group, before the program sets it;
/// nullptr when there is none.
[[nodiscard]] const dataflow::Store* find_save(const ProgramAnalysis& analysis, GroupId group);

/// A local variable that the program does not name, none that a letter of a call reaches where there is one;
/// nothing in languages whose variables have names.
[[nodiscard]] std::optional<Variable> find_free_local(const Program& program);

} // namespace maclint::queries
