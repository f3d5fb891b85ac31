//! MAC303: a jump to the inside of a loop.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <cmath>
#include <optional>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule jump_into_loop{
    .code = "MAC303",
    .name = "jump-into-loop",
    .aliases = "",
    .summary = "A jump leads from outside into a loop, or to the block of its END",
    .why = "The control never passed the DO: at the END it raises an alarm or repeats from a "
           "place that it does not know.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = true,
    .messages = {{"plain",
                  "'{0}' enters the loop of '{1}' (line {2}) from outside, which the control forbids. "
                  "Jump to the block of the loop's beginning instead."}},
    .bad = {{"fanuc", "O9303(ROW)\n"
                      "#100=0\n"
                      "IF[#101EQ1]GOTO20\n"
                      "WHILE[#100LT5]DO1\n"
                      "N20 G91 G0 X10.\n"
                      "G90\n"
                      "#100=#100+1\n"
                      "END1\n"
                      "M30\n"}},
    .also = {},
    .good = {{"fanuc", "O9303(ROW)\n"
                       "#100=0\n"
                       "IF[#101EQ1]GOTO20\n"
                       "G0 X0\n"
                       "N20 WHILE[#100LT5]DO1\n"
                       "G91 G0 X10.\n"
                       "G90\n"
                       "#100=#100+1\n"
                       "END1\n"
                       "M30\n"}},
    .alarms = {},
    .sources = {"SEED-001:403", "SEED-001:704-707"},
    .check = &check,
};

namespace {

/// The outermost loop that holds the target but not the jump.
std::optional<flow::StructureId> loop_entered(const ProgramAnalysis& analysis, Offset from, Offset to) {
    const flow::Structures& structures = analysis.structures();
    std::optional<flow::StructureId> entered;
    auto loop = structures.loop_around(analysis.program(), to);
    for (; loop; loop = structures.all[*loop].parent)
        if (structures.holds(analysis.program(), *loop, to) &&
            !structures.holds(analysis.program(), *loop, from))
            entered = loop;
    return entered;
}

void report(const ProgramAnalysis& analysis, Reporter& reporter, flow::NodeId node, EffectId jump,
            flow::StructureId loop, const flow::Label& label) {
    const Program& program = analysis.program();
    const Span span = program.effects[jump].span;
    const Span open = program.effects[analysis.structures().all[loop].open].span;
    Finding& finding = reporter.report(
        analysis.file(), span, "plain",
        {quoted(program, span), quoted(program, open), line_number(analysis.file(), open.begin)});
    finding.related.push_back({&analysis.file(), label.span, "this sequence number is inside the loop"});
    finding.related.push_back({&analysis.file(), open, "the loop begins here"});
    trace(finding, analysis, node, "jumps into the loop");
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto entered = [&](EffectId jump, const flow::Label& label) {
        return loop_entered(analysis, analysis.program().effects[jump].span.begin, label.block.begin);
    };
    for (const flow::ResolvedJump& jump : analysis.graph().jumps) {
        if (!jump.target || !analysis.data().reached(jump.node)) continue;
        if (const auto loop = entered(jump.jump, *jump.target))
            report(analysis, reporter, jump.node, jump.jump, *loop, *jump.target);
    }
    for (const dataflow::ComputedJump& jump : analysis.facts().computed_jumps) {
        const auto number = jump.target.constant();
        constexpr double most = 1e15;
        if (!number || std::abs(*number) > most) continue;
        const Offset here = analysis.program().effects[jump.effect].span.begin;
        const flow::Label* label = analysis.graph().find_label(std::llround(*number), here);
        if (label == nullptr) continue;
        if (const auto loop = entered(jump.effect, *label))
            report(analysis, reporter, jump.node, jump.effect, *loop, *label);
    }
}

} // namespace
} // namespace maclint::rules
