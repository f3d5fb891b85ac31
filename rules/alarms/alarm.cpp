//! The one place that lists the tables of alarms.
#include "rules/alarms/alarm.hpp"

#include "rules/alarms/tables.hpp"

#include <algorithm>

namespace maclint {

std::string_view ControlAlarm::title_on(std::string_view list) const {
    const auto at = std::ranges::find(alarm_lists, list) - alarm_lists.begin();
    return static_cast<std::size_t>(at) == alarm_lists.size() ? std::string_view()
                                                              : titles.at(static_cast<std::size_t>(at));
}

std::span<const std::span<const ControlAlarm>> alarm_tables() {
    static const std::array<std::span<const ControlAlarm>, 6> tables = {
        alarms::fanuc_below_100(),       alarms::fanuc_below_400(),
        alarms::fanuc_from_400(),        alarms::nct(),
        alarms::sinumerik_below_14000(), alarms::sinumerik_from_14000()};
    return tables;
}

const ControlAlarm* find_alarm(std::string_view list, std::string_view number) {
    for (const std::span<const ControlAlarm> table : alarm_tables())
        for (const ControlAlarm& alarm : table)
            if (alarm.number == number && !alarm.title_on(list).empty()) return &alarm;
    return nullptr;
}

std::string_view why_not_found(std::string_view list, std::string_view number) {
    const auto rows = alarms::not_found();
    const auto row = std::ranges::find_if(
        rows, [&](const alarms::NotFound& entry) { return entry.list == list && entry.number == number; });
    return row == rows.end() ? std::string_view() : row->why;
}

} // namespace maclint
