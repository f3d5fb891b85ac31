//! The controls themselves: their limits, and which machine types they come in.
#include "analyzer/dialect/fanuc/tables.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace maclint::fanuc {
namespace {

/// One row of the control table. Every row gives a mill and a lathe, named with "-lathe" after.
struct ControlRow {
    std::string_view model;
    std::string_view description;
    bool assumed;
    Limits limits;
    bool repeats_in_program_word; ///< M98 P51002 is 5 x O1002
    bool has_lathe;
    bool offset_is_group_12; ///< #4012 reads G54-G59
    bool decimals;           ///< variables like #30003.036 read settings and parameters
    bool increments;         ///< an I between address and value makes it incremental [NCT-9]
    std::string_view alarms; ///< the list of its alarms
    /// `M99O0810`, as a control punches it where a program ended without an end of block: O begins the next
    /// program. Dumps of programs have it [T].
    Reading program_behind_end;
};

constexpr Reading takes = Reading::takes, quiet = Reading::unknown;

// clang-format off
const std::array<ControlRow, 7> rows{{
    // model         description                              assumed  macro sub DO  first last [ ] source                                            P rep  lathe  #4012  decimals  ZI5    alarms              M99O2
    {"fanuc",        "FANUC, series not named",               true,  {4,     4, 3,  1,    3,    5,  "as 16i/18i/21i"},                                true,  true,  false, false, false, "FANUC 16i/18i/21i", takes},
    {"fanuc-16i",    "FANUC Series 16i/18i/21i",              false, {4,     4, 3,  1,    3,    5,  "MAN-PB278; SEED-001:462,395; MAN-16C287"},       true,  true,  false, false, false, "FANUC 16i/18i/21i", takes},
    {"fanuc-0i-c",   "FANUC Series 0i-B/C",                   false, {4,     4, 3,  1,    3,    5,  "TENC-G65; T"},                                   true,  true,  false, false, false, "FANUC 16i/18i/21i", takes},
    {"fanuc-0i-d",   "FANUC Series 0i-D/F",                   false, {5,    10, 3,  1,    3,    5,  "CNCWIKI-CALL, CNCWIKI-LOGIC; T"},                true,  true,  false, false, false, "FANUC 30i/0i-D",    takes},
    {"fanuc-30i",    "FANUC Series 30i/31i/32i",              false, {5,    10, 3,  1,    3,    5,  "CNCWIKI-CALL, CNCWIKI-LOGIC; T"},                true,  true,  false, false, false, "FANUC 30i/0i-D",    takes},
    {"nct",          "NCT 104-M",                             false, {4,     4, 3,  1,    3,    5,  "NCT-171; NCT-188; M98 and DO levels unknown"},   true,  false, false, false, true,  "NCT",               quiet},
    {"haas",         "Haas",                                  false, {9,     9, 3,  1,    3,    5,  "T"},                                             false, true,  true,  true,  false, "",                  quiet},
}};
// clang-format on

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

ControlModel make(const ControlRow& row, Machine machine) {
    ControlModel control;
    control.name = row.model;
    control.language = "fanuc";
    control.model = row.model;
    control.description = row.description;
    control.machine = machine;
    if (machine == Machine::lathe) {
        control.name += "-lathe";
        control.description += ", lathe with G code system A";
    }
    control.assumed = row.assumed;
    control.alarms = row.alarms;
    control.return_word = "M99"; // SEED-001:642
    control.limits = row.limits;
    control.spaces = variable_spaces();
    control.groups = machine == Machine::lathe ? lathe_groups() : mill_groups();
    std::optional<GroupId> group_twelve;
    if (row.offset_is_group_12) group_twelve = control.group_with(ModalRole::work_offset);
    control.families = {numbered_variables(control.groups, group_twelve)};
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
    control.idle = idle_values(control.groups);
    control.macro_numbers = {8000, 9999};           // T: those that parameter 3202 (NE8, NE9) protects
    control.repeatable = {"G", "M"};                // SEED-004:195; several M by parameter 3404#7
    control.repeatable_arguments = {"I", "J", "K"}; // 5.2: argument specification II
    return checked(std::move(control));
}

std::vector<ControlModel> make_all() {
    std::vector<ControlModel> controls;
    controls.reserve(2 * rows.size()); // mills point to their lathes
    for (const ControlRow& row : rows) {
        ControlModel& mill = controls.emplace_back(make(row, Machine::mill));
        if (row.has_lathe) mill.lathe = &controls.emplace_back(make(row, Machine::lathe));
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

bool program_word_holds_repeats(const ControlModel& control) {
    const auto* row = std::ranges::find(rows, control.model, &ControlRow::model);
    return row == rows.end() || row->repeats_in_program_word;
}

bool has_variables_with_decimals(const ControlModel& control) {
    const auto* row = std::ranges::find(rows, control.model, &ControlRow::model);
    return row != rows.end() && row->decimals;
}

bool has_incremental_words(const ControlModel& control) {
    const auto* row = std::ranges::find(rows, control.model, &ControlRow::model);
    return row != rows.end() && row->increments;
}

Reading program_behind_end(const ControlModel& control) {
    const auto* row = std::ranges::find(rows, control.model, &ControlRow::model);
    return row == rows.end() ? Reading::unknown : row->program_behind_end;
}

std::string controls_with_incremental_words() {
    std::string names;
    for (const ControlRow& row : rows)
        if (row.increments) names += (names.empty() ? "" : " or ") + std::string(row.model);
    return names;
}

} // namespace maclint::fanuc
