//! MAC606: an output is switched while the control may still be making a move.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/machine/unfinished_moves.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <map>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule lookahead_output{
    .code = "MAC606",
    .name = "lookahead-output",
    .summary = "An output is switched behind a move with nothing between that stops look-ahead",
    .why = "A control computes macro statements as soon as it has read them, while the axes still move: the "
           "clamp opens, or the part is pushed out, before the tool is where the block before sends it. An M "
           "code behind the move may stop look-ahead, where a parameter says so; name those that do under "
           "'stops-look-ahead' of the control in .maclint.json.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .data_flow = true,
    .messages = {{"output",
                  "Output switched too early: '{0}' may be run before the move on line {1} has ended.",
                  "Stop look-ahead after the move, as by G53 in a block of its own."}},
    .bad = {{"fanuc", R"nc(
O9606(PUSH THE PART OUT)
G90 G0 X0 Y0
#1101=1
G4 X1.
G53
#1101=0
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9606(PUSH THE PART OUT)
G90 G0 X0 Y0
G53
#1101=1
G4 X1.
G53
#1101=0
M99
)nc"},
             {"fanuc", R"nc(
O9607(AIR ON, THEN MOVE)
#1101=1
G90 G0 X0 Y0
M99
)nc"}},
    .sources = {"HAAS-LA", "MAN-AINANO"},
    .check = &check,
};

namespace {

/// Whether the assignment switches an output on or off.
bool switches_output(const ProgramAnalysis& analysis, const Assign& assign) {
    const auto* target = std::get_if<StoreMachine>(&assign.target);
    if (target == nullptr) return false;
    const VariableRange* range = analysis.control().families[target->family].find(target->number);
    return range != nullptr && range->is_output;
}

/// An assignment that may be run before the move has ended.
struct EarlyOutput {
    EffectId effect;
    flow::NodeId node;
    queries::UnfinishedMove move;
    [[nodiscard]] bool stands_behind() const { return node > move.node; }
};

/// For each move the first behind it in the text, else the first of those that the next round of a loop comes
/// to.
std::map<flow::NodeId, EarlyOutput> early_outputs(const ProgramAnalysis& analysis) {
    std::map<flow::NodeId, EarlyOutput> found;
    const Program& program = analysis.program();
    for (EffectId id = 0; id < program.effects.size(); ++id) {
        const auto* assign = std::get_if<Assign>(&program.effects[id].what);
        if (assign == nullptr || !switches_output(analysis, *assign)) continue;
        const auto node = analysis.graph().node_of(id);
        const auto move = node ? queries::unfinished_move_before(analysis, *node, {}) : std::nullopt;
        if (!move) continue;
        const EarlyOutput early{id, *node, *move};
        const auto [first, fresh] = found.try_emplace(move->node, early);
        if (!fresh && early.stands_behind() && !first->second.stands_behind()) first->second = early;
    }
    return found;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    if (queries::limits_look_ahead(program)) return;          // wherever its block stands
    for (const auto& [at, early] : early_outputs(analysis)) { // one move, one finding
        const Span span = program.effects[early.effect].span;
        Finding& finding =
            reporter.report({analysis, early.effect}, span, "output",
                            {quoted(program, span), line_number(analysis.file(), early.move.span.begin)});
        trace(finding, analysis, at, {analysis.source(), early.move.span, "this move may still run"},
              early.node, "when the output is switched");
    }
}

} // namespace
} // namespace maclint::rules
