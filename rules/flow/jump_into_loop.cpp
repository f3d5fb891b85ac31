//! MAC303: a jump to the inside of a loop.
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <optional>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule jump_into_loop{
    .code = "MAC303",
    .name = "jump-into-loop",
    .summary = "A jump leads from outside into a loop, or to the block of its END",
    .why = "The control never passed the DO: at the END it raises an alarm or repeats from a "
           "place that it does not know.",
    .severity = Severity::error,
    .severity_elsewhere = {{"sinumerik", Severity::warning}},
    .precision = Precision::very_high,
    .needs = {Capability::jumps},
    .data_flow = true,
    .stands_without_path = true,
    .messages =
        {{"plain",
          "Jump into a loop: '{0}' enters the loop of '{1}' (line {2}) from outside, which the "
          "control forbids.",
          "Jump to a block before line {2} instead."},
         {"advised-against",
          "Jump into a loop: '{0}' enters the loop of '{1}' (line {2}) from outside, which the manual "
          "advises against: the control has not passed its beginning.",
          "Jump to a block before line {2} instead."}},
    .bad = {{"fanuc", R"nc(
O9303(ROW)
#100=0
IF[#101EQ1]GOTO20
WHILE[#100LT5]DO1
N20 G91 G0 X10.
G90
#100=#100+1
END1
M30
)nc"},
            {"sinumerik", R"nc(
IF R1==1 GOTOF MIDDLE
FOR R2=0 TO 4
G0 X=R2
MIDDLE: G1 Z=-R2
ENDFOR
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9303(ROW)
#100=0
IF[#101EQ1]GOTO20
G0 X0
N20 WHILE[#100LT5]DO1
G91 G0 X10.
G90
#100=#100+1
END1
M30
)nc"}},
    .sources = {"SEED-001:403", "SEED-001:704-707", "JP11 p.107"},
    .check = &check,
};

namespace {

/// The loop that every possible target of the jump lies in, and the jump itself does not.
std::optional<flow::RegionId> entered_by(const ProgramAnalysis& analysis, Offset jump,
                                         const std::vector<flow::LabelledBlock>& targets) {
    std::optional<flow::RegionId> entered;
    for (const flow::LabelledBlock& target : targets) {
        const auto loop = analysis.regions().entered(analysis.program(), jump, target.block.begin);
        if (!loop) return std::nullopt;
        if (!entered) entered = loop;
    }
    return entered;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    // Languages whose loops have closing words of their own look for these as text.
    const bool searched = analysis.control().has(Capability::paired_words);
    const std::string_view told = searched ? "advised-against" : "plain";
    // A block that cannot be read may be the END before the label.
    if (analysis.regions().balance_unknown) return;
    for (const flow::ResolvedJump& jump : analysis.graph().jumps) {
        const Span span = program.effects[jump.jump].span;
        const std::vector<flow::LabelledBlock> targets = analysis.targets_of(jump);
        const auto loop = entered_by(analysis, span.begin, targets);
        if (!loop) continue;
        const Span open = program.effects[analysis.regions().all[*loop].open].span;
        Finding& finding = reporter.report(
            {analysis, jump.jump}, span, told,
            {quoted(program, span), quoted(program, open), line_number(analysis.file(), open.begin)});
        for (const flow::LabelledBlock& target : targets)
            finding.related.push_back(
                {analysis.source(), target.span,
                 searched ? "this label is inside the loop" : "this sequence number is inside the loop"});
        finding.related.push_back({analysis.source(), open, "the loop begins here"});
        trace(finding, analysis, jump.node, "jumps into the loop");
    }
}

} // namespace
} // namespace maclint::rules
