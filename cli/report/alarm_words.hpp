//! What the fields of an alarm are called in pages.
#pragma once

#include "rules/alarms/alarm.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// "programs of lathes", "real-time macros".
[[nodiscard]] std::string subject_words(const ControlAlarm& alarm);
/// "the text of the program, always".
[[nodiscard]] std::string shown_words(const ControlAlarm& alarm);
/// "a document", "no document at hand".
[[nodiscard]] std::string_view backing_words(AlarmBacking backing);
/// What to say where no rule finds what brings it.
[[nodiscard]] std::string_view nothing_finds_it(ShownByText shown);
/// The keys of its sources, one each.
[[nodiscard]] std::vector<std::string> sources_of(const ControlAlarm& alarm);

} // namespace maclint::cli
