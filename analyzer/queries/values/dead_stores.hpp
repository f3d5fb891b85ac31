//! Assignments whose value nothing reads.
#pragma once

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <vector>

namespace maclint::queries {

/// An assignment after which nobody can read what it has stored.
struct DeadStore {
    const dataflow::Store* store;
    /// The assignments that may come next, in text order; none where the program only ends.
    std::vector<const dataflow::Store*> replaced_by;
    bool may_end;        ///< the program can end before another value is stored
    bool is_setting;     ///< nothing but numbers of the text make the value: somebody may edit them
    bool read_elsewhere; ///< some block reads the variable after another assignment, or other programs may
    bool source_changes; ///< it copies a variable that may be set anew before the value is replaced
    /// The condition of an IF that decides whether the store is run, where its other outcome leads to the
    /// only assignment that replaces the value as well.
    std::optional<ExpressionId> only_if;
};

/// In the order of facts. Left out are variables that other programs share, wherever something else than an
/// assignment or a decision may run before they are stored again: a display, a called program or somebody at
/// the control may read them there. Left out are modal codes that are saved, and a branch of a selection that
/// goes on into the next one: other questions tell of them. Behind all stores a million nodes are looked at,
/// and 1,000 more for each; beyond that the rule is said to have given up.
[[nodiscard]] std::vector<DeadStore> find_dead_stores(const ProgramAnalysis& analysis);

} // namespace maclint::queries
