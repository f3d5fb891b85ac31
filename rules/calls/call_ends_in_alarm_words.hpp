//! What MAC470 says of a call.
#pragma once

#include "rules/calls/call_ends_in_alarm_finder.hpp"
#include "rules/finding.hpp"

#include <string>
#include <string_view>

namespace maclint::rules {

/// The variables that decide: "#7 (D), #9 (F)"; empty where none is known.
[[nodiscard]] std::string names_of(const AlarmedCall& call);

/// Where the machine stops: "'#3000=1 (NO D)' on line 12".
[[nodiscard]] std::string alarm_of(const AlarmedCall& call);

/// The message for the reason.
[[nodiscard]] std::string_view message_for(const AlarmedCall& call);

/// How the called program gets to its alarm.
void add_steps(Finding& finding, const AlarmedCall& call);

} // namespace maclint::rules
