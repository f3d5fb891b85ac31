//! DIN407: a loop counts in a variable that the program has not set.
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/loops/loop_counter.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule loop_variable_uninitialised{
    .code = "DIN407",
    .name = "loop-variable-uninitialised",
    .summary = "A loop counts in a channel variable that the program has not set before",
    .why = "The variable keeps what the part before has left in it: the loop runs in the first part and not "
           "in the second. An undefined variable may read as 0, or be an error.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::undefined_variables},
    .facts = dataflow::facts<dataflow::Store, dataflow::Clobber, dataflow::Comparison>(),
    .data_flow = true,
    .messages =
        {{"plain",
          "Loop variable without a value: the loop counts in {0}, which the program has not set before.",
          "Set {0} before the loop."},
         {"some-paths",
          "Loop variable without a value: the loop counts in {0}, which the program has not set on every "
          "path to the loop.",
          "Set {0} before the loop."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 WHILE #c4<10
N11 G0 X10 Z2
N12 G1 Z-14
N13 #c4=#c4+1
N14 ENDWHILE
N15 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 #c4=0
N11 WHILE #c4<10
N12 G0 X10 Z2
N13 G1 Z-14
N14 #c4=#c4+1
N15 ENDWHILE
N16 M30
END
)nc"}},
    .sources = {"SEED-003:19721", "SEED-003:18956"},
    .check = &check,
};

namespace {

/// Variables that all programs share and that have no value of their own at the start. Those of a call level
/// are uninitialised-local's.
bool is_shared_and_uninitialised(const ProgramAnalysis& analysis, Variable variable) {
    const VariableSpace& space = analysis.control().spaces[variable.space];
    return space.scope == Scope::shared && space.initial_value == InitialValue::undefined;
}

/// Whether it holds a value when the loop tests it, as DEF and NDEF find out.
bool is_known_to_be_set(const ProgramAnalysis& analysis, const queries::Counter& counter) {
    const dataflow::Comparison& test = *counter.tests.front().comparison;
    const bool on_left =
        queries::plain_variable(analysis.program(), test.left_expression) == counter.variable;
    return (on_left ? test.left : test.right).vacancy == dataflow::Vacancy::set;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    if (!analysis.is_main()) return; // a caller may have set it
    const Program& program = analysis.program();
    for (const dataflow::Loop& loop : analysis.loops()) {
        const auto counter = queries::counter_of(analysis, loop);
        if (!counter || !is_shared_and_uninitialised(analysis, counter->variable) ||
            is_known_to_be_set(analysis, *counter))
            continue;
        execution::PathSearch search(analysis);
        const auto path =
            queries::path_without_assignment(search, analysis, counter->variable, loop.head).path;
        if (!path) continue;
        const dataflow::Comparison& test = *counter->tests.front().comparison;
        const Span span = program.expressions[test.expression].span;
        const bool sometimes =
            std::ranges::any_of(analysis.facts().about<dataflow::Store>(counter->variable),
                                [&](const dataflow::Store* store) { return !loop.holds(store->node); });
        Finding& finding = reporter.report({analysis, test}, span, sometimes ? "some-paths" : "plain",
                                           {program.spell(counter->variable)});
        finding.path = steps_along(analysis, *path);
        finding.path.push_back({analysis.source(), span, "the loop begins, and nothing has set its counter"});
    }
}

} // namespace
} // namespace maclint::rules
