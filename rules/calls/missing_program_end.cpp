//! MAC455: a program that runs past its last block, and has no end anywhere.
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/expected_ends.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/fixes.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);

constexpr Exemption part_before_the_next, fragment;
} // namespace

extern const Rule missing_program_end{
    .code = "MAC455",
    .name = "missing-program-end",
    .summary = "A program with a number of its own has no M30, M02 or M99 at all",
    .why = "The control comes to the end of the program and stops with an alarm: the part is finished, the "
           "spindle may still turn, and the next start does not begin at the first block. Where it is a "
           "subprogram, it never returns. A note where no alarm of the control is known.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .facts = dataflow::facts<dataflow::ExitState, dataflow::Read, dataflow::Store>(),
    .data_flow = true,
    .messages = {{"plain", "Missing end: {0} ends after this block, without {2} and without {1}.",
                  "Add {2} after this block, or {1} if other programs call it."}},
    .bad = {{"fanuc", R"nc(
O0455(FACE)
G90 G54 G0 X0 Y0 S1200 M3
G43 H1 Z5.
G1 Z-1. F200.
X80.
G0 Z50. M5
)nc"}},
    .good = {{"fanuc", R"nc(
O0455(FACE)
G90 G54 G0 X0 Y0 S1200 M3
G43 H1 Z5.
G1 Z-1. F200.
X80.
G0 Z50. M5
M30
)nc"},
             {"fanuc", R"nc(
O0456(FACE, ENDS IN ANOTHER PROGRAM)
G90 G54 G0 X0 Y0
M98 P8999
)nc"}},
    .exemptions =
        {{&part_before_the_next,
          "part-before-the-next",
          "What follows in the file is named by no number: it may be a part of this program, with its end.",
          {"fanuc", R"nc(
O0455(PLATE)
G90 G0 X0
<PART TWO>
X10.
M30
)nc"}},
         {&fragment,
          "fragment",
          "Nothing moves or is decided, or no number names the program: a list of data, or a part of a "
          "program.",
          {"fanuc", R"nc(
O0455(OFFSETS)
G10 L2 P1 X0 Y0 Z0
)nc"}}},
    .alarms = {{"FANUC 16i/18i/21i", "5010", "END OF RECORD"}, {"FANUC 30i/0i-D", "5010", "END OF RECORD"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

/// Whether what follows in the file is no program by its number: it may be a part of this one.
bool may_go_on(const ProgramAnalysis& analysis) {
    const auto& programs = analysis.file().programs; // in the order of the text
    const auto next = std::ranges::upper_bound(programs, analysis.program().span.begin, {},
                                               [](const Program& program) { return program.span.begin; });
    return next != programs.end() && !next->number;
}

/// Whether it is a program and no fragment of one: its text names it by a number, and it moves an axis, or
/// decides something.
bool is_whole(const ProgramAnalysis& analysis) {
    const Program& program = analysis.program();
    const auto does_something = [](const Effect& effect) {
        return std::holds_alternative<Motion>(effect.what) || std::holds_alternative<Guarded>(effect.what);
    };
    bool is_work = false;
    for_each_block(program, [&](const BlockView& block) {
        is_work |= block.moves || std::ranges::any_of(program.effects_in(block.effects), does_something);
        return !is_work;
    });
    return is_work && program.number && !program.name_span.empty();
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    // Where programs have sections, the manual lets the last of them end the program.
    const auto last = last_block(analysis.program());
    if (!analysis.control().sections.empty() || !last) return;
    const auto exits = analysis.facts().all<dataflow::ExitState>();
    const auto leaves = [](const dataflow::ExitState& e) { return e.exit.kind == flow::ExitKind::runs_off; };
    const auto exit = std::ranges::find_if(exits, leaves);
    if (exit == exits.end() || (part_before_the_next.is_on() && may_go_on(analysis)) ||
        (fragment.is_on() && !is_whole(analysis)) || queries::may_end_otherwise(analysis, exit->exit) ||
        queries::find_expected_end(analysis, exit->exit)) // MAC456's
        return;
    const Span span = queries::last_block_before(analysis, exit->exit, *last);
    Finding& finding = reporter.report({analysis, span}, span, "plain",
                                       {analysis.program().name, std::string(analysis.control().return_word),
                                        std::string(analysis.control().end_word)});
    if (finding.alarm.empty()) finding.severity = std::min(finding.severity, Severity::note);
    offer_block_after(finding, Applicability::unsafe, span, std::string(analysis.control().end_word));
    trace(finding, analysis, exit->exit.node, "the program ends after this block");
}

} // namespace
} // namespace maclint::rules
