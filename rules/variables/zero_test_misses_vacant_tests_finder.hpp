//! Tests for 0 that a vacant variable passes as if it were a number.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <vector>

namespace maclint::rules {

namespace exemptions {
inline constexpr Exemption zero_is_refused; ///< 0 ends in an alarm, and vacancy is asked for behind the test
} // namespace exemptions

/// A comparison with 0 by EQ or NE whose variable can be vacant there, and then goes the way of a number.
struct MissedVacancy {
    const dataflow::Comparison* test;
    const dataflow::Value* value; ///< of the variable, a side of the test
    Variable variable;
    Span shows;   ///< where it shows that this is not meant
    bool is_used; ///< there the variable is used; otherwise it is tested for vacancy, in another place
};

/// All of the program, in the order of the text. Left out are tests after which vacant and 0 lead to the same
/// blocks and values, and those that nothing shows to be meant otherwise.
[[nodiscard]] std::vector<MissedVacancy> find_missed_vacancy(const ProgramAnalysis& analysis);

} // namespace maclint::rules
