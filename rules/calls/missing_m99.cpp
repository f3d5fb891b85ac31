//! MAC456: a called program that runs past its last block.
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/queries/callers.hpp"
#include "analyzer/queries/exits.hpp"
#include "analyzer/queries/sections.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule missing_m99{
    .code = "MAC456",
    .name = "missing-m99",
    .aliases = "DIN506",
    .summary = "A path through a called program ends without M99 (RETURN in DIN PLUS)",
    .why =
        "Only M99 leads back to the caller. Without it a FANUC control stops with an alarm at the program's "
        "end. The manual of DIN PLUS demands RETURN at the end of every subprogram.",
    .severity = Severity::error,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::ExitState>(),
    .data_flow = true,
    .messages = {{"plain",
                  "Missing {2}: {0} calls {1}, and a path through {1} ends after this block without it, so "
                  "that the program does not return.",
                  "Add {2} after this block."}},
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

/// By a block that is skipped or unreadable; whether END closes a called file the manual does not say.
bool may_return_otherwise(const Program& program, const BlockView& last) {
    bool may =
        last.skip_levels != 0 || (!program.local && queries::has_section(program, SectionKind::Role::end));
    for_each_effect(program, [&](EffectId id) {
        const auto* block = std::get_if<UnreadableBlock>(&program.effects[id].what);
        may |= block != nullptr && block->may_call_or_return;
    });
    return may;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const auto exits = analysis.facts().all<dataflow::ExitState>();
    const auto exit = std::ranges::find(exits, flow::ExitKind::runs_off,
                                        [](const dataflow::ExitState& e) { return e.exit.kind; });
    const Caller* caller = exit == exits.end() ? nullptr : queries::find_reached_caller(analysis);
    const auto last = last_block(program);
    if (caller == nullptr || !last || may_return_otherwise(program, *last)) return;
    const ProgramAnalysis& calling = queries::calling_program(analysis, *caller);
    const Span span = queries::last_block_before(analysis, exit->exit, *last);
    Finding& finding =
        reporter.report({analysis, span}, span, "plain",
                        {calling.program().name, program.name, std::string(analysis.control().return_word)});
    finding.related.push_back(related_at_effect(calling, caller->effect, "calls " + program.name));
    trace(finding, analysis, exit->exit.node, "the program ends after this block");
}

} // namespace
} // namespace maclint::rules
