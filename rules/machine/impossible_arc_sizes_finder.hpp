//! Arcs whose words name variables that do not make a circle.
#pragma once

#include "analyzer/machine/step.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>

namespace maclint::rules {

/// Why the words of a circle make none.
struct WrongSizes {
    /// Where variables are read: with both equal it would be a circle. Of one alone: none of the numbers that
    /// were tried makes it one. Neither: its words are numbers, or calculated from such.
    std::optional<ExpressionId> first, second;
    double tried; ///< a number for the first
};

/// Nothing where the numbers may make a circle. Only ways that count from the tool are followed, in mills;
/// what assignments of the program make of a variable is calculated with.
[[nodiscard]] std::optional<WrongSizes> wrong_sizes(const ProgramAnalysis& analysis,
                                                    const machine::Step& step);

} // namespace maclint::rules
