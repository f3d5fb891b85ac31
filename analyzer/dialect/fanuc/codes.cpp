//! The code table and its index.
#include "analyzer/dialect/fanuc/codes.hpp"

#include "analyzer/dialect/fanuc/plain.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/program/own_codes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>
#include <utility>
#include <vector>

namespace maclint::fanuc {
namespace {

constexpr std::uint16_t own = own_effect;
constexpr std::uint16_t sync = synchronises;
constexpr std::uint16_t rapid = without_feed;
constexpr std::uint16_t limit = limits_ahead;
constexpr std::uint16_t ref = to_reference;
constexpr std::string_view mill = "M", lathe = "ABC", lathe_a = "A", lathe_bc = "BC", both = "MABC";

// A code that is missing here only sets its modal group, if it has one. Sources: fanuc-custom-macro.md
// (section or key), T: general knowledge of the control, not confirmed by a manual page.
// clang-format off
constexpr CodeFact facts[] = {
    {'G',   4,   both,  sync | no_words,           "6: G4 stops pre-reading on some controls; P, X, U are the time"},
    {'G',   5.1, mill,  no_axes,                   "T: G5.1 Q1 X0 Y0 Z0 selects axes"},
    {'G',   7.1, both,  no_axes,                   "T: cylindrical interpolation, the word is a radius"},
    {'G', 107,   both,  no_axes,                   "T: G7.1 on older controls"},
    {'G',  10,   both,  own | sync | no_words,     "7: data setting"},
    {'G',  11,   both,  own | sync | no_words,     "7: end of data setting"},
    {'G',  10.6, both,  no_axes,                   "T: retract"},
    {'G',  22,   mill,  no_axes,                   "T: stored stroke limits X Y Z I J K"},
    {'G',  22,   lathe, no_axes,                   "T: stored stroke limits X Z I K"},
    {'G',  27,   both,  own | rapid | ref,         "T: reference position return check"},
    {'G',  28,   both,  own | sync | rapid | ref,  "T: reference position return"},
    {'G',  29,   both,  own | sync | ref,          "T: return from reference position"},
    {'G',  30,   both,  own | sync | rapid | ref,  "T: second reference position return"},
    {'G',  30.1, both,  own | sync | rapid | ref,  "T: floating reference position return"},
    {'G',  31,   both,  own | sync,                "6: G31 ends look-ahead on most controls"},
    {'G',  31.1, both,  own | sync,                "as G31"},
    {'G',  31.2, both,  own | sync,                "as G31"},
    {'G',  31.3, both,  own | sync,                "as G31"},
    {'G',  36,   both,  own | sync,                "T: automatic tool offset (skip)"},
    {'G',  37,   both,  own | sync,                "T: automatic tool length measurement (skip)"},
    {'G',  37.1, both,  own | sync,                "as G37"},
    {'G',  37.2, both,  own | sync,                "as G37"},
    {'G',  50,   lathe_a,  no_axes | limits_speed, "T: coordinate system setting, spindle speed limit"},
    {'G',  50,   lathe_bc, no_axes,                "T: scaling off"},
    {'G',  50.3, lathe_a, no_axes,                 "T: coordinate system preset"},
    {'G',  51,   mill,  no_axes,                   "T: scaling, axis words are its centre"},
    {'G',  51.1, mill,  no_axes,                   "T: mirror image, axis words are its axis"},
    {'G',  50.1, mill,  no_axes,                   "T: mirror image cancel, axis words name axes"},
    {'G',  52,   both,  own | no_axes,             "7: local coordinate system, axis words are the shift"},
    {'G',  53,   both,  own | sync,                "MAN-AINANO: machine coordinates; stops pre-reading"},
    {'G',  65,   both,  own | no_words,            "5.1"},
    {'G',  66,   both,  own | no_words,            "5.1"},
    {'G',  66.1, both,  own | no_words,            "5.1"},
    {'G',  67,   both,  own,                       "5.1"},
    {'G',  68,   mill,  no_axes,                   "T: rotation, axis words are its centre"},
    {'G',  68.2, mill,  no_axes,                   "T: tilted plane, words are origin and angles"},
    {'G',  92,   mill,  no_axes | limits_speed,    "T: coordinate system setting, spindle speed limit"},
    {'G',  92,   lathe_bc, no_axes | limits_speed, "GEDIT second hand: `G92 S` of systems B and C"},
    {'G',  92.1, both,  no_axes,                   "T: coordinate system preset"},
    {'G', 100,   both,  no_axes,                   "T: Haas, mirror image off, axis words name axes"},
    {'G', 101,   both,  no_axes,                   "T: Haas, mirror image on, axis words name axes"},
    {'G', 103,   both,  own | sync | no_words | limit, "HAAS-LA: P limits look-ahead, G103 and P0 end that"},
    {'G', 136,   both,  own | sync,                "T: Haas, work offset centre measurement (skip)"},
    {'G', 187,   both,  no_words,                  "T: Haas, smoothness: P and E are its own"},
    {'M',   0,   both,  own | sync,                "MAN-AINANO"},
    {'M',   1,   both,  own | sync,                "MAN-AINANO"},
    {'M',   2,   both,  own | sync,                "MAN-AINANO"},
    {'M',  30,   both,  own | sync,                "MAN-AINANO"},
    {'M',   6,   both,  own | sync,                "T: tool change, usually one of the codes of parameters 3411-3432"},
    {'M',  96,   both,  own | no_words,            "T: interruption macro on, P is its program"},
    {'M',  97,   both,  own,                       "T: interruption macro off; Haas: local subprogram call"},
    {'M',  98,   both,  own,                       "5.1"},
    {'M',  99,   both,  own,                       "5.1"},
    {'M', 198,   both,  own,                       "5.1"},
};
// clang-format on

std::size_t tenths(double code) { return static_cast<std::size_t>(std::lround(code * 10)); }

/// Codes of a hundred and more are where shops and builders put calls of macros (parameters 6050-6059: G
/// codes of 1 to 9999). Below that every control has codes of its own.
void mark_possible_calls(CodeTable& table) {
    constexpr int first_free = 100;
    for (std::size_t i = tenths(first_free); i < table.g.size(); i += tenths(1))
        if (table.g[i].group == no_group && table.g[i].traits == 0)
            table.g[i].traits = own | no_words | may_call;
}

CodeTable build(const ControlModel& control) {
    CodeTable table{};
    table.g.fill({.group = no_group, .traits = 0});
    table.m_groups.fill(no_group);
    for (std::size_t i = control.groups.size(); i-- > 0;)
        for (const ModalMember& member : control.groups[i].members) {
            const double code = member.number;
            if (control.groups[i].letter == 'G') table.g[tenths(code)].group = static_cast<GroupId>(i);
            if (control.groups[i].letter == 'M')
                table.m_groups[static_cast<std::size_t>(code)] = static_cast<GroupId>(i);
        }
    for (const CodeFact& fact : facts) {
        if (const char machine = control.machine == Machine::mill ? 'M' : control.code_system;
            fact.machines.find(machine) == std::string_view::npos)
            continue;
        if (fact.letter == 'G')
            table.g[tenths(fact.code)].traits = fact.traits;
        else
            table.m[static_cast<std::size_t>(fact.code)] = fact.traits;
    }
    mark_possible_calls(table);
    table.feed = control.group_with(ModalRole::feed).value_or(no_group);
    table.speed = control.group_with(ModalRole::speed).value_or(no_group);
    table.local_offset = control.group_with(ModalRole::local_offset).value_or(no_group);
    table.g[tenths(52)].group = no_group; // set or cancelled by its words, see lowering
    table.tool_changes_at_once = control.machine == Machine::lathe;
    table.plain = plain_tables(table);
    return table;
}

/// What the codes that call programs are else does not count.
CodeTable with_calls(CodeTable table, const ControlModel& control) {
    for (const OwnCode& code : control.own_codes) {
        if (!calls_program(code)) continue;
        const std::uint16_t traits = calls_subprogram(code) ? own : own | no_words | may_call;
        if (code.letter == 'G' && tenths(code.number) < table.g.size())
            table.g[tenths(code.number)] = {.group = no_group, .traits = traits};
        const auto number = static_cast<std::size_t>(code.number);
        if (code.letter == 'M' && number < table.m.size()) table.m[number] = traits;
        table.tool_calls_program |= code.letter == tool_letter;
        if (code.letter == 'M' && number < table.m_groups.size()) table.m_groups[number] = no_group;
    }
    table.plain = plain_tables(table);
    return table;
}

/// Kept for good: a shop has few machines, and programs point to the table.
const CodeTable& kept_with_calls(const ControlModel& control) {
    using Calls = std::vector<std::tuple<char, double, bool>>;
    static std::mutex mutex;
    static std::map<std::pair<const CodeTable*, Calls>, std::unique_ptr<const CodeTable>> tables;
    const CodeTable& usual = usual_codes_of(control);
    Calls calls;
    for (const OwnCode& code : control.own_codes)
        if (calls_program(code)) calls.emplace_back(code.letter, code.number, calls_subprogram(code));
    const std::scoped_lock lock(mutex);
    auto& table = tables[{&usual, std::move(calls)}];
    if (table == nullptr) table = std::make_unique<const CodeTable>(with_calls(usual, control));
    return *table;
}

} // namespace

Code CodeTable::g_code(double code) const {
    const double index = std::round(code * 10);
    if (!(index >= 0 && index < static_cast<double>(g_codes)) || std::abs(index - code * 10) > 1e-6)
        return {.group = no_group, .traits = 0};
    return g[static_cast<std::size_t>(index)];
}

std::uint16_t CodeTable::m_code(double code) const {
    if (!(code >= 0 && code < static_cast<double>(m_codes)) || code != std::floor(code)) return 0;
    return m[static_cast<std::size_t>(code)];
}

GroupId CodeTable::m_group(double code) const {
    if (!(code >= 0 && code < static_cast<double>(m_groups.size())) || code != std::floor(code))
        return no_group;
    return m_groups[static_cast<std::size_t>(code)];
}

const CodeTable& usual_codes_of(const ControlModel& control) {
    // All controls of a machine type and system share the layout of their modal groups.
    static const CodeTable of_mills = build(fanuc_control("fanuc"));
    static const CodeTable of_lathes_a = build(*fanuc_control("fanuc").lathe_of('A'));
    static const CodeTable of_lathes_b = build(*fanuc_control("fanuc").lathe_of('B'));
    static const CodeTable of_lathes_c = build(*fanuc_control("fanuc").lathe_of('C'));
    switch (control.code_system) {
    case 'A': return of_lathes_a;
    case 'B': return of_lathes_b;
    case 'C': return of_lathes_c;
    default: return of_mills;
    }
}

const CodeTable& codes_of(const ControlModel& control) {
    return std::ranges::any_of(control.own_codes, calls_program) ? kept_with_calls(control)
                                                                 : usual_codes_of(control);
}

} // namespace maclint::fanuc
