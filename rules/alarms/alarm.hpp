//! The alarms that controls number: what each means, what it is about, and whether the text of a program can
//! show that it will come.
#pragma once

#include "analyzer/program/tables.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace maclint {

/// The lists that number alarms, as ControlModel::alarms names them.
inline constexpr std::array<std::string_view, 4> alarm_lists = {"FANUC 16i/18i/21i", "FANUC 30i/0i-D", "NCT",
                                                                "SINUMERIK"};

/// What an alarm is about.
enum class AlarmSubject : std::uint8_t {
    program,         ///< what stands in a program
    real_time_macro, ///< what stands in a real-time macro of a program
    data_file,       ///< offsets, parameters and other data that are read in
    operation,       ///< what the operator does: MDI, editing, searches, restarts
    machine,         ///< axes, spindles, switches, other units
};

/// Whether the text of programs shows that the alarm will come.
enum class ShownByText : std::uint8_t { always, sometimes, never };

/// What stands behind number and title.
enum class AlarmBacking : std::uint8_t {
    document, ///< a document has both
    partly,   ///< documents have the cause, or the number on one of the lists
    memory,   ///< no document that is at hand
};

/// One number, which may stand for the same on several lists.
struct ControlAlarm {
    std::string_view number;                                 ///< "003"; "3000+n" of many
    std::array<std::string_view, alarm_lists.size()> titles; ///< by list; empty: it has not got the number
    std::optional<Machine> machine;                          ///< nothing: of mills and lathes
    std::string_view cause;                                  ///< what brings it, in our words
    AlarmSubject subject;
    ShownByText shown;
    AlarmBacking backing;
    std::string_view source; ///< keys of docs/sources.md

    /// As a list of the control has it; empty: it has not got the number.
    [[nodiscard]] std::string_view title_on(std::string_view list) const;
};

/// All tables, in the order of numbers.
[[nodiscard]] std::span<const std::span<const ControlAlarm>> alarm_tables();
/// The one with this number on a list, or nullptr.
[[nodiscard]] const ControlAlarm* find_alarm(std::string_view list, std::string_view number);

/// Why nothing raises an alarm that the text of programs always shows; empty: nobody has said.
[[nodiscard]] std::string_view why_not_found(std::string_view list, std::string_view number);

} // namespace maclint
