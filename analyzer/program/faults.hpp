//! Further names of what exactly a control stops at.
#pragma once

#include "analyzer/program/syntax_error.hpp"

namespace maclint::faults {
constexpr std::string_view no_sequence_number = "no-sequence-number", if_form = "if-form",
                           while_form = "while-form", ///< of a condition, or of what follows it
    argument = "argument",                            ///< of ATAN or POW
    digits = "digits",                                ///< of a number in a calculation
    suffix = "suffix",                                ///< of `[#_ABSMT[1]]`
    long_variable_name = "long-variable-name";        ///< `[#NAME]`

// Those which a rule of its own tells.
constexpr std::string_view decimal_comma = "decimal-comma", output_form = "output-form", ///< DPRNT, BPRNT
    naming_form = "naming-form",                                                         ///< SETVN
    name_character = "name-character", long_name = "long-name",                          ///< of SETVN
    block_number_misplaced = "block-number-misplaced",                                   ///< `M9 N80`
    behind_tape = "behind-tape",               ///< code behind the mark that closes the tape
    percent_in_comment = "percent-in-comment"; ///< it ends the tape
// Of a real-time macro.
constexpr std::string_view real_time_token = "real-time-token", real_time_variable = "real-time-variable",
                           real_time_slashes = "real-time-slashes", real_time_absolute = "real-time-absolute",
                           real_time_code = "real-time-code", real_time_address = "real-time-address",
                           real_time_program = "real-time-program", real_time_repeat = "real-time-repeat",
                           real_time_argument = "real-time-argument";
constexpr std::string_view of_real_time[] = {real_time_token,    real_time_variable, real_time_slashes,
                                             real_time_absolute, real_time_code,     real_time_address,
                                             real_time_program,  real_time_repeat,   real_time_argument};
constexpr std::string_view told_by_own_rules[] = {decimal_comma,  output_form,       naming_form,
                                                  name_character, long_name,         block_number_misplaced,
                                                  behind_tape,    percent_in_comment};
} // namespace maclint::faults
