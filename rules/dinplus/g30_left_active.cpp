//! DIN906: conversion and mirroring are left active.
#include "rules/dinplus/left_active.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule g30_left_active{
    .code = "DIN906",
    .name = "g30-left-active",
    .aliases = "",
    .summary = "The program ends with conversion or mirroring by G30",
    .why = "The manual warns of a collision: G30 stays in force even when the operating mode is changed, and "
           "later moves are mirrored.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = true,
    .messages = {{"every-path", "'{0}' is still active when the program ends. Cancel it with {1} first."},
                 {"some-paths",
                  "'{0}' is still active on some of the paths on which the program ends. Cancel "
                  "it with {1} on those, too."}},
    .bad = {{"dinplus", "MACHINING\n"
                        "N10 G30 H1 Q3\n"
                        "N11 T1\n"
                        "N12 G0 X44 Z2\n"
                        "N13 M30\n"
                        "END\n"}},
    .good = {{"dinplus", "MACHINING\n"
                         "N10 G30 H1 Q3\n"
                         "N11 T1\n"
                         "N12 G0 X44 Z2\n"
                         "N13 G30 Q0\n"
                         "N14 M30\n"
                         "END\n"}},
    .alarms = {},
    .sources = {"SEED-003:20071-20078"},
    .check = &check_left_at_end<ModalRole::mirror_image>,
};

} // namespace maclint::rules
