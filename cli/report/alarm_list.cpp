//! docs/alarms.md: every alarm of every list, and what finds it.
#include "cli/report/alarm_page.hpp"
#include "cli/report/alarm_words.hpp"
#include "cli/report/rule_page.hpp"
#include "cli/text/shown.hpp"
#include "rules/alarms/alarm_uses.hpp"

#include <array>

namespace maclint::cli {
namespace {

constexpr std::array<AlarmSubject, 5> subjects = {AlarmSubject::program, AlarmSubject::real_time_macro,
                                                  AlarmSubject::data_file, AlarmSubject::operation,
                                                  AlarmSubject::machine};

std::string_view heading_of(AlarmSubject subject) {
    switch (subject) {
    case AlarmSubject::program: return "What programs say";
    case AlarmSubject::real_time_macro: return "What real-time macros say";
    case AlarmSubject::data_file: return "What files of data say";
    case AlarmSubject::operation: return "What the operator does";
    case AlarmSubject::machine: return "What the machine does";
    }
    return {};
}

/// What of an alarm's cell cannot stand in a table.
std::string cell(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '|' || c == '<') out += '\\';
        out += c;
    }
    return out;
}

/// "[MAC301](rules/MAC301.md), [MAC551](rules/MAC551.md) (26 rows)", "not found".
std::string finders_of(const ControlAlarm& alarm, std::string_view list) {
    std::string text;
    for (const AlarmUse& use : uses_of(list, alarm.number)) {
        text += (text.empty() ? "[" : ", [") + std::string(use.rule->code) + "](rules/" +
                page_name(*use.rule) + ")";
        if (use.rows.size() == 1) text += " (`" + use.rows.front()->key + "`)";
        if (use.rows.size() > 1) text += " (" + counted(use.rows.size(), "row") + ")";
    }
    if (!text.empty()) return text;
    if (alarm.shown == ShownByText::never) return "";
    const std::string_view why = why_not_found(list, alarm.number);
    return why.empty() ? "not found" : "not found: " + std::string(why);
}

std::string_view short_shown(ShownByText shown) {
    return shown == ShownByText::always ? "always" : shown == ShownByText::sometimes ? "sometimes" : "never";
}

/// The alarms of one subject on one list, as a table; empty where there are none.
std::string table_of(std::string_view list, AlarmSubject subject) {
    std::string rows;
    for (const std::span<const ControlAlarm> table : alarm_tables())
        for (const ControlAlarm& alarm : table) {
            if (alarm.subject != subject || alarm.title_on(list).empty()) continue;
            rows += "| " + std::string(alarm.number) + " | " + cell(alarm.title_on(list)) + " | " +
                    cell(alarm.cause) +
                    (!alarm.machine                    ? ""
                     : *alarm.machine == Machine::mill ? " (mills)"
                                                       : " (lathes)") +
                    " | " + std::string(short_shown(alarm.shown)) + " | " + finders_of(alarm, list) + " | " +
                    cell(alarm.source) +
                    (alarm.backing == AlarmBacking::memory ? " (number not confirmed)" : "") + " |\n";
        }
    if (rows.empty()) return {};
    return "\n### " + std::string(heading_of(subject)) +
           "\n\n| number | title | what brings it | text shows it | found by | source "
           "|\n|---|---|---|---|---|---|\n" +
           rows;
}

struct Count {
    std::size_t all = 0, found = 0;
};

/// Alarms on the text of programs that it shows so often.
Count count_of(std::string_view list, ShownByText shown) {
    Count count;
    for (const std::span<const ControlAlarm> table : alarm_tables())
        for (const ControlAlarm& alarm : table) {
            if (alarm.subject != AlarmSubject::program || alarm.shown != shown ||
                alarm.title_on(list).empty())
                continue;
            ++count.all;
            if (!uses_of(list, alarm.number).empty()) ++count.found;
        }
    return count;
}

std::string of_all(const Count& count) {
    return std::to_string(count.found) + " of " + std::to_string(count.all);
}

} // namespace

std::string markdown_alarms() {
    std::string out = "# Alarms\n\n" + std::string(alarms_mark) +
                      " `maclint explain 128` prints what is known of one.\n\n"
                      "A finding names the alarm, as in \"(alarm 128)\", where the control that the program "
                      "is for has a list here and "
                      "the rule or row says which number that list has for it. Numbers that no document at "
                      "hand confirms are marked.\n\n"
                      "| list | found of those that programs always show | of those that they show in some "
                      "cases |\n|---|---|---|\n";
    for (const std::string_view list : alarm_lists) {
        const Count always = count_of(list, ShownByText::always);
        const Count sometimes = count_of(list, ShownByText::sometimes);
        out += "| " + std::string(list) + " | " + of_all(always) + " | " + of_all(sometimes) + " |\n";
    }
    for (const std::string_view list : alarm_lists) {
        out += "\n## " + std::string(list) + "\n";
        for (const AlarmSubject subject : subjects) out += table_of(list, subject);
    }
    return out + "\n[What the keys stand for](sources.md)\n";
}

} // namespace maclint::cli
