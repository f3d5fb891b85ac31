//! MAC462: two blocks with one number that something jumps to.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule duplicate_sequence_number{
    .code = "MAC462",
    .name = "duplicate-sequence-number",
    .aliases = "DIN005",
    .summary = "Two blocks have one sequence number, and something jumps to it",
    .why = "Which of the two the control finds depends on where its search starts: the same jump"
           " goes to different places from different blocks.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = false,
    .messages = {{"plain",
                  "N{0} stands twice, and '{1}' jumps to it: which block is taken depends on where the "
                  "search starts. Give one of them another number."}},
    .bad = {{"fanuc", "O9462(TWO)\n"
                      "IF[#100EQ1]GOTO20\n"
                      "N20 G0 X1.\n"
                      "N20 G0 X2.\n"
                      "M30\n"}},
    .also = {},
    .good = {{"fanuc", "O9462(TWO)\n"
                       "IF[#100EQ1]GOTO20\n"
                       "N20 G0 X1.\n"
                       "N30 G0 X2.\n"
                       "M30\n"}},
    .alarms = {},
    .sources = {"ISORP", "T: search order"},
    .check = &check,
};

namespace {

/// A reached jump that can go to the number.
const flow::ResolvedJump* jump_to(const ProgramAnalysis& analysis, std::int64_t number) {
    const auto& jumps = analysis.graph().jumps;
    const auto found = std::ranges::find_if(jumps, [&](const flow::ResolvedJump& jump) {
        return jump.number == number && analysis.data().reached(jump.node);
    });
    return found == jumps.end() ? nullptr : &*found;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto& labels = analysis.graph().labels;
    for (std::size_t i = 1; i < labels.size(); ++i) {
        if (labels[i].number != labels[i - 1].number) continue;
        const flow::ResolvedJump* jump = jump_to(analysis, labels[i].number);
        if (jump == nullptr) continue;
        const Span span = analysis.program().effects[jump->jump].span;
        Finding& finding =
            reporter.report(analysis.file(), labels[i].span, "plain",
                            {std::to_string(labels[i].number), quoted(analysis.program(), span)});
        finding.related.push_back({&analysis.file(), labels[i - 1].span, "the same number stands here"});
        finding.related.push_back({&analysis.file(), span, "this jumps to it"});
    }
}

} // namespace
} // namespace maclint::rules
