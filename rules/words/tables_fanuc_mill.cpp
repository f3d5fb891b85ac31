//! Rows for mills of Fanuc and their relatives.
#include "rules/words/word_row.hpp"

namespace maclint::word_tables {
namespace {

constexpr std::string_view fanuc_30i = "FANUC 30i/0i-D";
constexpr std::string_view of_fanuc = "fanuc fanuc-16i fanuc-0i-c fanuc-0i-d fanuc-30i";
/// Where others that nobody has named write otherwise.
constexpr std::string_view named_fanuc = "fanuc-16i fanuc-0i-c fanuc-0i-d fanuc-30i";
constexpr std::string_view axes = "X Y Z A B C U V W";
using enum RowStatement;
using enum Severity;

// clang-format off
constexpr WordRow rows[] = {
    // Dwell
    {.says = excludes,  .code = "G4", .words = "X", .others = "P", .means = "time",
     .effect = "only one of the two times counts", .severity = warning, .source = "T"},
    {.says = only_with, .code = "G4", .words = "F", .others = "X P", .means = "time",
     .effect = "the control does not wait", .severity = warning, .source = "T"},
    {.says = whole,     .code = "G4", .words = "P", .controls = named_fanuc, .means = "time in ms",
     .effect = "the control stops", .severity = warning, .source = "T"},

    {.says = takes_not, .code = "G4 G10", .words = "T", .controls = of_fanuc, .means = "tool",
     .effect = "the control takes no tool in this block", .severity = warning, .alarms = {{{fanuc_30i, "245"}}}, .source = "GH-ALM"},

    // Reference points, probing, coordinate systems. G53 and G31 alone stand for a stop of look-ahead in some shops, G43
    // without H takes the number of the block before.
    {.says = needs,     .code = "G30", .words = axes, .means = "axes that return",
     .effect = "no axis moves", .severity = warning, .source = "T"},
    {.says = values,    .code = "G30", .words = "P", .values = "2 3 4", .controls = of_fanuc, .means = "reference point",
     .effect = "there is no such reference point", .severity = warning,
     .alarms = {{{"FANUC 16i/18i/21i", "046"}, {fanuc_30i, "046"}}}, .source = "T"},
    {.says = refused,   .code = "G31", .under = "G41 G42", .controls = of_fanuc,
     .effect = "the control takes no skip move under compensation", .severity = warning, .source = "T"},
    {.says = whole,     .code = "G30", .words = "P", .controls = of_fanuc, .means = "reference point",
     .effect = "the control stops", .severity = warning,
     .alarms = {{{"FANUC 16i/18i/21i", "007"}, {fanuc_30i, "007"}}}, .source = "CSDN-PS"},
    {.says = needs,     .code = "G52", .words = axes, .means = "local zero",
     .effect = "no zero is shifted", .severity = warning, .source = "T"},
    {.says = needs,     .code = "G92", .words = "X Y Z A B C U V W S", .means = "present position or highest speed",
     .effect = "nothing is set", .severity = warning, .source = "T"},
    {.says = values,    .code = "G68", .words = "R", .least = -360, .most = 360, .controls = of_fanuc, .means = "angle in degrees",
     .effect = "the control stops, or turns by another angle", .severity = warning, .source = "T"},

    // Canned cycles: what a cycle is told stays until G80
    {.says = needs,     .code = "G73 G83", .words = "Q", .kept = true, .means = "depth of a peck",
     .effect = "the control stops, or drills the hole in one stroke", .severity = warning,
     .alarms = {{{fanuc_30i, "045"}}}, .source = "GH-ALM"},
    {.says = needs,     .code = "G76 G87", .words = "Q I J", .kept = true, .means = "shift at the bottom",
     .effect = "the tool is drawn back along the wall that it has just bored", .severity = warning, .source = "T"},
};
// clang-format on

} // namespace

extern const WordTable fanuc_mill{.language = "fanuc", .machine = Machine::mill, .rows = rows};

} // namespace maclint::word_tables
