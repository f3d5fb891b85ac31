//! Made from the table of alarms and from what rules and rows name, so that neither can be forgotten.
#include "cli/report/alarm_page.hpp"

#include "cli/report/alarm_words.hpp"
#include "cli/text/letters.hpp"
#include "cli/text/shown.hpp"
#include "rules/alarms/alarm_uses.hpp"
#include "rules/listed.hpp"

#include <algorithm>

namespace maclint::cli {
namespace {

std::string without_zeros(std::string_view number) {
    number.remove_prefix(std::min(number.find_first_not_of('0'), number.size() - 1));
    return std::string(number);
}

/// The digits behind "alarm ", "PS" and the like; empty where it is no number.
std::string number_in(std::string_view word) {
    std::string text = in_upper_case(word);
    for (const std::string_view before : {"ALARM", "P/S", "PS", "SR", "NO.", " "})
        while (text.starts_with(before)) text.erase(0, before.size());
    const bool is_number = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
    return is_number ? without_zeros(text) : std::string();
}

bool is_on(const ControlAlarm& alarm, std::string_view list) {
    return list.empty() || !alarm.title_on(list).empty();
}

/// "MAC551 integer-word-decimal", "MAC551 integer-word-decimal, rows H.point and P.point".
std::string words_of_use(const AlarmUse& use) {
    std::string name = std::string(use.rule->code) + " " + std::string(use.rule->name);
    constexpr std::size_t most_keys = 6;
    if (use.rows.size() > most_keys) return name + ", " + counted(use.rows.size(), "row");
    std::vector<std::string> keys;
    for (const RuleRow* row : use.rows) keys.push_back(row->key);
    if (!keys.empty()) name += (keys.size() == 1 ? ", row " : ", rows ") + rules::listed(keys, " and ");
    return name;
}

bool says_more_than_title(const ControlAlarm& alarm) {
    return std::ranges::find(alarm.titles, alarm.cause) == alarm.titles.end();
}

void add_rules(PlainPage& page, const ControlAlarm& alarm, std::string_view only) {
    page.add_heading("Rules that find what brings it:");
    bool is_found = false;
    for (const std::string_view list : alarm_lists) {
        if (alarm.title_on(list).empty() || (!only.empty() && list != only)) continue;
        for (const AlarmUse& use : uses_of(list, alarm.number)) {
            is_found = true;
            page.add_item(words_of_use(use) + ": " + std::string(use.rule->summary) + " (" +
                          std::string(list) + ")");
        }
    }
    if (!is_found) page.add_item(std::string(nothing_finds_it(alarm.shown)));
}

} // namespace

std::vector<const ControlAlarm*> alarms_named(std::string_view word, std::string_view list) {
    std::vector<const ControlAlarm*> found;
    const std::string number = number_in(word);
    if (number.empty()) return found;
    for (const std::span<const ControlAlarm> table : alarm_tables())
        for (const ControlAlarm& alarm : table)
            if (without_zeros(alarm.number) == number && is_on(alarm, list)) found.push_back(&alarm);
    return found;
}

std::string plain_alarm_page(const ControlAlarm& alarm, std::string_view list, const PageStyle& style) {
    PlainPage page(style);
    page.add_title("Alarm " + std::string(alarm.number), std::string(subject_words(alarm)));
    for (const std::string_view known : alarm_lists)
        if (!alarm.title_on(known).empty() && (list.empty() || list == known))
            page.add(std::string(known) + ": " + std::string(alarm.title_on(known)));
    if (says_more_than_title(alarm)) {
        page.add_heading("What brings it:");
        page.add_item(alarm.cause);
    }
    page.add_heading("What shows it:");
    page.add_item(shown_words(alarm));
    add_rules(page, alarm, list);
    page.add_heading("Source of number and title (" + std::string(backing_words(alarm.backing)) + "):");
    for (const std::string& source : sources_of(alarm)) page.add_source(source);
    return page.take();
}

} // namespace maclint::cli
