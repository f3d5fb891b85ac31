//! Asks the rules' records and the rows, so that nobody has to list it a second time.
#include "rules/alarms/alarm_uses.hpp"

#include <algorithm>

namespace maclint {
namespace {

bool names(const WordRow& row, const AlarmName& alarm) {
    return std::ranges::any_of(row.alarms, [&](const RowAlarm& own) {
        return own.control == alarm.list && own.number == alarm.number;
    });
}

} // namespace

std::vector<AlarmUse> uses_of(std::string_view list, std::string_view number) {
    const AlarmName wanted{list, number};
    std::vector<AlarmUse> uses;
    for (const Rule* rule : all_rules()) {
        AlarmUse use{rule, {}};
        for (const RuleRow& row : rows_of(*rule))
            if (std::ranges::any_of(row.rows,
                                    [&](const RowForCode& entry) { return names(*entry.row, wanted); }))
                use.rows.push_back(&row);
        const bool is_named = std::ranges::any_of(rule->alarms, [&](const Alarm& alarm) {
            return AlarmName{alarm.control, alarm.number} == wanted;
        });
        if (is_named || !use.rows.empty()) uses.push_back(std::move(use));
    }
    return uses;
}

std::vector<AlarmName> alarms_of(const Rule& rule) {
    std::vector<AlarmName> names;
    const auto add = [&](const AlarmName& name) {
        if (!name.number.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
    };
    for (const Alarm& alarm : rule.alarms) add({alarm.control, alarm.number});
    for (const RuleRow& row : rows_of(rule))
        for (const RowForCode& entry : row.rows)
            for (const RowAlarm& alarm : entry.row->alarms) add({alarm.control, alarm.number});
    return names;
}

} // namespace maclint
