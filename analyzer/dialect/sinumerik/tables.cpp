//! The control, its variables, modal groups and calls.
#include "analyzer/dialect/sinumerik/tables.hpp"

#include "analyzer/dialect/sinumerik/g_codes.hpp"
#include "analyzer/dialect/sinumerik/word_list.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace maclint::sinumerik {
namespace {

/// What rules find a group by, and what a program may leave behind.
struct GroupRole {
    std::uint8_t group;
    ModalRole role;
    RestorePolicy restore;
};

// clang-format off
constexpr GroupRole roles[] = {
    { 1, ModalRole::motion,              RestorePolicy::none},
    { 6, ModalRole::plane,               RestorePolicy::none},
    { 7, ModalRole::cutter_compensation, RestorePolicy::operation},
    { 8, ModalRole::work_offset,         RestorePolicy::none},
    {13, ModalRole::units,               RestorePolicy::none},
    {14, ModalRole::distance,            RestorePolicy::state},
    {15, ModalRole::feed_mode,           RestorePolicy::none},
};

/// Parts of the programmable frame: each is in force or not, and TRANS alone takes all of them back
/// [SEED-004:71-135].
struct FramePart {
    std::string_view name;
    ModalRole role;
    std::string_view replaces, adds; ///< codes that write it
};
constexpr FramePart frame_parts[] = {
    {"shift",         ModalRole::local_offset, "TRANS",  "ATRANS"},
    {"rotation",      ModalRole::rotation,     "ROT",    "AROT"},
    {"scaling",       ModalRole::scaling,      "SCALE",  "ASCALE"},
    {"mirror image",  ModalRole::mirror_image, "MIRROR", "AMIRROR"},
    {"space angles",  ModalRole::tilted_plane, "ROTS",   "AROTS"},
};

/// What procedures switch on and off again.
struct Coupling {
    std::string_view name;
    std::string_view on, off; ///< procedures, blanks between them
    std::string_view source;
};
constexpr std::string_view transformation = "transformation"; ///< positions are no lengths in it
constexpr std::string_view rounding = "rounding of corners"; ///< RNDM=5 on, RNDM=0 off, gone when the job ends
constexpr Coupling couplings[] = {
    {transformation,        "TRANSMIT TRACYL TRAORI TRAANG TRACON", "TRAFOOF",       "HLS"},
    {"coupling of spindles", "COUPON COUPONC",                       "COUPOF COUPOFS", "HLS"},
    {"coupled motion",       "TRAILON",                              "TRAILOF",       "HLS"},
    {"leading axis",         "LEADON",                               "LEADOF",        "HLS"},
    {"tangential control",   "TANGON",                               "TANGOF",        "HLS"},
    {rounding,               "RNDM",                                 "RNDM=0",        "SEED-004:150-164"},
};
// clang-format on

constexpr int non_modal_moves = 2, frames = 3; ///< G groups
constexpr std::string_view source_of_g_groups = "MD20150, NCI";
constexpr std::string_view frame_off = "TRANS"; ///< alone in its block
constexpr std::uint8_t no_row = UINT8_MAX;

/// Of a group without codes nothing can be known.
bool is_followed(const GGroupRow& group) {
    return group.modal && std::ranges::find(g_codes(), group.number, &GCodeRow::group) != g_codes().end();
}

/// Rows of the control by the numbers of their G groups.
std::array<std::uint8_t, 256> rows_by_group() {
    std::array<std::uint8_t, 256> rows{};
    rows.fill(no_row);
    std::uint8_t next = 0;
    for (const GGroupRow& group : g_groups())
        if (is_followed(group)) rows[group.number] = next++;
    return rows;
}

const std::array<std::uint8_t, 256>& group_rows() {
    static const std::array<std::uint8_t, 256> rows = rows_by_group();
    return rows;
}

/// What is in force when a program begins: the maker of the machine chooses it [MD20150]. On a mill it is
/// what a control is delivered with, on a lathe these are other codes; who names neither has told nothing.
std::optional<double> in_force_at_start(const GGroupRow& group, std::optional<Machine> machine) {
    if (!machine) return std::nullopt;
    constexpr std::string_view of_lathes[] = {"G18", "G95", "DIAMON"};
    if (machine == Machine::lathe)
        for (const std::string_view name : of_lathes)
            if (const GCodeRow* code = find_g_code(name); code->group == group.number) return code->member;
    return group.reset == 0 ? std::nullopt : std::optional<double>(group.reset);
}

std::vector<ModalGroup> modal_groups(std::optional<Machine> machine) {
    std::vector<ModalGroup> groups;
    for (const GGroupRow& row : g_groups()) {
        if (!is_followed(row)) continue;
        ModalGroup& group = groups.emplace_back();
        group.name = row.what;
        group.letter = 'G';
        group.source = source_of_g_groups;
        group.reset = in_force_at_start(row, machine);
        const auto* role = std::ranges::find(roles, row.number, &GroupRole::group);
        if (role != std::end(roles)) {
            group.role = role->role;
            group.restore_policy = role->restore;
            if (role->role == ModalRole::distance) group.customary = {1};       // G90
            if (role->role == ModalRole::motion) group.circles = {3, 4, 5, 15}; // G2, G3, CIP, CT
            if (role->restore == RestorePolicy::operation) {                    // G40
                group.cancel = 1;
                group.customary = {1};
                group.reset = 1; // whatever the maker of the machine has chosen for the other groups
            }
        }
        for (const GCodeRow& code : g_codes())
            if (code.group == row.number) group.members.emplace_back(code.member, code.name);
        std::ranges::sort(group.members, {}, &ModalMember::number);
    }
    groups.push_back({"feed", ModalRole::feed, 'F', RestorePolicy::none, {}, {}, {}, {}, "NCP19"});
    groups.push_back({"spindle speed", ModalRole::speed, 'S', RestorePolicy::none, {}, {}, {}, {}, "NCP19"});
    for (const FramePart& part : frame_parts) {
        ModalGroup& group = groups.emplace_back();
        group = {part.name, part.role, 'G', RestorePolicy::operation, {}, {0}, 0, 0, "SEED-004:71-135"};
        group.members = {{0, frame_off}, {1, part.replaces}};
        group.cancel_words = frame_off;
    }
    for (const Coupling& coupling : couplings) {
        ModalGroup& group = groups.emplace_back();
        const bool bends = coupling.name == transformation;
        group = {coupling.name,
                 bends ? ModalRole::polar_interpolation : ModalRole::other,
                 'G',
                 RestorePolicy::operation,
                 {},
                 {0},
                 0,
                 0,
                 coupling.source};
        const std::string_view off = coupling.off.substr(0, coupling.off.find(' '));
        group.members = {{0, off}};
        double code = 0;
        for_each_word(coupling.on, [&](std::string_view word) { group.members.emplace_back(++code, word); });
        group.cancel_words = off;
        if (coupling.name == rounding) group.restore_policy = RestorePolicy::cycle;
    }
    ModalGroup& call = groups.emplace_back();
    call = {"modal call",      ModalRole::macro_call, 0, RestorePolicy::modal_call, {}, {0}, 0, 0,
            "SEED-004:460-474"};
    call.cancel_words = "MCALL";
    return groups;
}

VariableFamily r_parameters() {
    constexpr std::int32_t last = 32767; // MD28050 says how many there are
    return {"R",
            {{.first = 0,
              .last = last,
              .meaning = Meaning::variable,
              .space = spaces::r,
              .group = 0,
              .on_write = OnWrite::store,
              .changes_by_itself = false,
              .what = "R parameter",
              .source = "JP10 p.23, MD28050"}}};
}

/// System variables, those that the machine's maker defines, axes and macros: nobody knows their values.
VariableFamily owned() {
    return {"",
            {{.first = 0,
              .last = INT32_MAX,
              .meaning = Meaning::machine,
              .space = spaces::machine,
              .group = 0,
              .on_write = OnWrite::store,
              .changes_by_itself = true,
              .what = "value of the control",
              .source = "SV"}}};
}

/// Rules that were held against programs of the language, sorted.
constexpr std::string_view rules_tried[] = {
    "MAC001", "MAC002", "MAC003", "MAC004", "MAC106", "MAC109", "MAC117", "MAC118", "MAC119", "MAC121",
    "MAC126", "MAC129", "MAC203", "MAC213", "MAC301", "MAC303", "MAC318", "MAC319", "MAC320", "MAC321",
    "MAC337", "MAC340", "MAC402", "MAC411", "MAC412", "MAC413", "MAC456", "MAC457", "MAC462", "MAC472",
    "MAC501", "MAC502", "MAC505", "MAC506", "MAC507", "MAC510", "MAC511", "MAC514", "MAC517", "MAC522",
    "MAC535", "MAC553", "MAC558", "MAC559", "MAC570", "MAC601", "MAC702", "MAC703", "MAC704", "MAC728",
    "MAC729", "SIN104", "SIN105", "SIN106", "SIN107", "SIN109", "SIN110", "SIN111", "SIN112", "SIN113",
    "SIN114", "SIN115", "SIN116", "SIN117", "SIN120", "SIN123", "SIN124", "SIN201", "SIN202", "SIN203",
    "SIN204", "SIN207", "SIN208", "SIN209", "SIN210", "SIN211", "SIN213", "SIN302", "SIN303", "SIN304",
    "SIN305", "SIN402", "SIN403", "SIN404", "SIN405", "SIN407", "SIN408", "SIN411", "SIN412", "SIN501",
    "SIN502", "SIN504", "SIN505", "SIN506", "SIN601", "SIN602", "SIN603", "SIN701",
};
static_assert(std::ranges::is_sorted(rules_tried));

ControlModel make(std::string_view name, std::string_view description, std::optional<Machine> machine) {
    ControlModel control;
    control.name = name;
    control.language = "sinumerik";
    control.model = "sinumerik";
    control.description = description;
    control.machine = machine.value_or(Machine::mill);
    control.has_block_if = true;
    control.calculator_input = true;
    control.assumed = false;
    control.return_word = "M17";
    control.region_words = {
        {RegionKind::choice, "IF", "ENDIF"},           {RegionKind::while_loop, "WHILE", "ENDWHILE"},
        {RegionKind::endless_loop, "LOOP", "ENDLOOP"}, {RegionKind::counting_loop, "FOR", "ENDFOR"},
        {RegionKind::until_loop, "REPEAT", "UNTIL"},
    };
    control.jump_words = {{LabelSearch::forward, "GOTOF"}, {LabelSearch::backward, "GOTOB"}};
    control.rules_tried = rules_tried;
    // Axes, F, S, T, D stand once [T]; POS and POSA once for each axis, which their address does not say.
    control.repeatable = {"G", "H", "M", "POS", "POSA"};
    control.contradiction = Contradiction::forbidden;
    control.alarms = "SINUMERIK";
    control.exclusive_codes = {{"spindle", 'M', {3, 4, 5}, "MD: alarm 14760"}};
    // How deep loops may stand in each other no public page tells [language.md 11.1].
    control.limits = {.macro_calls = 0,
                      .subprogram_calls = 15,
                      .loop_levels = 0,
                      .first_loop_number = 0,
                      .last_loop_number = 0,
                      .bracket_levels = 0,
                      .source = "NCP23 p.490"};
    // clang-format off
    control.spaces = {
        {"R parameter",          "R", false, Scope::retained, InitialValue::old_value, "JP10 p.23"},
        {"local variable",       "",  true,  Scope::frame,    InitialValue::zero,      "NCP19 p.409, T808 p.126"},
        {"parameter",            "",  true,  Scope::frame,    InitialValue::zero,      "NCP19 p.494"},
        {"value of the control", "",  false, Scope::machine,  InitialValue::old_value, "SV"},
    };
    control.families = {r_parameters(), owned()};
    control.groups = modal_groups(machine);
    control.calls = {
        {"call of a subprogram", Frame::fresh, NestingLimit::subprogram, CallTrigger::once, 0, "NCP23 p.490"},
        {"call of a cycle",      Frame::fresh, NestingLimit::subprogram, CallTrigger::once, 0, "SCYC", LookupScope::everywhere, true},
        {"MCALL",                Frame::fresh, NestingLimit::subprogram, CallTrigger::after_each_motion, 1, "SEED-004:460-474"},
    };
    // clang-format on
    control.machine_words = &machine_words();
    control.vacant_equals_zero = true;
    control.loops_left_by_jump = true;
    return checked(std::move(control));
}

} // namespace

