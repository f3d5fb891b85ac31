//! What a call of a program does to its caller, in words that hold outside the program.
#pragma once

#include "analyzer/dataflow/value.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace maclint::dataflow {

struct VariableChange {
    Variable variable;
    Vacancy vacancy;
    double low, high;
    bool integer;
    Exactness exactness;
};

struct GroupChange {
    GroupId group;
    bool may_keep;             ///< on some way the caller's code is in force again
    std::vector<double> codes; ///< codes that the program may leave behind
    bool other;                ///< it may leave something else behind
};

struct Summary {
    bool known = false;   ///< false: the program is not there, everything may change
    bool returns = true;  ///< at least one way leads back to the block behind the call
    bool may_stop = true; ///< it or what it calls may stop: an alarm, a pause, the program's end
    std::vector<VariableChange>
        variables; ///< all that it may write and the caller can see (locals for calls that share them)
    std::vector<SpaceId> havoc; ///< spaces of which anything may have changed
    std::vector<GroupChange> groups;
    std::vector<std::int64_t> resume_labels; ///< M99 P
    /// Variables, as they are spelled, that it writes and that may be the caller's, handed down to it;
    /// absent: any of them.
    std::optional<std::vector<std::string>> written_for_callers;
};

/// The summary of the program that a call means; never null, an unknown program has Summary{}.
using Callees = std::function<const Summary&(EffectId call)>;

} // namespace maclint::dataflow
