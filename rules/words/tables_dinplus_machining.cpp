//! Rows for DIN PLUS: what machines, in MACHINING and in subprograms.
#include "rules/words/word_row.hpp"

namespace maclint::word_tables {
namespace {

using enum RowStatement;
using enum Severity;

// clang-format off
constexpr WordRow rows[] = {
    // Waiting
    {.says = needs,     .code = "G4", .words = "F D", .means = "seconds or revolutions",
     .effect = "the control does not wait", .severity = warning, .source = "SEED-003:18040"},
    {.says = excludes,  .code = "G4", .words = "F", .others = "D", .means = "time",
     .effect = "the wait is a time or a number of revolutions", .severity = warning, .source = "SEED-003:18040"},
    {.says = values,    .code = "G4", .words = "F", .least = 0, .most = 999, .above_least = true, .means = "seconds",
     .effect = "the control refuses the time", .severity = error, .aliases = "DIN616", .source = "SEED-003:18044"},

    // Tool change position
    {.says = values,    .code = "G14", .words = "Q", .values = "0 1 2 3 4 5 6", .means = "order of the axes",
     .effect = "the manual knows no such order", .severity = warning, .source = "SEED-003:12294"},
    {.says = values,    .code = "G14", .words = "D", .values = "0 1 2", .means = "number of the position",
     .effect = "there is no such position", .severity = warning, .source = "SEED-003:12301"},
    {.says = needs,     .code = "G140", .words = "D", .means = "number of the position",
     .effect = "no position is defined", .severity = warning, .source = "SEED-003:12319"},
    {.says = values,    .code = "G140", .words = "D", .values = "1 2", .means = "number of the position",
     .effect = "there is no such position", .severity = warning, .aliases = "DIN658", .source = "SEED-003:12319"},

    // Speed, rapid traverse, feed
    {.says = needs,     .code = "G26 G126 G226 G326", .words = "S", .means = "highest speed",
     .effect = "the speed is not limited", .severity = warning, .source = "SEED-003:12468"},
    {.says = values,    .code = "G48", .words = "D", .least = 1, .most = 9, .means = "number of the axis",
     .effect = "there is no such axis", .severity = warning, .source = "SEED-003:12491"},
    {.says = values,    .code = "G48", .words = "A", .least = 0, .most = 100, .above_least = true, .below_most = true,
     .means = "ramp in per cent", .effect = "the control refuses the ramp", .severity = error, .aliases = "DIN613",
     .source = "SEED-003:12500"},
    {.says = only_with, .code = "G48", .words = "A", .others = "D", .means = "ramp in per cent",
     .effect = "it acts on the axis that D names", .severity = warning, .source = "SEED-003:12502"},
    {.says = values,    .code = "G64", .words = "E F", .least = 0.01, .most = 99.99, .above_least = true, .below_most = true,
     .means = "seconds", .effect = "the control refuses the time", .severity = error, .aliases = "DIN615",
     .source = "SEED-003:12510-12511"},

    // Compensation
    {.says = values,    .code = "G41 G42", .words = "Q", .values = "0 1 2 3 4", .means = "plane",
     .effect = "there is no such plane", .severity = warning, .source = "SEED-003:12702"},
    {.says = values,    .code = "G41 G42", .words = "H O", .values = "0 1", .means = "switch",
     .effect = "the manual knows 0 and 1 alone", .severity = warning, .source = "SEED-003:12708-12711"},
    {.says = only_with, .code = "G41 G42", .words = "H", .others = "Q", .means = "treatment of crossings",
     .effect = "it counts for the compensation of a cutter, which Q1 to Q4 choose", .severity = warning,
     .source = "SEED-003:12707"},
    {.says = alone,     .code = "G41 G42", .words = "Q H O",
     .effect = "it is programmed in a block of its own, before a straight move", .severity = warning, .aliases = "DIN010",
     .source = "SEED-003:12716"},
    {.says = precedes,  .code = "G41 G42", .others = "G0 G1 G40 G100 G101 G110 G111",
     .effect = "compensation begins on a straight move", .severity = error, .aliases = "DIN617", .source = "SEED-003:12717"},
    {.says = values,    .code = "G149", .words = "D", .least = 900, .most = 916, .means = "number of the correction",
     .effect = "there is no such correction", .severity = error, .aliases = "DIN624", .source = "SEED-003:13008"},
    {.says = needs,     .code = "G58", .words = "P", .means = "oversize",
     .effect = "no oversize is set", .severity = warning, .source = "SEED-003:12889"},
    {.says = values,    .code = "G57", .words = "X Z", .least = 0, .means = "oversize",
     .effect = "only positive oversizes are taken", .severity = error, .aliases = "DIN636", .source = "SEED-003:12862-12863"},

    // Threads, drilling
    {.says = values,    .code = "G31", .words = "V", .values = "0 1 2 3 4 5 6", .means = "kind of infeed",
     .effect = "there is no such infeed", .severity = warning, .source = "SEED-003:14672"},
    {.says = values,    .code = "G31 G32", .words = "A", .least = -60, .most = 60, .above_least = true, .below_most = true,
     .means = "angle of infeed in degrees", .effect = "the control refuses the angle", .severity = warning,
     .source = "SEED-003:14668, 14863"},
    {.says = needs,     .code = "G36", .words = "F", .means = "pitch",
     .effect = "the thread has no pitch", .severity = error, .aliases = "DIN808", .source = "SEED-003:15592"},
    {.says = needs,     .code = "G36", .words = "X Z", .means = "end of the hole",
     .effect = "the thread has no end", .severity = warning, .source = "SEED-003:15584"},
    {.says = excludes,  .code = "G73", .words = "XS", .others = "ZS", .means = "start",
     .effect = "a hole is radial or axial", .severity = warning, .source = "SEED-003:15789"},
    {.says = excludes,  .code = "G73", .words = "ID NS", .others = "XS ZS", .means = "place",
     .effect = "with a contour no start is programmed", .severity = warning, .source = "SEED-003:15790"},

    // C axis, other slides
    {.says = needs,     .code = "G154", .words = "H", .means = "0 off, 1 on",
     .effect = "nothing is switched", .severity = warning, .source = "SEED-003:16348"},
    {.says = values,    .code = "G154", .words = "H", .values = "0 1", .means = "0 off, 1 on",
     .effect = "the manual knows 0 and 1 alone", .severity = warning, .source = "SEED-003:16349"},
    {.says = needs,     .code = "G162", .words = "H", .means = "number of the mark",
     .effect = "no mark is set", .severity = warning, .source = "SEED-003:20120"},
    {.says = values,    .code = "G62 G162", .words = "H", .least = 0, .most = 15, .means = "number of the mark",
     .effect = "there is no such mark", .severity = error, .aliases = "DIN901", .source = "SEED-003:20120, 20136"},
};
// clang-format on

} // namespace

extern const WordTable dinplus_machining{
    .language = "dinplus", .sections = "MACHINING SUBPROGRAM", .rows = rows};

} // namespace maclint::word_tables
