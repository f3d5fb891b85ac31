//! MAC462: two blocks with one number that something jumps to.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <optional>
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
    .messages =
        {{"taken",
          "N{0} stands twice, and '{1}' takes the one in line {2}, the next behind it. Give one of them "
          "another number."},
         {"plain", "N{0} stands twice, and '{1}' leads to it: which block is taken depends on where the "
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

/// The label that the jump takes, where it is a plain one.
const flow::Label* taken_by(const ProgramAnalysis& analysis, EffectId jump) {
    const auto& jumps = analysis.graph().jumps;
    const auto found = std::ranges::find(jumps, jump, &flow::ResolvedJump::jump);
    return found == jumps.end() || !found->target ? nullptr : &*found->target;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto& labels = analysis.graph().labels; // equal numbers stand together
    std::optional<EffectId> user;
    for (std::size_t i = 1; i < labels.size(); ++i) {
        if (labels[i].number != labels[i - 1].number) continue;
        if (i < 2 || labels[i - 2].number != labels[i].number)
            user = analysis.user_of_label(labels[i].number);
        if (!user) continue;
        const Span span = analysis.program().effects[*user].span;
        std::vector<std::string> words{std::to_string(labels[i].number), quoted(analysis.program(), span)};
        const flow::Label* taken = taken_by(analysis, *user);
        if (taken != nullptr) words.push_back(line_number(analysis.file(), taken->span.begin));
        Finding& finding = reporter.report(analysis.file(), labels[i].span,
                                           taken != nullptr ? "taken" : "plain", std::move(words));
        finding.related.push_back({&analysis.file(), labels[i - 1].span, "the same number stands here"});
        finding.related.push_back(remark_at_effect(analysis, *user, "this leads to it"));
    }
}

} // namespace
} // namespace maclint::rules
