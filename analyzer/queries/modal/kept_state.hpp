//! Modal groups whose state a program keeps to put it back.
#pragma once

#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/modal_groups.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::queries {

/// A group whose state the program stores in a variable before it changes the group: it has shown that its
/// callers are to have it back.
struct KeptState {
    GroupId group;
    const dataflow::Store* save;
    bool is_put_back; ///< by some word of the program
};

/// Whether callers may ask for what was in force in groups of this policy.
[[nodiscard]] bool can_be_kept(RestorePolicy policy);

/// One for each such group, by the first assignment that saves it. Left out are groups that other rules ask
/// to be cancelled; states that are read for something else and put back by no word; and those that another
/// program may put back: in a variable that programs share, or passed on.
[[nodiscard]] std::vector<KeptState> find_kept_states(const ProgramAnalysis& analysis);

} // namespace maclint::queries
