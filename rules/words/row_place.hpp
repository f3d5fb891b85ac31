//! Where a row holds: on which controls, in which sections.
#pragma once

#include "rules/words/rule_row.hpp"

#include <string_view>

namespace maclint {

/// For the section of a program that names none, in a language that has sections: only what a code says
/// everywhere holds there.
inline constexpr std::string_view unknown_section = "?";

/// `sections`: names with '_' for blanks, blanks between them; empty: any.
[[nodiscard]] bool stands_in(std::string_view sections, std::string_view section);

/// `controls`: names or models; `systems`: of a lathe's G codes, "BC"; empty: any.
[[nodiscard]] bool is_one_of(const ControlModel& control, std::string_view controls,
                             std::string_view systems);

/// Whether the control is one of those that the row is for.
[[nodiscard]] bool is_of(const RowForCode& code, const ControlModel& control);
/// `section`: the kind of a section, or unknown_section.
[[nodiscard]] bool holds_in(const RowForCode& code, const ControlModel& control, std::string_view section);

} // namespace maclint
