//! Codes that contradict each other in one block: the manual's example is N10 M3 M4 [l.10226, l.10231].
#include "analyzer/dialect/dinplus/tables_parts.hpp"

namespace maclint::dinplus {

// Zero shifts add up and machine functions that the builder defines are not known, so they are no rows here.
std::vector<ExclusiveCodes> exclusive_codes() {
    // clang-format off
    return {
        {"motion",              'G', {0, 1, 2, 3, 12, 13},                       "l.10231, l.10297"},
        {"exact stop",          'G', {7, 8},                                     "l.18047-18053"},
        {"plane",               'G', {17, 18, 19},                               "l.23169-23181"},
        {"radius compensation", 'G', {40, 41, 42},                               "l.12673-12718"},
        {"kind of feed",        'G', {93, 193, 293, 393, 94, 95, 195, 295, 395}, "l.12532-12575, l.19251"},
        {"kind of speed",       'G', {96, 97},                                   "l.12596-12628"},
        {"speed of spindle 1",  'G', {196, 197},                                 "l.12596-12633"},
        {"speed of spindle 2",  'G', {296, 297},                                 "l.12596-12633"},
        {"speed of spindle 3",  'G', {396, 397},                                 "l.12596-12633"},
        {"zero shifts",         'G', {920, 980},                                 "l.18155, l.18391"},
        {"shifts and lengths",  'G', {921, 981},                                 "l.18161, l.18395"},
        {"coolant",             'M', {8, 9},                                     "l.1863, l.1880"},
        {"spindle",             'M', {3, 4, 5},                                  "l.10231, l.20039-20041"},
        {"spindle 1",           'M', {103, 104, 105},                            "l.20052-20054"},
        {"spindle 2",           'M', {203, 204, 205},                            "l.20052-20054"},
        {"spindle 3",           'M', {303, 304, 305},                            "l.20052-20054"},
        {"spindle brake",       'M', {12, 13},                                   "l.20042-20043"},
        {"C axis",              'M', {14, 15},                                   "l.20044-20045"},
        {"gear",                'M', {40, 41, 42, 43, 44},                       "l.20047-20051"},
        {"end of the program",  'M', {30, 99},                                   "l.20016, l.20021"},
        {"protection zone",     'M', {417, 418},                                 "l.20019-20020"},
    };
    // clang-format on
}

} // namespace maclint::dinplus
