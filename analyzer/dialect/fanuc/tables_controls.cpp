//! The controls themselves: their limits, and which machine types they come in.
#include "analyzer/dialect/fanuc/tables.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace maclint::fanuc {
namespace {

/// One row of the control table. Every row gives a mill, and a lathe for each G code system that it has:
/// "-lathe" stands after the name, and the system where it is not A ("fanuc-16i-lathe-b").
struct ControlRow {
    std::string_view model;
    std::string_view description;
    bool assumed;
    Limits limits;
    bool repeats_in_program_word;   ///< M98 P51002 is 5 x O1002
    std::string_view lathe_systems; ///< "ABC"; empty: no lathe is known
    bool offset_is_group_12;        ///< #4012 reads G54-G59
    bool decimals;                  ///< variables like #30003.036 read settings and parameters
    bool increments;                ///< an I between address and value makes it incremental [NCT-9]
    bool whole_lengths;      ///< X325 is 325 mm [NCT-40]; a FANUC does so where parameter 3401#0 says it
    std::string_view alarms; ///< the list of its alarms
    /// `M99O0810`, as a control punches it where a program ended without an end of block: O begins the next
    /// program. Dumps of programs have it [T].
    Reading program_behind_end;
    bool cycle_ended_by_motion; ///< G00 and its like end a canned cycle, as G80 does
    bool return_jumps;          ///< `M99 P10` goes to N10 of its own program, not of the caller's
};

constexpr Reading takes = Reading::takes, quiet = Reading::unknown;

// clang-format off
const std::array<ControlRow, 10> rows{{
    // model         description                              assumed  macro sub DO  first last [ ] source                                            P rep  lathes #4012  decimals  ZI5    X325   alarms              M99O2  G0=G80 M99P
    {"fanuc",        "FANUC, series not named",               true,  {4,     4, 3,  1,    3,    5,  "as 16i/18i/21i"},                                true,  "ABC", false, false, false, false, "FANUC 16i/18i/21i", takes, true,  false},
    {"fanuc-16i",    "FANUC Series 16i/18i/21i",              false, {4,     4, 3,  1,    3,    5,  "MAN-PB278; SEED-001:462,395; MAN-16C287"},       true,  "ABC", false, false, false, false, "FANUC 16i/18i/21i", takes, true,  false},
    {"fanuc-0i-c",   "FANUC Series 0i-B/C",                   false, {4,     4, 3,  1,    3,    5,  "TENC-G65; T"},                                   true,  "ABC", false, false, false, false, "FANUC 16i/18i/21i", takes, true,  false},
    {"fanuc-0i-d",   "FANUC Series 0i-D/F",                   false, {5,    10, 3,  1,    3,    5,  "CNCWIKI-CALL, CNCWIKI-LOGIC; T"},                true,  "ABC", false, false, false, false, "FANUC 30i/0i-D",    takes, true,  false},
    {"fanuc-30i",    "FANUC Series 30i/31i/32i",              false, {5,    10, 3,  1,    3,    5,  "CNCWIKI-CALL, CNCWIKI-LOGIC; T"},                true,  "ABC", false, false, false, false, "FANUC 30i/0i-D",    takes, true,  false},
    {"nct",          "NCT 104-M",                             false, {4,     4, 3,  1,    3,    5,  "NCT-171; NCT-188; M98 and DO levels unknown"},   true,  "",    false, false, true,  true,  "NCT",               quiet, true,  false},
    {"haas",         "Haas",                                  false, {9,     9, 3,  1,    3,    5,  "T"},                                             false, "A",   true,  true,  false, false, "",                  quiet, true,  true},
    // Its manual of 1999 names G80 alone.
    {"haas-1999",    "Haas of before 2000",                   false, {9,     9, 3,  1,    3,    5,  "T"},                                             false, "A",   true,  true,  false, false, "",                  quiet, false, true},
    // Second hand: of these two only what the columns say is known.
    {"mitsubishi",   "Mitsubishi M700/M800",                  false, {4,     8, 27, 1,    127,  5,  "CNCWIKI-CALL, CNCWIKI-SUB, CNCWIKI-LOGIC; T"},   false, "ABC", false, false, false, false, "",                  quiet, true,  false},
    {"mazak-eia",    "Mazak EIA/ISO",                         false, {4,     8, 27, 1,    127,  5,  "T, as Mitsubishi"},                              false, "ABC", false, false, false, false, "",                  quiet, true,  false},
}};
// clang-format on

/// "haas or nct"; "haas" stands for "haas-1999", too.
template<class Has>
std::string names_of(const Has& has) {
    std::string names;
    std::string_view last;
    for (const ControlRow& row : rows) {
        if (!has(row) || (!last.empty() && row.model.starts_with(last))) continue;
        last = row.model;
        names += (names.empty() ? "" : " or ") + std::string(row.model);
    }
    return names;
}

/// Of a control that nobody named. Calls: of the FANUC series; loop numbers: those of Mitsubishi, too.
constexpr Limits most{5, 10, 27, 1, 127, 5, "CNCWIKI-CALL, CNCWIKI-LOGIC; T"};

std::vector<CallKind> call_kinds() {
    // clang-format off
    return {
        {"G65 macro call",                       Frame::fresh,  NestingLimit::macro,      CallTrigger::once,              0,    "SEED-001:423"},
        {"G66 modal macro call",                 Frame::fresh,  NestingLimit::macro,      CallTrigger::after_each_motion, 66,   "SEED-001:466"},
        {"G66.1 modal macro call",               Frame::fresh,  NestingLimit::macro,      CallTrigger::after_each_block,  66.1, "NCT-171"},
        {"M98 subprogram call",                  Frame::shared, NestingLimit::subprogram, CallTrigger::once,              0,    "TENC-G65; CPH-M98"},
        {"M198 subprogram call",                 Frame::shared, NestingLimit::subprogram, CallTrigger::once,              0,    "CNCWIKI-SUB"},
    };
    // clang-format on
}

/// `system` is the G code system of a lathe, 0 of a mill.
ControlModel make(const ControlRow& row, char system) {
    ControlModel control;
    const Machine machine = system == 0 ? Machine::mill : Machine::lathe;
    control.name = row.model;
    control.language = "fanuc";
    control.model = row.model;
    control.description = row.description;
    control.machine = machine;
    if (machine == Machine::lathe) {
        control.name += "-lathe";
        if (system != 'A') control.name += std::string{'-', static_cast<char>(system - 'A' + 'a')};
        control.description += std::string(", lathe with G code system ") + system;
    }
    control.code_system = system;
    control.assumed = row.assumed;
    control.alarms = row.alarms;
    control.return_word = "M99"; // SEED-001:642
    control.limits = row.limits;
    control.spaces = variable_spaces();
    control.groups = machine == Machine::lathe ? lathe_groups(system) : mill_groups();
    // T: a canned cycle is cancelled by G80 or by a G code of group 01.
    if (row.cycle_ended_by_motion)
        control.groups[*control.group_with(ModalRole::cycle)].ended_by = ModalRole::motion;
    control.has_block_if = reading_of(control, SyntaxErrorKind::missing_construct) == Reading::takes;
    if (row.assumed) control.limits_at_most = most;
    if (row.assumed) control.returns_within = names_of([](const ControlRow& r) { return r.return_jumps; });
    std::optional<GroupId> group_twelve;
    if (row.offset_is_group_12) group_twelve = control.group_with(ModalRole::work_offset);
    control.families = {numbered_variables(control.groups, group_twelve, row.model)};
    control.calls = call_kinds();
    for (std::size_t i = 0; i < local_of_letter.size(); ++i) {
        if (local_of_letter[i] == 0) continue;
        control.formals.push_back({spaces::local, local_of_letter[i]});
        control.formal_letters.push_back(static_cast<char>('A' + i));
    }
    for (std::int32_t first = 4; first <= 31; first += 3) // ZAPP-ARG: I1 is #4, K10 is #33
        control.series.push_back(
            {{{spaces::local, first}, {spaces::local, first + 1}, {spaces::local, first + 2}}});
    control.vacant_equals_zero = false;
    control.calculator_input = row.whole_lengths;
    control.numbering_arguments = "DHSTM"; // [MAN-PB278]
    control.options = options_of(row.model);
    control.idle = idle_values(control.groups);
    control.machine_words = &machine_words(system);
    control.switches = switch_rows();
    control.first_free_code = 100; // parameters 6050-6059 make a G code of up to four digits call a macro [T]
    control.macro_numbers = {8000, 9999};           // T: those that parameter 3202 (NE8, NE9) protects
    control.repeatable = {"G", "M"};                // SEED-004:195; several M by parameter 3404#7
    control.repeatable_arguments = {"I", "J", "K"}; // 5.2: argument specification II
    return checked(std::move(control));
}

std::vector<ControlModel> make_all() {
    std::vector<ControlModel> controls;
    controls.reserve(4 * rows.size()); // mills point to their lathes
    for (const ControlRow& row : rows) {
        ControlModel& mill = controls.emplace_back(make(row, 0));
        for (const char system : row.lathe_systems)
            mill.lathes.push_back(&controls.emplace_back(make(row, system)));
        // "-lathe" alone names no system: the text tells.
        if (!mill.lathes.empty()) controls[controls.size() - mill.lathes.size()].lathes = mill.lathes;
    }
    return controls;
}

} // namespace

