//! Modal groups, and the variables that read them.
#include "analyzer/dialect/dinplus/tables.hpp"
#include "analyzer/dialect/dinplus/tables_parts.hpp"

#include <algorithm>

namespace maclint::dinplus {
namespace {

constexpr auto unknown = std::nullopt;

/// `#n40(G)`, `__n40_g`: what a variable of the current state reads, where it is a modal group.
struct StateVariable {
    std::int32_t number;
    std::string_view selector; ///< capitals
    ModalRole group;
    std::string_view source;
};

// #n920(G) reads 0, 1 or 2 and not a code [l.19318], so it is no row here.
constexpr StateVariable variables[] = {
    {18, "G", ModalRole::plane, "l.19245"},      {40, "G", ModalRole::cutter_compensation, "l.19246"},
    {95, "G", ModalRole::feed_mode, "l.19251"},  {95, "F", ModalRole::feed, "l.19253"},
    {97, "G", ModalRole::speed_mode, "l.19254"}, {97, "S", ModalRole::speed, "l.19256"},
};

} // namespace

// State flows through subprograms on purpose: the manual saves and restores nothing, and a feed, a speed or a
// zero shift set there is set for the caller [dinplus.md 8.2; l.20799 for G56]. Only what acts on every later
// move until it is switched off has rules of its own. G30 is set by the expert program that hands the part
// over [l.20066], and taken back by its caller.
std::vector<ModalGroup> modal_groups() {
    using Role = ModalRole;
    using Restore = RestorePolicy;
    // clang-format off
    //   name                            role                     letter restore         members                                     customary    cancel reset source                      cancel words
    std::vector<ModalGroup> groups = {
        {"motion mode",                  Role::motion,              'G', Restore::none,     {0, 1, 2, 3, 12, 13},                       {},          unknown,  unknown, "l.10297"},
        {"plane",                        Role::plane,               'G', Restore::none,     {17, 18, 19},                               {17, 18, 19},unknown,  18,   "l.23169", "", true},
        {"radius compensation",          Role::cutter_compensation, 'G', Restore::own_rule, {40, 41, 42},                               {40},        40,    40,   "l.12673-12718",            "G40"},
        {"tilted working plane",         Role::tilted_plane,        'G', Restore::own_rule, {16},                                       {0},         0,     0,    "l.23185-23218",            "G16 Q0"},
        {"conversion and mirroring",     Role::mirror_image,        'G', Restore::own_rule, {30},                                       {0},         0,     0,    "l.20056-20078, l.20957",   "G30 Q0", false, true},
        {"deactivation of zero shifts",  Role::offset_suspension,   'G', Restore::own_rule, {920, 921, 980, 981},                       {980, 981},  980,   980,  "l.12741, l.18155-18163, l.18391-18397", "G980 (G921: with G981)"},
        {"zero shift",                   Role::work_offset,         'G', Restore::none,     {51, 53, 54, 55, 56, 59},                   {51, 53, 54, 55, 56, 59}, unknown, unknown, "l.12750-12837"},
        {"kind of feed",                 Role::feed_mode,           'G', Restore::none,     {93, 193, 293, 393, 94, 95, 195, 295, 395}, {},          unknown,  unknown, "l.12532-12575"},
        {"kind of speed",                Role::speed_mode,          'G', Restore::none,     {96, 196, 296, 396, 97, 197, 297, 397},     {},          unknown,  unknown, "l.12596-12628"},
        {"feed",                         Role::feed,                'F', Restore::none,     {},                                         {},          unknown,  unknown, "l.12532-12575"},
        {"spindle speed",                Role::speed,               'S', Restore::none,     {},                                         {},          unknown,  unknown, "l.12596-12628"},
    };
    // clang-format on
    groups[*group_with(Role::motion, groups)].circles = {2, 3, 12, 13}; // l.12341, l.12421
    return groups;
}

std::optional<GroupId> group_read(std::int32_t number, std::string_view selector) {
    const auto* row = std::ranges::find_if(variables, [&](const StateVariable& variable) {
        return variable.number == number && variable.selector == selector;
    });
    if (row == std::end(variables)) return std::nullopt;
    return control().group_with(row->group);
}

} // namespace maclint::dinplus
