//! Variables that are read although nothing can have set them.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/queries/vacancy/missing_cases.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace maclint::queries {

/// By which a variable without a value may be read.
namespace exemptions {
inline constexpr Exemption argument_of_a_series;
inline constexpr Exemption counting_from_vacant;
inline constexpr Exemption compared_as_a_test;
} // namespace exemptions

/// Whether vacant is a value that the variable can be given and asked for; otherwise a variable that nothing
/// has set is undefined.
[[nodiscard]] bool may_hold_vacant(const Program& program, Variable variable);

/// Whether the value is vacant, or may be, because of a variable that nothing can have set when the program
/// began: no argument stands for it.
[[nodiscard]] bool is_owed_to_unset_variable(const ProgramAnalysis& analysis, const dataflow::Value& value);

/// Whether something is read for the expression of the effect, there or where what is read was computed and
/// stored, that has no value: a variable that nothing can have set, or that may be undefined.
[[nodiscard]] bool is_owed_to_missing_value(const ProgramAnalysis& analysis, EffectId effect,
                                            ExpressionId expression);

/// A read of a variable that is as it was when the program began, and that nothing can have set then, or that
/// the program has found vacant.
struct UnsetRead {
    const dataflow::Read* read;
    std::vector<flow::EdgeId> path; ///< to the read, around every assignment
};

enum class Unset : std::uint8_t {
    always,      ///< by no path, and no argument stands for it
    as_argument, ///< by no path, and no call passes it
    as_tested,   ///< on no path that comes here: the program has found that it is vacant
    by_callers,  ///< on no path that comes here, nor by a known caller, whose variables the program shares
    unless_by_callers, ///< by no path; a caller that nobody knows may share a variable that it has set
    in_some_cases,     ///< by some paths only
};

/// Reads that go back to one mistake.
struct UnsetReads {
    Unset kind;
    UnsetRead first;                           ///< in the text
    std::vector<const dataflow::Read*> others; ///< of other variables
    MissingCase missing;                       ///< for Unset::in_some_cases
};

/// The first such read of each variable. Left out are reads that ask for the vacancy or stand beside a
/// question for it, counting (#33=#33+1 takes vacant for 0), those that make no use of the value, and what
/// repeated I, J and K of a call may set. In a program that shares the variables of its callers
/// only what no known caller sets, and what it has found vacant itself.
[[nodiscard]] std::vector<UnsetReads> find_unset_reads(const ProgramAnalysis& analysis);

} // namespace maclint::queries
