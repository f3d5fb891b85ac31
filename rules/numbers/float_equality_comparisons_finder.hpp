//! Comparisons of numbers that rounding has touched.
#pragma once

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/numbers/float_equality_sums_finder.hpp"

#include <cstdint>
#include <optional>

namespace maclint::rules {

/// By which rounded numbers may be compared.
namespace exemptions {
inline constexpr Exemption whole_number_asked_for;
inline constexpr Exemption copy_asked_for;
} // namespace exemptions

/// What makes a side of a comparison inexact.
struct InexactSide {
    ExpressionId side;
    enum class Why : std::uint8_t {
        rounded,  ///< by an operation, at `rounding`
        sum,      ///< of steps that may have decimals
        distance, ///< of measured or passed numbers, as ABS[#1-#2]: nobody knows how exact they are
        touched,  ///< where a signal ended a move, held against a calculated place
    } why;
    dataflow::OriginId rounding = 0;
    const dataflow::Store* sum = nullptr; ///< nullptr when it is none
};

/// The first side that was rounded, else the first that is one of the sums, else a distance that is compared
/// with 0, or the place of a touch; nothing where the comparison tells the truth all the same.
[[nodiscard]] std::optional<InexactSide> inexact_side(const ProgramAnalysis& analysis, const Sums& sums,
                                                      const dataflow::Comparison& comparison);

/// Whether EQ and NE tell the truth of the two sides although one is rounded: both are one value, what is 0
/// only where it is on paper is compared with 0, a number with itself made whole, or a variable with what is
/// copied into it.
[[nodiscard]] bool is_decided_exactly(const ProgramAnalysis& analysis,
                                      const dataflow::Comparison& comparison);

} // namespace maclint::rules
