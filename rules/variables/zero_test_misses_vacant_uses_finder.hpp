//! What a program does with a vacant variable that a test for 0 has let pass.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint::rules {

namespace exemptions {
inline constexpr Exemption assigned_unread; ///< a block that nobody can read looks like an assignment to it
} // namespace exemptions

/// What a program does with a variable on the side of a test that it takes when the variable is vacant, with
/// nothing set in between.
struct AfterZeroTest {
    bool is_reached = false;       ///< a path comes to the test with the variable unset
    bool is_default = false;       ///< on the other side the variable at once gets another value than 0
    bool is_held_in_range = false; ///< `compared` asks for less or more
    std::optional<Span> use = {};  ///< a word, an argument, an index or an operand; a block that cannot be
                                   ///< read uses all that it names but the first, unless it is a test
    std::optional<Span> compared = {}; ///< by a test that tells no vacancy
    std::optional<Span> asked = {};    ///< by a test for vacancy
};

/// The first of each in the order of the paths' lengths, behind none that settles it; a use ends the search.
/// `test` compares the variable with 0 by EQ or NE.
[[nodiscard]] AfterZeroTest find_after_zero_test(const ProgramAnalysis& analysis,
                                                 const dataflow::Comparison& test,
                                                 const dataflow::Value& tested, Variable variable);

} // namespace maclint::rules
