//! Which codes a control and its machine have, by the chapters of its language and by what its shop tells.
#pragma once

#include "analyzer/program/lines_with.hpp"
#include "analyzer/syntax/plain_tables.hpp"

#include <cstdint>
#include <vector>

namespace maclint {

struct ControlModel;

enum class CodeStanding : std::uint8_t {
    known,         ///< or nobody can know it: it may be the machine's own
    not_fitted,    ///< the shop says that the machine lacks it
    not_listed,    ///< it could be the machine's own, but is none of those which the shop lists
    unknown,       ///< the control that somebody named has none of that number
    of_no_control, ///< nobody named the control, and none that may be meant has it
};

[[nodiscard]] CodeStanding standing_of(const ControlModel& control, char letter, double code);

/// Codes of which one may not be known, for lines of plain blocks; of codes with a digit behind their point
/// only those whose whole number is none either. Empty: all are known.
[[nodiscard]] std::vector<LetterCodes> codes_to_look_at(const ControlModel& control);
/// The kinds of these codes.
[[nodiscard]] syntax::CodeSet kinds_to_look_at(const ControlModel& control);

} // namespace maclint
