//! MAC301: a jump to nowhere.
#include "analyzer/dataflow/facts/computed_jump.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <cmath>
#include <string>

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
    .precision = Precision::very_high,
    .needs = {Capability::jumps},
    .facts = dataflow::facts<dataflow::ComputedJump>(),
    .data_flow = true,
    .stands_without_path = true,
    .messages =
        {{"constant", "'{0}' jumps to N{1}, which this program does not have. Add the sequence number, or "
                      "correct the jump."},
         {"named",
          "'{0}' jumps to '{1}', a label that this program does not have where the control looks for it. Add "
          "the label, or correct the jump."},
         {"computed", "'{0}' jumps to N{1} here, which this program does not have. Check the value before "
                      "the jump."},
         {"impossible",
          "'{0}' jumps to N{1}, but sequence numbers go from 1 to 99999999. Correct the jump."}},
    .bad = {{"fanuc", R"nc(
O9301(CHECK)
IF[#100EQ1]GOTO70
#100=1
N7 M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9301(CHECK)
IF[#100EQ1]GOTO70
#100=1
N70 M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "128", "ILLEGAL MACRO SEQUENCE NUMBER"},
               {"FANUC 30i/0i-D", "078", "SEQUENCE NUMBER NOT FOUND"},
               {"FANUC 30i/0i-D", "1128", "SEQUENCE NUMBER OUT OF RANGE"},
               {"NCT", "3070", "NOT EXISTING BLOCK NO. P"}},
    .sources = {"NCT-188", "GH-ALM"},
    .check = &check,
};

namespace {

/// The 30i takes the longest ones. Some controls find N0, but nobody should be told to write it.
bool can_exist(std::int64_t number) {
    constexpr std::int64_t greatest = 99'999'999;
    return number >= 1 && number <= greatest;
}

std::string_view message_for(const Label& label) {
    const auto* number = std::get_if<std::int64_t>(&label);
    if (number == nullptr) return "named";
    return can_exist(*number) ? "constant" : "impossible";
}

std::string number_word(double number) { return std::to_string(static_cast<long long>(number)); }

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const auto missing = [&](flow::NodeId node, EffectId jump, std::string_view message, std::string number) {
        const Span span = program.effects[jump].span;
        Finding& finding =
            reporter.report({analysis, jump}, span, message, {quoted(program, span), std::move(number)});
        trace(finding, analysis, node, "there is no such sequence number");
    };
    for (const flow::ResolvedJump& jump : analysis.graph().jumps) {
        const auto& effect = std::get<Jump>(program.effects[jump.jump].what);
        if (!jump.label || jump.target || effect.missing == MissingLabel::skip) continue;
        missing(jump.node, jump.jump, message_for(*jump.label),
                quoted(program, program.expressions[effect.target].span));
    }
    for (const dataflow::ComputedJump& jump : analysis.facts().all<dataflow::ComputedJump>()) {
        const auto number = jump.target.constant();
        constexpr double most = 1e15;
        if (!number || std::abs(*number) > most) continue;
        if (!analysis.graph().has_label(std::llround(*number)))
            missing(jump.node, jump.effect, "computed", number_word(std::round(*number)));
    }
}

} // namespace
} // namespace maclint::rules
