//! Counts what stands in the tables.
#include "cli/report/control_facts.hpp"

#include "rules/alarms/alarm_uses.hpp"
#include "rules/words/code_pages.hpp"
#include "rules/words/word_list.hpp"

#include <algorithm>

namespace maclint::cli {
namespace {

void add_chapters(const ControlModel& control, ControlFacts& facts) {
    for (const CodePage& page : all_code_pages()) {
        if (!page.is_of(control)) continue;
        if (facts.chapters.empty() || facts.chapters.back().chapter != page.book->chapter)
            facts.chapters.push_back({.chapter = page.book->chapter, .codes = {}});
        ChapterFacts& chapter = facts.chapters.back();
        for (const std::string_view code : words_of(page.head->row.code))
            if (std::ranges::find(chapter.codes, code) == chapter.codes.end()) chapter.codes.push_back(code);
        chapter.words +=
            static_cast<std::size_t>(std::ranges::count_if(page.lines, [&](const BookLine& line) {
                return line.kind == BookLine::Kind::word && is_of(line, control);
            }));
    }
    std::vector<std::string_view> codes; // one may stand in several chapters, for several places
    for (const ChapterFacts& chapter : facts.chapters) {
        codes.insert(codes.end(), chapter.codes.begin(), chapter.codes.end());
        facts.words += chapter.words;
    }
    std::ranges::sort(codes);
    facts.codes = static_cast<std::size_t>(std::ranges::unique(codes).begin() - codes.begin());
}

void add_alarms(const ControlModel& control, ControlFacts& facts) {
    for (const std::span<const ControlAlarm> table : alarm_tables())
        for (const ControlAlarm& alarm : table) {
            if (alarm.title_on(control.alarms).empty()) continue;
            ++facts.alarms;
            if (!uses_of(control.alarms, alarm.number).empty()) ++facts.alarms_found;
        }
}

} // namespace

ControlFacts facts_of(const ControlModel& control) {
    ControlFacts facts;
    add_chapters(control, facts);
    for (const VariableFamily& family : control.families)
        for (const VariableRange& range : family.ranges)
            if (range.meaning != Meaning::absent) facts.variables.push_back(&range);
    add_alarms(control, facts);
    const Limits& limits = control.limits;
    const auto add = [&](std::string_view what, int limit) {
        if (limit != 0) facts.limits.emplace_back(what, limit);
    };
    add("nested macro calls", limits.macro_calls);
    add("nested subprogram calls", limits.subprogram_calls);
    add("nested loops", limits.loop_levels);
    add("highest number of a loop", limits.last_loop_number);
    add("nested brackets", limits.bracket_levels);
    return facts;
}

std::string machine_of(const ControlModel& control) {
    if (control.machine == Machine::mill) return "mill";
    return control.code_system == 0 ? "lathe" : std::string("lathe, G code system ") + control.code_system;
}

} // namespace maclint::cli
