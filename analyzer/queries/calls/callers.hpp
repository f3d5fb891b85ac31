//! Who calls a program, and with what.
#pragma once

#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace maclint::queries {

/// The program in which the call stands.
[[nodiscard]] const ProgramAnalysis& calling_program(const ProgramAnalysis& analysis, const Caller& caller);

/// Whether the workspace knows a caller of the program, or a call that may mean it.
[[nodiscard]] bool knows_callers(const ProgramAnalysis& analysis);

struct KnownCallers {
    std::vector<Caller> callers;
    bool all; ///< the workspace has no others
};
/// The callers of the program; where none is known, some of the calls that may mean it.
[[nodiscard]] KnownCallers known_or_possible_callers(const ProgramAnalysis& analysis);

/// The program that the call runs; nullptr when it is computed, unknown, or one of several.
[[nodiscard]] const ProgramAnalysis* called_program(const ProgramAnalysis& analysis, const CallSite& site);

/// Whether the program that the call runs may leave the group other than it found it.
[[nodiscard]] bool call_may_change(const ProgramAnalysis& analysis, EffectId call, GroupId group);

/// The call that an effect is, which must be one.
[[nodiscard]] const Call& call_of(const Program& program, EffectId effect);

/// The argument by which the call gives the variable a value; nullptr where it leaves it out.
[[nodiscard]] const Argument* argument_for(const ProgramAnalysis& analysis, const Caller& caller,
                                           Variable formal);

/// Whether the call gives the program a set of local variables of its own.
[[nodiscard]] bool opens_locals(const ProgramAnalysis& analysis, const Caller& caller);

/// Whether the caller belongs to the same control. Programs of a folder beside this one may be another
/// machine's, unless all programs are known and this one is there to be called.
[[nodiscard]] bool is_of_one_control(const ProgramAnalysis& analysis, const Caller& caller);

/// The first call from another program of the same control that is reached; nullptr when there is none.
[[nodiscard]] const Caller* find_reached_caller(const ProgramAnalysis& analysis);

/// The first known call that does not pass a value for the variable, and of which `also` says so where it is
/// asked; nullptr when there is none.
[[nodiscard]] const Caller* find_caller_without(const ProgramAnalysis& analysis, Variable formal,
                                                const std::function<bool(const Caller&)>& also = {});

/// The first known call from each program that calls this one.
[[nodiscard]] std::vector<const Caller*> first_callers(const ProgramAnalysis& analysis);

/// The first of these callers whose program has no block of that number; nullptr when each has. Programs that
/// call themselves are not looked at.
[[nodiscard]] const Caller* find_caller_lacking(const ProgramAnalysis& analysis,
                                                std::span<const Caller* const> callers,
                                                std::int64_t block_number);

/// Whether all programs are known, and none of them can have called this one.
[[nodiscard]] bool is_called_by_nobody(const ProgramAnalysis& analysis);

} // namespace maclint::queries
