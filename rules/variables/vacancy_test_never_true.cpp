//! MAC228: a variable that every path to the test has set is tested for vacancy.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/conditions.hpp"
#include "analyzer/queries/feasible_paths.hpp"
#include "analyzer/queries/unset_reads.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule vacancy_test_never_true{
    .code = "MAC228",
    .name = "vacancy-test-never-true",
    .summary = "A variable that is set on every path to the test is compared with #0: it is never vacant",
    .why = "A test for 0 was probably meant. As it stands, the blocks that the test guards never run, or "
           "always.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::vacancy},
    .facts = dataflow::facts<dataflow::Comparison, dataflow::Store>(),
    .data_flow = true,
    .messages =
        {{"never-vacant",
          "'{0}' is never true: {1} has been set on every path that leads here. Test what it was made "
          "of, or write 'EQ 0' if the value 0 is meant."},
         {"always-set",
          "'{0}' is always true: {1} has been set on every path that leads here. Test what it was made "
          "of, or write 'NE 0' if the value 0 is meant."}},
    .bad = {{"fanuc", R"nc(
O9228(CLEARANCE FROM R AND Z)
#33=#18-#26
IF[#33EQ#0]GOTO9
G90 G1 Z#33
M99
N9 #3000=1(R IS Z)
)nc"}},
    .good = {{"fanuc", R"nc(
O9228(CLEARANCE FROM R AND Z)
#33=#18-#26
IF[#33EQ0]GOTO9
G90 G1 Z#33
M99
N9 #3000=1(R IS Z)
)nc"}},
    .sources = {"SEED-001:415", "MITSU-326"},
    .check = &check,
};

namespace {

const dataflow::Store* last_store_before(const ProgramAnalysis& analysis, Variable variable,
                                         flow::NodeId node) {
    const dataflow::Store* last = nullptr;
    for (const dataflow::Store& store : analysis.facts().all<dataflow::Store>())
        if (store.variable == variable && store.node < node) last = &store;
    return last;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>()) {
        const bool vacant = comparison.operation == Operation::is_vacant;
        if (!vacant && comparison.operation != Operation::is_set) continue;
        if (comparison.left.vacancy != dataflow::Vacancy::set) continue;
        const auto variable = queries::plain_variable(program, comparison.left_expression);
        if (!variable || !queries::may_hold_vacant(program, *variable) ||
            !queries::assigned_on_every_path(analysis, *variable, comparison.node))
            continue;
        const Span span = program.expressions[comparison.expression].span;
        const std::string name = program.spell(*variable);
        Finding& finding =
            reporter.report({analysis, comparison}, span, vacant ? "never-vacant" : "always-set",
                            {quoted(program, span), name});
        const std::string ends = name + " is tested for vacancy";
        if (const dataflow::Store* store = last_store_before(analysis, *variable, comparison.node))
            trace(finding, analysis, store->node,
                  {analysis.source(), program.effects[store->effect].span, name + " is set"}, comparison.node,
                  ends);
        else
            trace(finding, analysis, comparison.node, ends);
    }
}

} // namespace
} // namespace maclint::rules
