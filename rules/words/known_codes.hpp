//! Which codes a control and its machine have, by the chapters of its language and by what its shop tells.
#pragma once

#include "analyzer/program/lines_with.hpp"
#include "analyzer/syntax/plain_tables.hpp"

#include <cstdint>
#include <memory>
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

struct CodesToLookAt {
    /// Of which one may not be known; of codes with a digit behind their point only those whose whole number
    /// is none either. Empty: all are known.
    std::vector<LetterCodes> codes;
    syntax::CodeSet kinds; ///< of these
};

/// For lines of plain blocks. May be asked on several threads.
[[nodiscard]] std::shared_ptr<const CodesToLookAt> codes_to_look_at(const ControlModel& control);

} // namespace maclint
