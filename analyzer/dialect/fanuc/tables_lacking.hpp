//! Functions and forms of expressions that not every control of the family has.
#pragma once

#include "analyzer/program/tables.hpp"

#include <cstdint>
#include <string_view>

namespace maclint::fanuc {

enum class Extra : std::uint8_t {
    power,            ///< POW[#1,#2]
    parameter,        ///< PRM[3411]
    remainder,        ///< #1 MOD #2
    logarithm,        ///< LN, EXP
    code_of_decimals, ///< BIN, BCD, ADP
    angle_of_one,     ///< ATAN[#1]
    angle_of_two,     ///< ATAN[#1,#2]
    named_variable,   ///< [#_ABSIO[1]]
    bare_condition,   ///< IF[#1]
    macro_a,          ///< G65 H02 P#102 Q100 R0
    macro_a_jump,     ///< G65 H80 P50
    macro_a_test,     ///< G65 H81 P50 Q#530 R25
    macro_a_alarm,    ///< G65 H99 P5
};

/// What is said of a control that lacks it.
struct Lacking {
    Extra extra;
    std::string_view models;    ///< that lack it, separated by blanks
    std::string_view fault;     ///< one of `lacking`
    bool documented;            ///< else it is a warning
    std::string_view elsewhere; ///< of an assumed control: those that have it
    std::string_view cure;
    std::string_view source;
};

/// The row, where the control lacks it; nullptr: it has it, or nobody knows.
[[nodiscard]] const Lacking* lacking_on(const ControlModel& control, Extra extra);

} // namespace maclint::fanuc
