//! The pass over the steps of a program, and over those that single calls make of it.
#include "analyzer/queries/calls/machines_of_calls.hpp"
#include "rules/machine_check.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

namespace maclint {
namespace {

/// The rules that take part in a pass.
class Pass {
  public:
    Pass(const ProgramAnalysis& analysis, std::span<const Rule* const> rules, bool is_of_one_call)
        : analysis_(analysis)
        , is_of_one_call_(is_of_one_call) {
        for (const Rule* rule : rules)
            if (const auto* check = std::get_if<MachineCheck>(&rule->check);
                check != nullptr && applies_to(*rule, analysis.control()) &&
                (check->with_numbers_of_calls || !is_of_one_call))
                taking_.push_back({check, Reporter(*rule), {}});
    }

    [[nodiscard]] bool empty() const { return taking_.empty(); }
    void show(const machine::Step& step, const machine::Habits& habits) {
        for (Taking& rule : taking_)
            rule.check->check({analysis_, step, habits, rule.told, is_of_one_call_}, rule.reporter);
    }
    [[nodiscard]] std::vector<Finding> take() {
        std::vector<Finding> findings;
        for (Taking& rule : taking_) std::ranges::move(rule.reporter.take(), std::back_inserter(findings));
        return findings;
    }

  private:
    struct Taking {
        const MachineCheck* check;
        Reporter reporter;
        std::set<Offset> told;
    };

    const ProgramAnalysis& analysis_;
    bool is_of_one_call_;
    std::vector<Taking> taking_;
};

bool is_told(const std::vector<Finding>& findings, const Finding& finding) {
    return std::ranges::any_of(findings, [&](const Finding& other) {
        return other.rule == finding.rule && other.span == finding.span;
    });
}

void name_call(Finding& finding, const queries::NumberedCall& call) {
    if (call.span.empty()) return; // the numbers are the program's own
    finding.related.push_back(
        {call.program->source(), call.span,
         call.is_shown ? "the call that its remark shows" : "called with these numbers"});
    // Remarks grow old.
    if (!call.is_shown || finding.severity != Severity::error) return;
    finding.severity = Severity::warning;
    finding.alarm = {};
}

/// Adds what the rules say of blocks to which one call surely comes, with its numbers. What was said of a
/// block before is not said again; nor is what is wrong with it whatever is passed.
void add_of_call(std::vector<Finding>& findings, const ProgramAnalysis& analysis,
                 const queries::MachineOfCall& machine, Pass pass) {
    const machine::Habits& of_all = analysis.machine().habits();
    for (flow::NodeId node = 0; node < analysis.graph().nodes.size(); ++node) {
        machine.states().for_each_step_of(node, [&](const machine::Step& step) {
            if (!of_all.is_wrong_arc(step.block.span.begin)) pass.show(step, machine.states().habits());
        });
        for (Finding& finding : pass.take()) {
            if (is_told(findings, finding) || !machine.surely_comes_by(node)) continue;
            name_call(finding, machine.call());
            findings.push_back(std::move(finding));
        }
    }
}

} // namespace

std::vector<Finding> check_machine(const ProgramAnalysis& analysis, std::span<const Rule* const> rules) {
    Pass pass(analysis, rules, false);
    if (pass.empty() || analysis.machine().empty()) return {};
    const machine::Habits& habits = analysis.machine().habits();
    if (!habits.is_of_interest()) return {};
    analysis.machine().for_each_step([&](const machine::Step& step) { pass.show(step, habits); });
    std::vector<Finding> findings = pass.take();
    const Pass of_calls(analysis, rules, true);
    if (!of_calls.empty() && habits.has_shapes())
        queries::for_each_machine_of_call(analysis, [&](const queries::MachineOfCall& machine) {
            add_of_call(findings, analysis, machine, of_calls);
        });
    return findings;
}

} // namespace maclint
