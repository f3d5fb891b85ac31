//! MAC320: the step of a loop's counter may be 0, or has the wrong sign.
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule infinite_loop_step{
    .code = "MAC320",
    .name = "infinite-loop-step",
    .aliases = "DIN408",
    .summary =
        "The step that a loop advances by may be 0 or vacant, or has the wrong sign: the loop never ends",
    .why = "An argument that the caller left out counts as 0 in arithmetic. The control then repeats the "
           "same pass "
           "until somebody presses reset.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .data_flow = true,
    .messages = {{"vacant",
                  "'{0}' changes nothing when {1} is left out or 0, and the loop never ends. Reject "
                  "both before the loop."},
                 {"zero", "'{0}' changes nothing, and the loop never ends: its step is 0. Correct the step."},
                 {"wrong-sign",
                  "'{0}' leads away from the end of the loop, which therefore never comes. Turn the sign "
                  "of the step or the comparison around."}},
    .bad = {{"fanuc", R"nc(
O9320(DEPTH PASSES, Z DEPTH K STEP)
#33=0
WHILE[#33GT#26]DO1
#33=#33-#6
G90 G1 Z#33
END1
M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 #l3=2
N20 WHILE #l3<10
N30 G0 X200 Z-#l3
N40 G1 Zi-15
N50 #l3=#l3-2
N60 ENDWHILE
N70 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9320(DEPTH PASSES, Z DEPTH K STEP)
IF[#6LE0]GOTO9
#33=0
WHILE[#33GT#26]DO1
#33=#33-#6
G90 G1 Z#33
END1
M99
N9 #3000=1(K MUST BE POSITIVE)
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 #l3=2
N20 WHILE #l3<10
N30 G0 X200 Z-#l3
N40 G1 Zi-15
N50 #l3=#l3+2
N60 ENDWHILE
N70 M30
END
)nc"}},
    .sources = {"SEED-001:1028-1068"},
    .check = &check,
};

namespace {

enum class Fault : std::uint8_t { none, vacant, zero, wrong_sign };

/// Whether the step moves the counter to where the loop goes on.
bool leads_away(const dataflow::Counter& counter, const dataflow::Step& step, double amount) {
    if (!counter.clamps.empty()) return false;
    const bool down = (step.operation == Operation::subtract) == (amount > 0);
    return std::ranges::all_of(counter.tests, [down](const dataflow::CounterTest& test) {
        const bool below = test.stays == Operation::less || test.stays == Operation::less_equal;
        const bool above = test.stays == Operation::greater || test.stays == Operation::greater_equal;
        return down ? below : above;
    });
}

Fault fault_of(const ProgramAnalysis& analysis, const dataflow::Counter& counter,
               const dataflow::Step& step) {
    const dataflow::Value& amount = step.amount;
    if (amount.vacancy_origin != 0 && amount.can_be(0)) {
        // A local that nothing can have set is MAC209's.
        const auto variable = analysis.data().origin(amount.vacancy_origin).entry_variable();
        return variable && analysis.data().is_vacant_at_entry(*variable) ? Fault::none : Fault::vacant;
    }
    const auto constant = amount.constant();
    if (!constant) return Fault::none;
    if (*constant == 0) return Fault::zero;
    return leads_away(counter, step, *constant) ? Fault::wrong_sign : Fault::none;
}

std::string name_of_vacancy_origin(const ProgramAnalysis& analysis, const dataflow::Step& step) {
    const auto variable = analysis.data().origin(step.amount.vacancy_origin).entry_variable();
    if (variable) return analysis.program().spell(*variable);
    return "'" + quoted(analysis.program(), analysis.program().expressions[step.expression].span) + "'";
}

Finding& report(const ProgramAnalysis& analysis, Reporter& reporter, const dataflow::Store& store,
                Fault fault) {
    const Program& program = analysis.program();
    const Span span = program.effects[store.effect].span;
    const std::string text = quoted(program, span);
    if (fault == Fault::vacant) {
        const std::string name = name_of_vacancy_origin(analysis, *store.step);
        Finding& finding = reporter.report({analysis, store.effect}, span, "vacant", {text, name});
        trace(finding, analysis, store.step->amount.vacancy_origin, name + " may be vacant from here on",
              store.node, "a vacant " + name + " counts as 0 in arithmetic");
        return finding;
    }
    Finding& finding =
        reporter.report({analysis, store.effect}, span, fault == Fault::zero ? "zero" : "wrong-sign", {text});
    trace(finding, analysis, store.node, "the counter is changed here");
    return finding;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    std::vector<EffectId> known;
    for (const dataflow::Loop& loop : analysis.loops()) {
        if (loop.can_stop || loop.has_unknown_effects) continue;
        const auto& counter = loop.counter;
        if (!counter) continue;
        std::vector<Fault> faults;
        for (const dataflow::Store* store : counter->steps)
            faults.push_back(fault_of(analysis, *counter, *store->step));
        if (std::ranges::find(faults, Fault::none) != faults.end()) continue;
        const dataflow::Store& first = *counter->steps.front();
        if (std::ranges::find(known, first.effect) != known.end()) continue;
        known.push_back(first.effect);
        Finding& finding = report(analysis, reporter, first, faults.front());
        for (const dataflow::CounterTest& test : counter->tests)
            finding.related.push_back({analysis.source(),
                                       analysis.program().expressions[test.comparison->expression].span,
                                       "this decides when the loop ends"});
    }
}

} // namespace
} // namespace maclint::rules
