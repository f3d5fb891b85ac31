//! What a FANUC has only where somebody has bought it, and the codes that come with it.
#include "analyzer/dialect/fanuc/tables.hpp"

#include <array>
#include <string_view>

namespace maclint::fanuc {
namespace {

// That a function is an option differs from series to series and year to year, and is from memory where no
// document says it: these rows only count where a configuration lists the options of its machine.
// clang-format off
constexpr std::array rows = std::to_array<ControlOption>({
    // name                              codes                              what                                                 machines source
    {"additional-work-offsets",          "G54.1",                           "work offsets beside G54 to G59",                          'B', "T"},
    {"automatic-tool-compensation",      "G36 G37",                         "measuring of a tool by a move to a sensor",               'T', "T"},
    {"balance-cut",                      "G68 G69",                         "two turrets that cut together",                           'T', "T"},
    {"canned-cycles-for-drilling",       "G80 G83 G84 G85 G87 G88 G89",     "drilling and tapping cycles",                             'T', "T"},
    {"chopping",                         "G81.1",                           "strokes of a grinding wheel",                             'M', "T"},
    {"circular-thread-cutting",          "G35 G36",                         "threads along an arc",                                    'M', "F30D-155"},
    {"coordinate-system-rotation",       "G68 G69",                         "figures turned about a point",                            'M', "T"},
    {"custom-macro",                     "G65 G66 G66.1 G67",               "macro calls, variables and jumps",                        'B', "T"},
    {"cylindrical-interpolation",        "G7.1 G107",                       "contours on the surface of a cylinder",                   'B', "T"},
    {"exponential-interpolation",        "G2.3 G3.3",                       "exponential curves",                                      'M', "F15-104"},
    {"high-speed-cycle-machining",       "G5",                              "moves from data that are made beforehand",                'B', "CSCH-B"},
    {"involute-interpolation",           "G2.2 G3.2",                       "involutes",                                               'M', "GH-ALM"},
    {"look-ahead-contour-control",       "G5.1 G8",                         "speed by what comes next",                                'B', "CSCH-B"},
    {"normal-direction-control",         "G40.1 G41.1 G42.1 G150 G151 G152", "a tool that turns with the contour",                     'M', "T"},
    {"nurbs-interpolation",              "G6.2",                            "NURBS curves",                                            'M', "T"},
    {"polar-coordinate-command",         "G15 G16",                         "points by radius and angle",                              'M', "T"},
    {"polar-coordinate-interpolation",   "G12.1 G13.1 G112 G113",           "contours by a linear and a rotary axis",                  'B', "T"},
    {"polygon-turning",                  "G50.2 G51.2 G250 G251",           "flats by a tool that turns with the work",                'T', "T"},
    {"programmable-mirror-image",        "G50.1 G51.1",                     "figures mirrored by a code",                              'M', "T"},
    {"rigid-tapping",                    "M29",                             "tapping with a spindle that follows the feed",            'B', "T"},
    {"scaling",                          "G50 G51",                         "figures larger or smaller than they are written",         'M', "T"},
    {"single-direction-positioning",     "G60",                             "positions that are reached from one side",                'M', "T"},
    {"skip-function",                    "G31",                             "a move that a signal ends",                               'B', "T"},
    {"stored-stroke-check-2",            "G22 G23",                         "zones that the program forbids",                          'B', "T"},
    {"thread-cutting",                   "G33",                             "threads by a single point",                               'M', "T"},
    {"three-dimensional-circle",         "G2.4 G3.4",                       "arcs through three points in space",                      'M', "F15-779"},
    {"tilted-working-plane",             "G53.1 G68.2 G68.3",               "a plane at an angle to the machine",                      'M', "T"},
    {"tool-center-point-control",        "G43.4 G43.5",                     "rotary axes that keep the tip of the tool in its place",  'M', "T"},
    {"tool-length-measurement",          "G37",                             "measuring of a tool by a move to a sensor",               'M', "T"},
});
// clang-format on

} // namespace

std::span<const ControlOption> options_of(std::string_view model) {
    return model.starts_with("fanuc") ? std::span<const ControlOption>(rows)
                                      : std::span<const ControlOption>();
}

} // namespace maclint::fanuc