std::span<const ControlModel> fanuc_controls() {
    static const std::vector<ControlModel> controls = make_all();
    return controls;
}

const ControlModel& fanuc_control(std::string_view name) {
    const auto control = std::ranges::find(fanuc_controls(), name, &ControlModel::name);
    assert(control != fanuc_controls().end());
    return *control;
}

namespace {

/// nullptr: a control of another family.
const ControlRow* row_of(const ControlModel& control) {
    const auto* row = std::ranges::find(rows, control.model, &ControlRow::model);
    return row == rows.end() ? nullptr : row;
}

} // namespace

bool program_word_holds_repeats(const ControlModel& control) {
    const ControlRow* row = row_of(control);
    return row == nullptr || row->repeats_in_program_word;
}

bool has_variables_with_decimals(const ControlModel& control) {
    const ControlRow* row = row_of(control);
    return row != nullptr && row->decimals;
}

bool has_incremental_words(const ControlModel& control) {
    const ControlRow* row = row_of(control);
    return row != nullptr && row->increments;
}

bool return_jumps_in_program(const ControlModel& control) {
    const ControlRow* row = row_of(control);
    return row != nullptr && row->return_jumps;
}

Reading program_behind_end(const ControlModel& control) {
    const ControlRow* row = row_of(control);
    return row == nullptr ? Reading::unknown : row->program_behind_end;
}

std::string controls_with_incremental_words() {
    return names_of([](const ControlRow& row) { return row.increments; });
}

} // namespace maclint::fanuc
