//! MAC301: a jump to nowhere.
#include "analyzer/dataflow/facts/computed_jump.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/flow/nearby_numbers.hpp"
#include "rules/flow/other_direction.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule jump_target_missing{
    .code = "MAC301",
    .name = "jump-target-missing",
    .summary = "A jump names a sequence number that the program does not have",
    .why = "The control searches the program to its end and stops with an alarm, with the tool "
           "where it happens to be.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::jumps},
    .facts = dataflow::facts<dataflow::ComputedJump>(),
    .data_flow = true,
    .stands_without_path = true,
    .messages =
        {{"constant", "Missing sequence number: '{0}' finds no N{1} in this program.",
          "Add N{1}, or correct the jump; nearest: {2}."},
         {"no-numbers", "Missing sequence number: '{0}' finds no N{1} in this program, which has none.",
          "Correct the jump, or give its target a number."},
         {"named", "Missing label: '{0}' finds no '{1}' where the control looks for it.",
          "Add the label, or correct the jump."},
         {"other-side",
          "Label on the other side: '{0}' does not look where '{1}' stands, on line {2}, and finds none.",
          "Let the jump look in the other direction."},
         {"computed", "Missing sequence number: '{0}' goes to N{1} here, which this program does not have.",
          "Check the value before the jump; nearest: {2}."},
         {"impossible", "Impossible sequence number: '{0}' jumps to N{1}, but they go from 1 to 99999999.",
          "Correct the jump."}},
    .bad = {{"fanuc", R"nc(
O9301(CHECK)
IF[#100EQ1]GOTO70
#100=1
N7 M30
)nc"},
            {"sinumerik", R"nc(
READY: R1=R1+1
IF R1<5 GOTOF READY
)nc"}},
    .good = {{"fanuc", R"nc(
O9301(CHECK)
IF[#100EQ1]GOTO70
#100=1
N70 M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "128", "ILLEGAL MACRO SEQUENCE NUMBER"},
               {"FANUC 30i/0i-D", "128", "ILLEGAL MACRO SEQUENCE NUMBER"},
               {"FANUC 30i/0i-D", "1128", "SEQUENCE NUMBER OUT OF RANGE", true, "impossible"},
               {"NCT", "3070", "NOT EXISTING BLOCK NO. P"},
               {"SINUMERIK", "14080", "jump target not found"}},
    .sources = {"NCT-188", "GH-ALM"},
    .check = &check,
};

namespace {

/// The 30i takes the longest ones. Some controls find N0, but nobody should be told to write it.
constexpr std::int64_t greatest = 99'999'999;
bool can_exist(std::int64_t number) { return number >= 1 && number <= greatest; }

std::string_view message_for(const Label& label) {
    if (const auto* number = std::get_if<std::int64_t>(&label))
        return can_exist(*number) ? "constant" : "impossible";
    return "named";
}

/// Whether the label stands where the jump does not look.
bool report_other_side(const ProgramAnalysis& analysis, const flow::ResolvedJump& jump, Reporter& reporter) {
    const Program& program = analysis.program();
    const Span span = program.effects[jump.jump].span;
    const auto* label = analysis.graph().find_label(*jump.label, span.begin, LabelSearch::forward_then_top);
    if (label == nullptr) return false;
    Finding& finding = reporter.report({analysis, jump.jump}, span, "other-side",
                                       {quoted(program, span), quoted(program, label->span),
                                        line_number(analysis.file(), label->span.begin)});
    finding.related.push_back({analysis.source(), label->span, "the label stands here"});
    offer_other_direction(finding, analysis, span);
    trace(finding, analysis, jump.node, "the label stands on the other side");
    return true;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    NearbyNumbers nearby(analysis);
    const auto missing = [&](flow::NodeId node, EffectId jump, std::string_view message, std::string number,
                             std::string near) {
        const Span span = program.effects[jump].span;
        if (near.empty() && message != "named" && message != "impossible") message = "no-numbers";
        std::vector<std::string> words{quoted(program, span), std::move(number)};
        if (!near.empty()) words.push_back(std::move(near));
        Finding& finding = reporter.report({analysis, jump}, span, message, std::move(words));
        if (message != "impossible") finding.same_cause = "program " + std::to_string(analysis.index());
        trace(finding, analysis, node,
              message == "named" ? "there is no such label" : "there is no such sequence number");
    };
    for (const flow::ResolvedJump& jump : analysis.graph().jumps) {
        const auto& effect = std::get<Jump>(program.effects[jump.jump].what);
        if (!jump.label || jump.target || effect.missing == MissingLabel::skip) continue;
        if (report_other_side(analysis, jump, reporter)) continue;
        const std::string_view message = message_for(*jump.label);
        const auto* number = std::get_if<std::int64_t>(&*jump.label);
        if (message == "constant")
            missing(jump.node, jump.jump, message, std::to_string(*number), nearby(*number));
        else
            missing(jump.node, jump.jump, message, quoted(program, program.expressions[effect.target].span),
                    "");
    }
    for (const dataflow::ComputedJump& jump : analysis.facts().all<dataflow::ComputedJump>()) {
        const auto number = jump.target.constant();
        constexpr double most = 1e15;
        if (!number || std::abs(*number) > most) continue;
        const std::int64_t rounded = std::llround(*number);
        if (!analysis.graph().has_label(rounded))
            missing(jump.node, jump.effect, "computed", std::to_string(rounded), nearby(rounded));
    }
}

} // namespace
} // namespace maclint::rules
