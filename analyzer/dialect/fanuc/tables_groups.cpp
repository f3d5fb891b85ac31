//! Modal groups of mills and of lathes. Row n - 1 is the group that #40n reads.
#include "analyzer/dialect/fanuc/tables.hpp"

#include <algorithm>

namespace maclint::fanuc {
namespace {

using Role = ModalRole;
using Restore = RestorePolicy;

constexpr std::string_view group_table = "modal group table of the custom macro reference, section 7";
constexpr auto none = std::nullopt;

ModalGroup unassigned(std::string_view name) {
    return {name, Role::other, 'G', Restore::none, {}, {}, none, none, "not assigned on this machine type"};
}

// Rows after the numbered groups: words that are modal, and variables that act like a modal group.
void append_values(std::vector<ModalGroup>& groups) {
    // clang-format off
    groups.push_back({"feed",                      Role::feed,                'F', Restore::value,       {},   {},  none, none, "SEED-001:1360"});
    groups.push_back({"spindle speed",             Role::speed,               'S', Restore::value,       {},   {},  none, none, "SEED-001:1365"});
    groups.push_back({"single-block suppression",  Role::single_block,        '#', Restore::suppression, {},   {0}, none, none, "SEED-001:214-220, #3003", {}, false, false,
                      {"single block", "the wait for M, S and T codes"}});
    groups.push_back({"feed-hold suppression",     Role::feed_hold,           '#', Restore::suppression, {},   {0}, none, none, "SEED-001:226-234, #3004", {}, false, false,
                      {"feed hold", "feed override", "exact stop"}});
    groups.push_back({"local offset",              Role::local_offset,        'G', Restore::operation,   {52}, {0}, 0,    0,    "T: G52 shifts until G52 X0 Y0 Z0", "G52 X0 Y0 Z0"});
    groups.push_back({"spindle",                   Role::spindle,             'M', Restore::none,        {3, 4, 5, 13, 14, 19}, {}, 5, none, "T: M13 and M14 are M03 and M04 with coolant, M19 orients"});
    // clang-format on
}

// What codes of a group say of it and of others.
void relate(std::vector<ModalGroup>& groups) {
    groups[*group_with(ModalRole::motion, groups)].circles = {2, 3};
}

} // namespace

std::vector<ModalGroup> mill_groups() {
    // clang-format off
    //   name                       role                     letter restore         members                              customary     cancel reset source
    std::vector<ModalGroup> groups = {
        {"motion mode",               Role::motion,              'G', Restore::motion,     {0, 1, 2, 3, 33, 2.2, 3.2, 2.3, 3.3, 2.4, 3.4, 6.2, 34}, {}, none, none, group_table},
        {"plane",                     Role::plane,               'G', Restore::state,      {17, 18, 19},                        {17},         none, none, group_table},
        {"distance mode",             Role::distance,            'G', Restore::state,      {90, 91},                            {90},         none, none, group_table},
        {"stored stroke check",       Role::other,               'G', Restore::none,       {22, 23},                            {22, 23},     none, none, group_table},
        {"feed mode",                 Role::feed_mode,           'G', Restore::state,      {93, 94, 95},                        {94},         none, none, group_table},
        {"units",                     Role::units,               'G', Restore::state,      {20, 21},                            {20, 21},     none, none, group_table},
        {"cutter compensation",       Role::cutter_compensation, 'G', Restore::operation,  {40, 41, 42},                        {40},         40,   40,   group_table},
        {"tool length compensation",  Role::length_compensation, 'G', Restore::offset,     {43, 44, 49, 43.1, 43.4, 43.5},      {43, 44, 49, 43.1, 43.4, 43.5}, 49, none, group_table},
        {"canned cycle",              Role::cycle,               'G', Restore::cycle,      {73, 74, 76, 80, 81, 82, 83, 84, 84.2, 84.3, 85, 86, 87, 88, 89}, {80}, 80, 80, group_table},
        {"canned cycle return level", Role::return_level,        'G', Restore::state,      {98, 99},                            {98, 99},     none, none, group_table},
        {"scaling",                   Role::scaling,             'G', Restore::operation,  {50, 51},                            {50},         50,   50,   group_table},
        {"modal macro call",          Role::macro_call,          'G', Restore::modal_call, {66, 66.1, 67},                      {67},         67,   67,   group_table},
        {"constant surface speed",    Role::speed_mode,          'G', Restore::state,      {96, 97},                            {97},         none, none, group_table},
        {"work offset",               Role::work_offset,         'G', Restore::offset,     {54, 54.1, 55, 56, 57, 58, 59, 154}, {54, 54.1, 55, 56, 57, 58, 59, 154}, none, none, group_table},
        {"cutting mode",              Role::cutting_mode,        'G', Restore::state,      {61, 61.1, 62, 63, 64},              {64},         none, none, group_table},
        {"rotation",                  Role::rotation,            'G', Restore::operation,  {68, 68.2, 68.3, 69},                {69},         69,   69,   group_table},
        {"polar coordinates",         Role::polar_coordinates,   'G', Restore::operation,  {15, 16},                            {15},         15,   15,   group_table},
        {"normal direction control",  Role::normal_direction,    'G', Restore::operation,  {40.1, 41.1, 42.1, 150, 151, 152},   {40.1, 150},  40.1, none, group_table},
        unassigned("group 19"),
        {"in-feed control",           Role::other,               'G', Restore::none,       {160, 161},                          {160, 161},   none, none, group_table},
        {"polar interpolation",       Role::polar_interpolation, 'G', Restore::operation,  {12.1, 13.1, 112, 113},              {13.1, 113},  13.1, none, group_table},
        {"mirror image",              Role::mirror_image,        'G', Restore::operation,  {50.1, 51.1},                        {50.1},       50.1, 50.1, group_table},
    };
    // clang-format on
    append_values(groups);
    relate(groups);
    return groups;
}

namespace {

/// What the rows of system A are in B and C, where G90 and G91 choose between absolute and incremental.
void change_to_system(char system, std::vector<ModalGroup>& groups) {
    constexpr std::string_view second_hand = "GEDIT, BLOG-FIX second hand; T";
    constexpr std::size_t distance = 2, return_level = 10; // groups 03 and 11
    // clang-format off
    groups[distance]     = {"distance mode",             Role::distance,     'G', Restore::state, {90, 91}, {90},     none, none, second_hand};
    groups[return_level] = {"canned cycle return level", Role::return_level, 'G', Restore::state, {98, 99}, {98, 99}, none, none, second_hand};
    // clang-format on
    for (ModalGroup& group : groups) {
        if (group.role == Role::motion)
            group.members = system == 'B' ? std::vector<ModalMember>{0, 1, 2, 3, 33, 34, 77, 78, 79}
                                          : std::vector<ModalMember>{0, 1, 2, 3, 33, 34, 20, 21, 24};
        if (group.role == Role::feed_mode) {
            group.members = {94, 95};
            group.customary = {94, 95};
        }
        if (group.role == Role::units && system == 'C') {
            group.members = {70, 71};
            group.customary = {70, 71};
        }
    }
}

} // namespace

std::vector<ModalGroup> lathe_groups(char system) {
    // clang-format off
    //   name                       role                     letter restore         members                              customary     cancel reset source
    std::vector<ModalGroup> groups = {
        {"motion mode",               Role::motion,              'G', Restore::motion,     {0, 1, 2, 3, 32, 34, 90, 92, 94},    {},           none, none, group_table},
        {"constant surface speed",    Role::speed_mode,          'G', Restore::state,      {96, 97},                            {96, 97},     none, none, group_table},
        unassigned("group 03"),
        {"balance cut",               Role::other,               'G', Restore::none,       {68, 69},                            {68, 69},     69,   none, group_table},
        {"feed mode",                 Role::feed_mode,           'G', Restore::state,      {98, 99},                            {98, 99},     none, none, group_table},
        {"units",                     Role::units,               'G', Restore::state,      {20, 21},                            {20, 21},     none, none, group_table},
        {"nose radius compensation",  Role::cutter_compensation, 'G', Restore::operation,  {40, 41, 42},                        {40},         40,   40,   group_table},
        {"speed fluctuation check",   Role::other,               'G', Restore::none,       {25, 26},                            {25, 26},     none, none, group_table},
        {"stored stroke check",       Role::other,               'G', Restore::none,       {22, 23},                            {22, 23},     none, none, group_table},
        {"canned cycle",              Role::cycle,               'G', Restore::cycle,      {80, 83, 84, 85, 87, 88, 89},        {80},         80,   80,   group_table},
        unassigned("group 11"),
        {"modal macro call",          Role::macro_call,          'G', Restore::modal_call, {66, 66.1, 67},                      {67},         67,   67,   group_table},
        unassigned("group 13"),
        {"work offset",               Role::work_offset,         'G', Restore::offset,     {54, 54.1, 55, 56, 57, 58, 59},      {54, 54.1, 55, 56, 57, 58, 59}, none, none, group_table},
        {"cutting mode",              Role::cutting_mode,        'G', Restore::state,      {61, 62, 63, 64},                    {64},         none, none, "T"},
        {"plane",                     Role::plane,               'G', Restore::state,      {17, 18, 19},                        {18},         none, none, group_table},
        unassigned("group 17"),
        unassigned("group 18"),
        unassigned("group 19"),
        {"polygon turning",           Role::other,               'G', Restore::operation,  {50.2, 51.2, 250, 251},              {50.2, 250},  50.2, none, group_table},
        {"polar interpolation",       Role::polar_interpolation, 'G', Restore::operation,  {12.1, 13.1, 112, 113},              {13.1, 113},  13.1, none, group_table},
        unassigned("group 22"),
    };
    // clang-format on
    if (system != 'A') change_to_system(system, groups);
    append_values(groups);
    relate(groups);
    return groups;
}

std::vector<Idle> idle_values(std::span<const ModalGroup> groups) {
    const auto row = [&](ModalRole role) { return *group_with(role, groups); };
    const GroupId feed = row(ModalRole::feed), speed = row(ModalRole::speed);
    const GroupId motion = row(ModalRole::motion), spindle = row(ModalRole::spindle);
    // T: G00 moves at rapid traverse; a tool that does not cut asks for no speed; `M03 S500` starts a
    // spindle; S beside M19 is the angle on some machines.
    return {{feed, {motion, 0}},
            {speed, {motion, 0}},
            {speed, {spindle, 5}, true},
            {speed, {spindle, 19}, true, true}};
}

} // namespace maclint::fanuc
