//! What is told of the codes of one machine, beside those that its control has.
#pragma once

#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>

namespace maclint {

/// OwnCode::program of a code that the control has on other machines: its option is not fitted.
inline constexpr std::int64_t not_fitted = -1;

/// OwnCode::letter of a T word, whatever its number, that calls a program.
inline constexpr char tool_letter = 'T';

/// The order of ControlModel::own_codes.
[[nodiscard]] inline bool in_order_of_codes(const OwnCode& a, const OwnCode& b) {
    return std::tie(a.letter, a.number) < std::tie(b.letter, b.number);
}

/// What is told of the code, or nullptr.
[[nodiscard]] inline const OwnCode* own_code(const ControlModel& control, char letter, double number) {
    const OwnCode wanted{letter, number};
    const auto found = std::ranges::lower_bound(control.own_codes, wanted, in_order_of_codes);
    return found == control.own_codes.end() || in_order_of_codes(wanted, *found) ? nullptr : &*found;
}

/// Whether all codes of the letter that are the machine's own are told.
[[nodiscard]] inline bool are_listed(const ControlModel& control, char letter) {
    return control.letters_listed.find(letter) != std::string::npos;
}

/// "G54.1"; "T".
[[nodiscard]] inline std::string spelled(const OwnCode& code) {
    if (code.letter == tool_letter) return "T";
    const auto tenths = static_cast<std::int64_t>(std::lround(code.number * 10));
    std::string text = code.letter + std::to_string(tenths / 10);
    if (tenths % 10 != 0) text += "." + std::to_string(tenths % 10);
    return text;
}

/// Whether the code runs a program.
[[nodiscard]] inline bool calls_program(const OwnCode& code) { return code.program > 0; }
/// Whether it runs it as M98 does, without arguments: T, or an M code of parameters 6071 to 6079, whose
/// programs are O9001 to O9009 [T].
[[nodiscard]] inline bool calls_subprogram(const OwnCode& code) {
    constexpr std::int64_t first = 9000, last = 9009;
    return code.letter == tool_letter ||
           (code.letter == 'M' && first <= code.program && code.program <= last);
}

} // namespace maclint
