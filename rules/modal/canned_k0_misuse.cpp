//! MAC565: a canned cycle that is stored and never carried out.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/queries/words/stored_cycles.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule canned_k0_misuse{
    .code = "MAC565",
    .name = "canned-k0-misuse",
    .summary = "A canned cycle with K0 or L0 is ended before a block with a position",
    .why = "K0 stores what the cycle is told, and makes no hole. The holes are made by the positions after "
           "it: where none stands nothing is drilled, and the control says nothing of it.",
    .severity = Severity::note,
    .precision = Precision::very_high,
    .facts = dataflow::facts<dataflow::BeforeNode>(),
    .messages = {{"plain",
                  "Cycle that makes no hole: '{0}' with '{1}' is only stored, and no position follows up to "
                  "line {2}, which ends it.",
                  "Write the positions of the holes after it, or remove '{1}'."}},
    .bad = {{"fanuc", R"nc(
O0565(PLATE)
G90 G54 G0 X10. Y10.
G43 Z50. H1
S2000 M3
G81 Z-20. R2. F150. K0
G80
G0 Z50.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O0565(PLATE)
G90 G54 G0 X10. Y10.
G43 Z50. H1
S2000 M3
G81 Z-20. R2. F150. K0
X20. Y10.
G80
G0 Z50.
M30
)nc"}},
    .sources = {"SEED-001:703"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const queries::StoredCycle& cycle : queries::stored_cycles(analysis)) {
        if (!cycle.no_repeats || !cycle.end || cycle.is_carried_out) continue;
        reporter.report({analysis, cycle.code}, cycle.code, "plain",
                        {quoted(program, cycle.code), quoted(program, *cycle.no_repeats),
                         line_number(analysis.file(), cycle.end->begin)});
    }
}

} // namespace
} // namespace maclint::rules
