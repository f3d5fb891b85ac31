//! The tables of alarms, a file each.
#pragma once

#include "rules/alarms/alarm.hpp"

namespace maclint::alarms {

inline constexpr auto program = AlarmSubject::program;
inline constexpr auto real_time = AlarmSubject::real_time_macro;
inline constexpr auto data = AlarmSubject::data_file;
inline constexpr auto operation = AlarmSubject::operation;
inline constexpr auto machine = AlarmSubject::machine;
inline constexpr auto always = ShownByText::always;
inline constexpr auto sometimes = ShownByText::sometimes;
inline constexpr auto never = ShownByText::never;
inline constexpr auto document = AlarmBacking::document;
inline constexpr auto partly = AlarmBacking::partly;
inline constexpr auto memory = AlarmBacking::memory;
inline constexpr std::optional<Machine> both = std::nullopt;
inline constexpr std::optional<Machine> mill = Machine::mill;
inline constexpr std::optional<Machine> lathe = Machine::lathe;

[[nodiscard]] std::span<const ControlAlarm> fanuc_below_100();
[[nodiscard]] std::span<const ControlAlarm> fanuc_below_400();
[[nodiscard]] std::span<const ControlAlarm> fanuc_from_400();
[[nodiscard]] std::span<const ControlAlarm> nct();
[[nodiscard]] std::span<const ControlAlarm> sinumerik_below_14000();
[[nodiscard]] std::span<const ControlAlarm> sinumerik_from_14000();

/// An alarm on programs that their text always shows, and that nothing raises.
struct NotFound {
    std::string_view list;
    std::string_view number;
    std::string_view why;
};
[[nodiscard]] std::span<const NotFound> not_found();

} // namespace maclint::alarms