std::optional<GroupId> row_of_g_group(std::int64_t group) {
    if (group < 0 || group >= static_cast<int>(group_rows().size())) return std::nullopt;
    const std::uint8_t row = group_rows()[static_cast<std::size_t>(group)];
    return row == no_row ? std::nullopt : std::optional<GroupId>(row);
}

std::optional<SettingOfCode> setting_of(std::string_view capitals) {
    const GCodeRow* code = find_g_code(capitals);
    if (code == nullptr) return std::nullopt;
    SettingOfCode setting;
    if (const auto row = row_of_g_group(code->group))
        setting.sets = GroupCode{*row, static_cast<double>(code->member)};
    setting.takes_axes = code->group == frames || code->name == "G4";
    setting.moves = code->group == non_modal_moves && !setting.takes_axes;
    return setting;
}

GroupId modal_call_group() {
    static const auto group = static_cast<GroupId>(control().groups.size() - 1);
    return group;
}

std::optional<FrameCode> frame_code(std::string_view capitals) {
    for (const FramePart& part : frame_parts)
        if (capitals == part.replaces || capitals == part.adds)
            return FrameCode{*control().group_with(part.role), capitals == part.replaces};
    return std::nullopt;
}

std::optional<GroupCode> coupling_code(std::string_view procedure) {
    const auto first = static_cast<std::size_t>(modal_call_group()) - std::size(couplings);
    std::optional<GroupCode> found;
    for (std::size_t i = 0; i < std::size(couplings); ++i) {
        const auto group = static_cast<GroupId>(first + i);
        double code = 0;
        for_each_word(couplings[i].on, [&](std::string_view word) {
            ++code;
            if (word == procedure) found = GroupCode{group, code};
        });
        for_each_word(couplings[i].off, [&](std::string_view word) {
            if (word == procedure) found = GroupCode{group, 0};
        });
    }
    return found;
}

bool is_put_back_by_save(GroupId group) {
    const ModalGroup& row = control().groups[group];
    const auto frames_of = frame_groups();
    const bool is_g_group = row.source == source_of_g_groups;
    return (is_g_group && row.restore_policy != RestorePolicy::none) ||
           std::ranges::find(frames_of, group) != frames_of.end();
}

std::vector<GroupId> frame_groups() {
    std::vector<GroupId> groups;
    for (const FramePart& part : frame_parts) groups.push_back(*control().group_with(part.role));
    return groups;
}

std::span<const ControlModel> controls() {
    static const std::array models = {
        make("sinumerik", "SIEMENS SINUMERIK 840D sl, 828D, 808D, ONE", {}),
        make("sinumerik-mill", "SIEMENS SINUMERIK, mill: G17, G94, DIAMOF", Machine::mill),
        make("sinumerik-lathe", "SIEMENS SINUMERIK, lathe: G18, G95, DIAMON", Machine::lathe)};
    return models;
}

const ControlModel& control() { return controls().front(); }

} // namespace maclint::sinumerik
