//! What programs switch on and off, beside the modal groups.
#include "analyzer/dialect/dinplus/tables_parts.hpp"

namespace maclint::dinplus {
namespace {

using enum Switch::Where;

// Functions of the machine that its builder defines may do anything with a spindle; those of the manual are
// known.
constexpr std::string_view unknown_functions =
    "M!0|1|3|4|5|7|8|9|12|13|14|15|18|19|30|40|41|42|43|44|91|97|"
    "99|103|104|105|114|115|203|204|205|214|215|303|304|305|314|315|417|418";

// clang-format off
constexpr Switch switches[] = {
    {"C axis",                    "M14, M114, M214, M314", "M15, M115, M215, M315",
     unknown_functions, machine, "l.20044-20045"},
    {"main spindle",              "M3, M4", "M5, M19", unknown_functions, machine, "l.20039-20041"},
    {"spindle 1",                 "M103, M104", "M105", unknown_functions, machine, "l.20052-20054"},
    {"spindle 2",                 "M203, M204", "M205", unknown_functions, machine, "l.20052-20054"},
    {"spindle 3",                 "M303, M304", "M305", unknown_functions, machine, "l.20052-20054"},
    // A time, a limit of rapid moves and a factor are no feeds, a limit is no speed: l.12511, l.18044, l.18608, l.20225.
    {"feed",                      "F -G, F G!4|48|64|720|725|726|727", "", "", channel,
     "l.10346, l.12532-12584"},
    {"speed",                     "S -G, S G!26|126|226|326", "", "", channel, "l.10346, l.12596-12637"},
    {"tool",                      "T", "", "", channel, "l.10343-10345"},
    {"speed limit",               "G26 S, G126 S, G226 S, G326 S", "", "", channel, "l.10369, l.12461"},
    {"feed of 1000 or more",      "G94 F>999.999", "G94 F<1000, G95, G195, G295, G395, G93, G193, G293, G393",
     "F -G, F G=0|1|2|3|12|13", channel, "l.12558, l.20306"},
    {"tilted plane",              "G16 Q=1|2", "G16 Q=0", "G16 -Q", channel, "l.23185-23206"},
    {"coupling of spindles",      "G720 H!0", "G720 H?0", "", machine, "l.20208-20225"},
    {"eccentric turning",         "G725 H=1", "G725 H=0", "", machine, "l.18582-18632"},
    {"eccentric turning along Z", "G726 H=1", "G726 H=0", "", machine, "l.18638-18700"},
    {"non-circular turning",      "G727 H=1", "G727 H=0", "", machine, "l.18707-18760"},
    {"swinging speed",            "G924 H=1", "G924 H?0", "", machine, "l.18165-18174"},
    {"radius compensation in the turning plane", "G41 Q?0, G42 Q?0", "G40, G41 Q=1|2|3|4, G42 Q=1|2|3|4", "", channel, "l.12692-12706"},
    {"HDT mode",                  "G931 H=1|2", "G931 H=0", "", channel, "l.18538-18570"},
    {"measuring",                 "G910", "G913", "", channel, "l.22275, l.22340"},
    {"monitoring of the measuring move", "G911", "G914, G913", "", channel, "l.22307, l.22344"},
    {"measured angle",            "G787", "", "", machine, "l.22193, l.22250"},
    {"monitoring zone",           "G995 H", "G995 -H -ID", "", channel, "l.18399-18430"},
    {"tool centre point management", "G928 H=1", "G928 H=0", "", channel, "l.18193-18210"},
    {"additive compensation",     "G149 D!900", "G149 D=900, T", "", channel, "l.13001-13016"},
    {"lock of the feed override", "G908 H=1", "G908 H=2", "", channel, "l.18122-18140"},
    {"lock of the spindle override", "G919 H=1", "G919 H?0", "", machine, "l.18143-18152"},
    {"suspension of the protection zone", "G60 Q?1", "G60 Q=0", "", channel, "l.18059-18067"},
    {"interrupted feed",          "G64 E, G64 F", "G64 -E -F", "", channel, "l.12504-12530"},
    {"suspension of zero points", "G920", "G980, G981, G921", "", channel, "l.18155, l.18391"},
    {"suspension of zero points and tool lengths", "G921", "G980, G981, G920", "", channel, "l.18161, l.18395"},
    {"reference diameter",        "G120", "", "", machine, "l.16286-16292"},
    {"contour of G83",            "G83", "G80", "", channel, "l.20500-20512"},
    {"trial move of G238",        "G238 H=1", "", "", channel, "l.18832"},
    {"tool change point 1",       "G140 D=1", "", "G140 -D", channel, "l.12315-12336"},
    {"tool change point 2",       "G140 D=2", "", "G140 -D", channel, "l.12315-12336"},
    {"plane set by G16",          "G16 Q=1", "", "", channel, "l.23203"},
    {"spindle at an angle",       "M19", "M3, M4", "", machine, "l.16777"},
    {"compensation of helical gearing", "G728 H=1", "G728 H=0", "", machine, "l.18767-18788"},
    {"oversize of a contour",     "G52 P!0", "G52 -P, G52 P=0", "", section, "l.11329-11333"},
    {"finishing feed of a contour", "G95 F", "G95 -F, G10", "", section, "l.11347-11352"},
    {"feed factor of a contour",  "G38 E", "G38 -E", "", section, "l.11260-11268"},
    {"surface finish of a contour", "G10 RH", "G10 -RH, G95", "", section, "l.11242-11252"},
};
// clang-format on

} // namespace

std::span<const Switch> switch_rows() { return switches; }

} // namespace maclint::dinplus
