//! Angles that a program takes for radians: the functions of the control count in degrees.
#pragma once

#include "analyzer/program/ids.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstdint>
#include <vector>

namespace maclint::rules {

enum class RadianFault : std::uint8_t {
    argument, ///< the argument of SIN, COS or TAN is multiplied by 3.14159/180
    result,   ///< the result of ASIN, ACOS or ATAN is multiplied by 180/3.14159
    passed,   ///< an argument is multiplied by 3.14159/180, and the called program gives it to a function
};

struct RadianUse {
    RadianFault fault;
    EffectId effect;
    ExpressionId conversion; ///< holds the factor
    ExpressionId
        angle; ///< the argument, or what is converted; of `passed` the function in the called program
    const ProgramAnalysis* called = nullptr;
};

/// Conversions that double what the control does: in the function itself, in the assignment that made the
/// value which the function takes, or in a call; and wherever the angle of an inverse function is used.
[[nodiscard]] std::vector<RadianUse> find_radians(const ProgramAnalysis& analysis);

} // namespace maclint::rules
