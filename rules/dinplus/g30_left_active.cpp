//! DIN906: conversion and mirroring are left active.
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/modal_groups.hpp"
#include "rules/dinplus/left_active.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

extern const Rule g30_left_active{
    .code = "DIN906",
    .name = "g30-left-active",
    .summary = "The program ends with conversion or mirroring by G30",
    .why = "The manual warns of a collision: G30 stays in force even when the operating mode is changed, and "
           "later moves are mirrored.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::ModalWrite, dataflow::CallMade, dataflow::ExitState, dataflow::Store,
                             dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"every-path", "Code '{0}' is still active when the program ends.",
                  "Write {1} before the end."},
                 {"some-paths", "Code '{0}' is still active on some of the paths on which the program ends.",
                  "Write {1} on those, too."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 G30 H1 Q3
N11 T1
N12 G0 X44 Z2
N13 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 G30 H1 Q3
N11 T1
N12 G0 X44 Z2
N13 G30 Q0
N14 M30
END
)nc"}},
    .sources = {"SEED-003:20071-20078"},
    .check = &check_left_at_end<ModalRole::mirror_image>,
};

} // namespace maclint::rules
