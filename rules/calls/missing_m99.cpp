//! MAC456: a called program that runs past its last block.
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/queries/calls/expected_ends.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/calls/end_evidence.hpp"
#include "rules/fixes.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <utility>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule missing_m99{
    .code = "MAC456",
    .name = "missing-m99",
    .aliases = "DIN506",
    .summary = "A path through a program that is called, or that ends with M99 or M30 elsewhere, ends "
               "without it (RETURN "
               "in DIN PLUS)",
    .why =
        "Only M99 leads back to the caller. Without it a FANUC control stops with an alarm at the program's "
        "end. The manual of DIN PLUS demands RETURN at the end of every subprogram. Where no caller is "
        "known, another end of the program, arguments that it works with or a state that it puts back "
        "show that it was to be left.",
    .severity = Severity::error,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::ExitState, dataflow::Read, dataflow::Store>(),
    .data_flow = true,
    .messages =
        {{"plain",
          "Missing {0}: {2} calls {1}, and a path through {1} ends after this block without it, so "
          "that the program does not return.",
          "Add {0} after this block."},
         {"other-exit",
          "Missing {0}: a path through {1} ends after this block without it, another with it on line "
          "{2}.",
          "Add {0} after this block."},
         {"argument",
          "Missing {0}: {1} works with {2}, which only a call sets, and ends after this block without "
          "{0}, so that it does not return.",
          "Add {0} after this block."},
         {"state",
          "Missing {0}: {1} saves a modal state of its caller on line {2} and puts it back, but ends "
          "after this block without {0}, so that it does not return.",
          "Add {0} after this block."}},
    .bad = {{"fanuc", R"nc(
O0001(MAIN)
G65P9456Z-5.
M30
O9456(DRILL)
IF[#26EQ#0]GOTO9
G90 G1 Z#26 F100.
M99
N9 G0 Z50.
)nc"},
            {"fanuc", R"nc(
O9457(RETRACT)
#33=#4003
G91 G28 Z0
G#33
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 L"CHAMFER" LA50
N20 M30
SUBPROGRAM "CHAMFER"
N30 G0 X#__la
END
)nc"}},
    .good = {{"fanuc", R"nc(
O0001(MAIN)
G65P9456Z-5.
M30
O9456(DRILL)
IF[#26EQ#0]GOTO9
G90 G1 Z#26 F100.
N9 M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 L"CHAMFER" LA50
N20 M30
SUBPROGRAM "CHAMFER"
N30 G0 X#__la
RETURN
END
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "5010", "END OF RECORD"}, {"FANUC 30i/0i-D", "5010", "END OF RECORD"}},
    .sources = {"SEED-001:642", "SEED-003:2949", "SEED-003:19944", "T: the alarm"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto exits = analysis.facts().all<dataflow::ExitState>();
    const auto exit = std::ranges::find(exits, flow::ExitKind::runs_off,
                                        [](const dataflow::ExitState& e) { return e.exit.kind; });
    if (exit == exits.end()) return;
    const auto why = queries::find_expected_end(analysis, exit->exit);
    const auto last = last_block(analysis.program());
    if (!why || !last) return;
    const Span span = queries::last_block_before(analysis, exit->exit, *last);
    Evidence evidence = evidence_of(analysis, *why);
    Finding& finding =
        reporter.report({analysis, span}, span, evidence.message,
                        {missing_end(analysis, *why), analysis.program().name, evidence.shown});
    offer_block_after(finding, Applicability::unsafe, span, missing_end(analysis, *why));
    if (evidence.place) finding.related.push_back(std::move(*evidence.place));
    trace(finding, analysis, exit->exit.node, "the program ends after this block");
}

} // namespace
} // namespace maclint::rules
