//! Asks the rules' records and the rows, so that nobody has to list it a second time.
#include "rules/alarms/alarm_uses.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace maclint {
namespace {

using Uses = std::map<std::pair<std::string_view, std::string_view>, std::vector<AlarmUse>>;

/// The rule's entry among the uses of an alarm; rules come in their order, each with all of its rows.
AlarmUse& entry_of(Uses& uses, std::string_view list, std::string_view number, const Rule& rule) {
    std::vector<AlarmUse>& all = uses[{list, number}];
    if (all.empty() || all.back().rule != &rule) all.push_back({&rule, {}});
    return all.back();
}

Uses find_uses() {
    Uses uses;
    for (const Rule* rule : all_rules()) {
        for (const Alarm& alarm : rule->alarms) entry_of(uses, alarm.control, alarm.number, *rule);
        for (const RuleRow& row : rows_of(*rule))
            for (const RowForCode& entry : row.rows)
                for (const RowAlarm& alarm : entry.row->alarms) {
                    if (alarm.number.empty()) continue;
                    auto& rows = entry_of(uses, alarm.control, alarm.number, *rule).rows;
                    if (rows.empty() || rows.back() != &row) rows.push_back(&row);
                }
    }
    return uses;
}

} // namespace

std::span<const AlarmUse> uses_of(std::string_view list, std::string_view number) {
    static const Uses uses = find_uses();
    const auto found = uses.find({list, number});
    return found == uses.end() ? std::span<const AlarmUse>() : std::span(found->second);
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
