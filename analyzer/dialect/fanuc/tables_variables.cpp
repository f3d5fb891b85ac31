//! What the numbers after `#` stand for.
#include "analyzer/dialect/fanuc/tables.hpp"

#include <algorithm>
#include <iterator>

namespace maclint::fanuc {
namespace {

using enum Meaning;
using enum OnWrite;

/// How an index is meant of which too little is known.
constexpr IndexCustom index_custom{
    .least_base = 100,
    .reach = 999,
    .shared_points_to_shared = true,
    .spares_index = true,
    .source = "T: #[2000+#1] and #[#111+6] in half of all macros; no local variable is meant",
};

constexpr GroupId modal_groups = 22; ///< #4001-#4022

/// Of each hundred of modal values the groups take 30 numbers at most, and the letters as many.
constexpr std::string_view gap_of_modal =
    "T: SEED-001:1340-1367 ends with #4022 and #4130; the 30i has 30 groups, a Haas 26 letters";

/// #4001-#4022 and their twins in other hundreds: one row a group. Group 12 is G66 on some controls and
/// G54-G59 on others (Haas, and programs in the wild); where it is not the work offset, nothing is known of
/// its value.
void append_modal(std::vector<VariableRange>& ranges, std::int32_t first, std::string_view what,
                  std::optional<GroupId> group_twelve) {
    constexpr GroupId twelve = 11;
    for (GroupId group = 0; group < modal_groups; ++group) {
        const std::int32_t number = first + group;
        const bool known = group != twelve || group_twelve;
        const GroupId row = group == twelve ? group_twelve.value_or(0) : group;
        ranges.push_back({number, number, known ? modal : machine, spaces::machine, row, forbidden, false,
                          what, "SEED-001:1340-1357", false, !known});
    }
}

/// A row of outputs.
constexpr VariableRange output(VariableRange range) {
    range.is_output = true;
    return range;
}

/// A row whose numbers go by axes.
constexpr VariableRange by_axes(VariableRange range) {
    constexpr std::int32_t numbers_of_a_set = 20; // SEED-001:1373-1389
    range.numbers_of_a_set = numbers_of_a_set;
    return range;
}

/// A range of positions, by axes, where the last block has ended.
constexpr VariableRange of_block_end(VariableRange range) {
    range = by_axes(range);
    range.is_block_end = true;
    return range;
}

/// A range of positions, by axes, that count from the machine's own zero.
constexpr VariableRange of_machine(VariableRange range) {
    range = by_axes(range);
    range.counts_from_machine = true;
    return range;
}

/// A row of work offsets, the first of them that of the code.
constexpr VariableRange offsets_from(double code, VariableRange range) {
    range = by_axes(range);
    range.first_code = code;
    return range;
}

/// What a control has in the place of the rows for all.
// clang-format off
constexpr std::string_view listed_letters = "T: the list of SEED-001:1358-1367 is whole; #4108 is E of the 30i";
constexpr VariableRange of_named_fanuc[] = {
    //  first    last  meaning   space              group on write   by itself what                      source
    {    3103,   3900, absent,   spaces::machine,   0,    forbidden, false, "no variable",               "T: of #3xxx the lists have #3000 to #3102 and #3901 and up; tool data there are of a Haas"},
    {    4103,   4106, absent,   spaces::machine,   0,    forbidden, false, "no variable",               listed_letters},
    {    4110,   4110, absent,   spaces::machine,   0,    forbidden, false, "no variable",               listed_letters},
    {    4112,   4112, absent,   spaces::machine,   0,    forbidden, false, "no variable",               listed_letters},
    {    4116,   4118, absent,   spaces::machine,   0,    forbidden, false, "no variable",               listed_letters},
    {    4121,   4129, absent,   spaces::machine,   0,    forbidden, false, "no variable",               listed_letters},
    {    5141,   5180, absent,   spaces::machine,   0,    forbidden, false, "no variable",               "T: SEED-001:1373-1378 ends with #5104; the 30i has #5121 to #5140 and #5181 to #5200"},
};
constexpr VariableRange of_older_fanuc[] = {
    {    4023,   4030, absent,   spaces::machine,   0,    forbidden, false, "no variable",               "T: SEED-001:1340-1357 has 22 groups, the 30i has 30"},
};
/// Constants are of the newer FANUC series.
constexpr VariableRange of_others[] = {
    {    3100,   3102, machine,  spaces::machine,   0,    store,     true,  "machine value",             "unknown"},
};
constexpr VariableRange of_any_haas[] = {
    {     100,    199, variable, spaces::retained,  0,    store,     false, "retained common variable",  "ZAPP-HAAS: kept at power-off; #150 and up hold probe values, where there is one"},
};
/// ZAPP-HAAS prints a Haas table that has new numbers beside the old ones. That #10000 is the same variable as
/// #100 is read from their standing in one row; each is a variable of its own here.
constexpr VariableRange of_newer_haas[] = {
    {     700,    749, machine,  spaces::machine,   0,    store,     true,  "value of the control's own","ZAPP-HAAS: hidden, for internal use"},
    {    1064,   1068, machine,  spaces::machine,   0,    store,     true,  "greatest load of an axis",  "ZAPP-HAAS"},
    {    1080,   1098, machine,  spaces::machine,   0,    forbidden, true,  "analog input",              "ZAPP-HAAS"},
    {    1264,   1268, machine,  spaces::machine,   0,    store,     true,  "greatest load of an axis",  "ZAPP-HAAS"},
    {    1601,   2000, machine,  spaces::machine,   0,    store,     true,  "tool data",                 "ZAPP-HAAS"},
    {    3020,   3020, machine,  spaces::machine,   0,    forbidden, true,  "power-on timer",            "ZAPP-HAAS"},
    {   10000,  10149, variable, spaces::retained,  0,    store,     false, "retained common variable",  "ZAPP-HAAS: beside #100-#149, taken for the same by inference"},
    {   10150,  10199, machine,  spaces::machine,   0,    store,     true,  "probe value",               "ZAPP-HAAS: written by the machine, where there is a probe", false, false, true},
    {   10200,  10549, variable, spaces::retained,  0,    store,     false, "retained common variable",  "ZAPP-HAAS"},
    {   10550,  10599, machine,  spaces::machine,   0,    store,     true,  "probe calibration",         "ZAPP-HAAS: written by the machine, where there is a probe", false, false, true},
    {   10600,  10999, variable, spaces::retained,  0,    store,     false, "retained common variable",  "ZAPP-HAAS"},
    {   11000,  11063, machine,  spaces::machine,   0,    forbidden, true,  "input",                     "ZAPP-HAAS: 64 discrete inputs, for reading only", true},
    {   11064,  11255, machine,  spaces::machine,   0,    forbidden, true,  "input",                     "T", true},
    output({12000, 12255, machine, spaces::machine, 0,    store,     false, "output",                    "T", true}),
    {   14001,  19999, machine,  spaces::machine,   0,    store,     false, "additional work offset",    "T: G154"},
};
// clang-format on

std::vector<std::span<const VariableRange>> own_ranges(std::string_view model) {
    if (model == "fanuc") return {};
    if (model == "fanuc-16i" || model == "fanuc-0i-c") return {of_named_fanuc, of_older_fanuc, of_others};
    if (model.starts_with("fanuc")) return {of_named_fanuc};
    if (model == "haas") return {of_others, of_any_haas, of_newer_haas};
    if (model == "haas-1999") return {of_others, of_any_haas};
    return {of_others};
}

/// Puts the row in the place of what is there.
void put(std::vector<VariableRange>& ranges, const VariableRange& own) {
    std::vector<VariableRange> result;
    for (const VariableRange& range : ranges) {
        if (range.last < own.first || range.first > own.last) {
            result.push_back(range);
            continue;
        }
        VariableRange left = range, right = range;
        left.last = own.first - 1;
        right.first = own.last + 1;
        if (left.first <= left.last) result.push_back(left);
        if (range.first <= own.first) result.push_back(own);
        if (right.first <= right.last) result.push_back(right);
    }
    ranges = std::move(result);
}

} // namespace

std::vector<VariableSpace> variable_spaces() {
    // clang-format off
    return {
        {"local variable",           "#", false, Scope::frame,     InitialValue::vacant,    "SEED-001:161"},
        {"common variable",          "#", false, Scope::shared, InitialValue::vacant,    "SEED-001:162"},
        {"retained common variable", "#", false, Scope::retained,  InitialValue::old_value, "SEED-001:162"},
        {"system variable",          "#", false, Scope::machine,   InitialValue::old_value, "SEED-001:163"},
        {"named variable",           "",  true,  Scope::machine,   InitialValue::old_value, "2.3: names of the 30i"},
    };
    // clang-format on
}

VariableFamily numbered_variables(std::span<const ModalGroup> groups, std::optional<GroupId> group_twelve,
                                  std::string_view model) {
    constexpr SpaceId here = spaces::machine;
    // X, Y, Z of a mill, X, Z, Y of a lathe, with their incremental addresses.
    constexpr std::string_view axes = "XU YVZW ZWYV";
    const GroupId feed = *group_with(ModalRole::feed, groups);
    const GroupId speed = *group_with(ModalRole::speed, groups);
    const GroupId single_block = *group_with(ModalRole::single_block, groups);
    const GroupId feed_hold = *group_with(ModalRole::feed_hold, groups);
    std::vector<VariableRange> ranges;
    const auto add = [&](const VariableRange& range) { ranges.push_back(range); };
    // Ranges that exist only as an option, or on one series, are taken to exist. Numbers from #1000 upward of
    // which no source tells are machine values.
    // clang-format off
    //   first    last   meaning  space             group         on write   by itself what                                    source
    add({    0,      0,  null,    here,             0,            forbidden, false, "null variable",                           "SEED-001:160,198"});
    add({    1,     33,  variable,   spaces::local,    0,            store,     false, "local variable",                          "SEED-001:161"});
    add({   34,     99,  absent,  here,             0,            forbidden, false, "no variable",                             "SEED-001:161-162"});
    add({  100,    199,  variable,   spaces::common,   0,            store,     false, "common variable",                         "SEED-001:162"});
    add({  200,    499,  variable,   spaces::common,   0,            store,     false, "common variable (option)",                "T"});
    add({  500,    999,  variable,   spaces::retained, 0,            store,     false, "retained common variable",                "SEED-001:162"});
    add({ 1000,   1015,  machine, here,             0,            forbidden, true,  "input from the PMC",                      "IMD-IO", true});
    add({ 1016,   1031,  machine, here,             0,            forbidden, true,  "input from the PMC",                      "T", true});
    add({ 1032,   1099,  machine, here,             0,            forbidden, true,  "input word from the PMC",                 "T"});
    add(output({1100, 1131, machine, here,          0,            store,     false, "output to the PMC",                       "T; HAAS-LA", true}));
    add(output({1132, 1135, machine, here,          0,            store,     false, "output word to the PMC",                  "T"}));
    add({ 1136,   1199,  machine, here,             0,            store,     true,  "machine value",                           "unknown", false, false, true});
    add({ 1200,   1999,  machine, here,             0,            store,     true,  "machine value",                           "unknown", false, false, true});
    add({ 2000,   2999,  machine, here,             0,            store,     false, "tool or work offset",                     "SEED-001:1312-1333; T"});
    add({ 3000,   3000,  machine, here,             0,            alarm,     false, "macro alarm",                             "CNCCI: 100 to 255; ZAPP-ALM: 1 to 9999", false, false, false, 9999});
    add({ 3001,   3002,  machine, here,             0,            store,     true,  "timer",                                   "ZAPP-ALM; TENC-SYS"});
    add({ 3003,   3003,  modal,   here,             single_block, set_modal, false, "single-block suppression",                "SEED-001:214-220"});
    add({ 3004,   3004,  modal,   here,             feed_hold,    set_modal, false, "feed-hold suppression",                   "SEED-001:226-234"});
    add({ 3005,   3005,  machine, here,             0,            store,     false, "settings",                                "T"});
    add({ 3006,   3006,  machine, here,             0,            pause,     false, "stop with a message",                     "ZAPP-ALM; SEED-002:331"});
    add({ 3007,   3007,  machine, here,             0,            forbidden, false, "mirror image state",                      "T"});
    add({ 3008,   3010,  machine, here,             0,            forbidden, true,  "program restart",                         "T"});
    add({ 3011,   3012,  machine, here,             0,            forbidden, true,  "date and time",                           "TENC-SYS"});
    add({ 3013,   3099,  machine, here,             0,            store,     true,  "machine value",                           "unknown; Haas: tool and spindle data"});
    add({ 3100,   3102,  machine, here,             0,            forbidden, false, "constant: nothing, pi, e",                "T: grinders divide by #3101"});
    add({ 3103,   3900,  machine, here,             0,            store,     true,  "machine value",                           "unknown; Haas: tool and spindle data"});
    add({ 3901,   3902,  machine, here,             0,            store,     true,  "parts counter",                           "TENC-SYS"});
    add({ 3903,   3999,  machine, here,             0,            store,     true,  "machine value",                           "unknown", false, false, true});
    add({ 4000,   4000,  machine, here,             0,            forbidden, false, "main program number",                     "TENC-SYS"});
    append_modal(ranges, 4001, "modal G code up to the previous block", group_twelve);
    add({ 4023,   4030,  machine, here,             0,            forbidden, false, "modal value",                             "T: groups of the 30i"});
    add({ 4031,   4100,  absent,  here,             0,            forbidden, false, "no variable",                             gap_of_modal});
    add({ 4101,   4106,  machine, here,             0,            forbidden, false, "modal value",                             "SEED-001:1358; T"});
    add({ 4107,   4107,  machine, here,             0,            forbidden, false, "offset number D",                         "SEED-001:1359; T: three digits", false, false, false, 999});
    add({ 4108,   4108,  machine, here,             0,            forbidden, false, "modal value",                             "T"});
    add({ 4109,   4109,  modal,   here,             feed,         forbidden, false, "feed F",                                  "SEED-001:1360"});
    add({ 4110,   4110,  machine, here,             0,            forbidden, false, "modal value",                             "T"});
    add({ 4111,   4111,  machine, here,             0,            forbidden, false, "offset number H",                         "SEED-001:1361; T: three digits", false, false, false, 999});
    add({ 4112,   4112,  machine, here,             0,            forbidden, false, "modal value",                             "T"});
    add({ 4113,   4113,  machine, here,             0,            forbidden, false, "M code",                                  "SEED-001:1362; T: eight digits at most", false, false, false, 99999999});
    add({ 4114,   4115,  machine, here,             0,            forbidden, false, "sequence number, program number",         "SEED-001:1363-1364; T: eight digits at most", false, false, false, 99999999});
    add({ 4116,   4118,  machine, here,             0,            forbidden, false, "modal value",                             "T"});
    add({ 4119,   4119,  modal,   here,             speed,        forbidden, false, "spindle speed S",                         "SEED-001:1365"});
    add({ 4120,   4120,  machine, here,             0,            forbidden, false, "tool number T",                           "SEED-001:1366; T: eight digits at most", false, false, false, 99999999});
    add({ 4121,   4130,  machine, here,             0,            forbidden, false, "modal value",                             "SEED-001:1367"});
    add({ 4131,   4200,  absent,  here,             0,            forbidden, false, "no variable",                             gap_of_modal});
    append_modal(ranges, 4201, "modal G code of the block being executed", group_twelve);
    add({ 4223,   4230,  machine, here,             0,            forbidden, false, "modal value",                             "T; MITSU-331"});
    add({ 4231,   4300,  absent,  here,             0,            forbidden, false, "no variable",                             gap_of_modal});
    add({ 4301,   4308,  machine, here,             0,            forbidden, false, "modal value",                             "T; MITSU-331"});
    add({ 4309,   4309,  modal,   here,             feed,         forbidden, false, "feed F of the block being executed",      "T; MITSU-331"});
    add({ 4310,   4318,  machine, here,             0,            forbidden, false, "modal value",                             "T; MITSU-331"});
    add({ 4319,   4319,  modal,   here,             speed,        forbidden, false, "speed S of the block being executed",     "T; MITSU-331"});
    add({ 4320,   4330,  machine, here,             0,            forbidden, false, "modal value",                             "T; MITSU-331"});
    add({ 4331,   4400,  absent,  here,             0,            forbidden, false, "no variable",                             gap_of_modal});
    append_modal(ranges, 4401, "modal G code of the interrupted program", group_twelve);
    add({ 4423,   4430,  machine, here,             0,            forbidden, false, "modal G code of the interrupted program", "MITSU-389; T", false, true});
    add({ 4431,   4500,  absent,  here,             0,            forbidden, false, "no variable",                             gap_of_modal});
    add({ 4501,   4508,  machine, here,             0,            forbidden, false, "modal value",                             "MITSU-389; T"});
    add({ 4509,   4509,  modal,   here,             feed,         forbidden, false, "feed F of the interrupted program",       "MITSU-389; T"});
    add({ 4510,   4518,  machine, here,             0,            forbidden, false, "modal value",                             "MITSU-389; T"});
    add({ 4519,   4519,  modal,   here,             speed,        forbidden, false, "speed S of the interrupted program",      "MITSU-389; T"});
    add({ 4520,   4530,  machine, here,             0,            forbidden, false, "modal value",                             "T"});
    add({ 4531,   4999,  absent,  here,             0,            forbidden, false, "no variable",                             "T: the lists of SEED-001:1337-1367 and MITSU-389 end before it"});
    add({ 5000,   5000,  machine, here,             0,            forbidden, true,  "block end position",                      "SEED-001:1373"});
    add(of_block_end({5001, 5020, machine, here,    0,            forbidden, true,  "block end position",                      "SEED-001:1373"}));
    add(of_machine({5021, 5040, machine, here,      0,            forbidden, true,  "machine position",                        "SEED-001:1374; MAN-AINANO", false, false, false, {}, axes}));
    add(by_axes({5041, 5060, machine, here,         0,            forbidden, true,  "work position",                           "SEED-001:1375; MAN-AINANO", false, false, false, {}, axes}));
    add(by_axes({5061, 5080, machine, here,         0,            forbidden, true,  "skip position",                           "SEED-001:1376; NCT-183", false, false, false, {}, {}, true}));
    add(by_axes({5081, 5100, machine, here,         0,            forbidden, true,  "tool length offset in effect",            "SEED-001:1377; NCT-183"}));
    add(by_axes({5101, 5120, machine, here,         0,            forbidden, true,  "servo deviation",                         "SEED-001:1378"}));
    add({ 5121,   5140,  machine, here,             0,            forbidden, true,  "handle interruption",                     "T: grinders read it"});
    add({ 5141,   5200,  machine, here,             0,            forbidden, true,  "machine value",                           "T"});
    add(by_axes({5201, 5220, machine, here,         0,            store,     false, "external work offset",                    "SEED-001:1383"}));
    add(offsets_from(54, {5221, 5340, machine, here, 0,           store,     false, "work offset",                             "SEED-001:1384-1389"}));
    add({ 5341,   5400,  machine, here,             0,            store,     false, "work offset",                             "SEED-001:1384-1389"});
    add({ 5401,   6999,  machine, here,             0,            store,     true,  "machine value",                           "unknown", false, false, true});
    add({ 7000,   7999,  machine, here,             0,            store,     false, "additional work offset",                  "TENC-SYS"});
    add({ 8000,   9999,  machine, here,             0,            store,     true,  "machine value",                           "unknown", false, false, true});
    add({10000,  19999,  machine, here,             0,            store,     false, "tool offset or additional work offset",   "SEED-001:1312-1335; T"});
    add({20000,  97999,  machine, here,             0,            store,     true,  "machine value",                           "unknown", false, false, true});
    add({98000,  98499,  variable,   spaces::common,   0,            store,     false, "common variable",                         "T"});
    add({98500, 899999,  machine, here,             0,            store,     true,  "machine value",                           "T: six-digit numbers of the 30i", false, false, true});
    add({900000, 999999, machine, here,             0,            store,     true,  "common variable of the machine builder",  "T: vacant until something sets them", false, false, true});
    // clang-format on
    for (const auto own : own_ranges(model))
        for (const VariableRange& range : own) put(ranges, range);
    return {"#", std::move(ranges), index_custom};
}

} // namespace maclint::fanuc
