//! MAC220: a test for 0 does not catch a missing argument.
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/after_zero_test.hpp"
#include "analyzer/queries/argument_names.hpp"
#include "analyzer/queries/conditions.hpp"
#include "analyzer/queries/unset_reads.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule zero_test_misses_vacant{
    .code = "MAC220",
    .name = "zero-test-misses-vacant",
    .summary = "EQ 0 or NE 0 on a value that can be vacant: vacant is not equal to 0 there",
    .why =
        "When the argument is missing, the test takes it for a number other than 0: the check is passed, and "
        "arithmetic after it works with 0 all the same.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::vacancy},
    .facts = dataflow::facts<dataflow::Comparison, dataflow::Read, dataflow::Store, dataflow::Clobber>(),
    .data_flow = true,
    .messages =
        {{"equal",
          "Check skipped when {1} is left out: it is vacant then, not 0, '{0}' is false, and line {2} uses "
          "it.",
          "Test it with EQ #0 as well."},
         {"not-equal",
          "Check passed when {1} is left out: it is vacant then, not 0, '{0}' is true, and line {2} uses it.",
          "Test it with NE #0 as well."}},
    .bad = {{"fanuc", R"nc(
O9220(PECK, K DEPTH OF ONE PECK)
IF[#6EQ0]GOTO9
#33=#5003-#6
G90 G1 Z#33
M99
N9 #3000=1(K MISSING)
)nc"}},
    .good = {{"fanuc", R"nc(
O9220(PECK, K DEPTH OF ONE PECK)
IF[#6EQ#0]GOTO9
IF[#6EQ0]GOTO9
#33=#5003-#6
G90 G1 Z#33
M99
N9 #3000=1(K MISSING)
)nc"}},
    .sources = {"SEED-001:415", "NCT-174", "CSDN-VAR", "MITSU-326"},
    .check = &check,
};

namespace {

bool is_zero(const dataflow::Value& value) {
    return value.vacancy == dataflow::Vacancy::set && value.constant() == 0.0;
}

/// The author treats both cases: another test of the same variable for vacancy is in the same condition, or
/// in the IF right before or after.
bool tests_both(const ProgramAnalysis& analysis, const dataflow::Comparison& comparison, Variable variable) {
    constexpr flow::NodeId nearby = 3; // nodes between two IF blocks: the condition and what it guards
    const flow::NodeId first = comparison.node - std::min(comparison.node, nearby);
    return queries::asks_for_vacancy(analysis.program(), analysis.facts(), first, comparison.node + nearby,
                                     variable);
}

/// Variables of IF[#3EQ0]GOTO1, IF[#3EQ1]GOTO2 …: a choice among numbers, whose default a missing argument
/// takes as well.
std::vector<Variable> find_choices(const ProgramAnalysis& analysis) {
    std::vector<Variable> choices;
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>()) {
        const auto constant = comparison.right.constant();
        if (comparison.operation != Operation::equal || !constant || *constant == 0) continue;
        const auto variable = queries::plain_variable(analysis.program(), comparison.left_expression);
        if (variable && std::ranges::find(choices, *variable) == choices.end()) choices.push_back(*variable);
    }
    return choices;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const std::vector<Variable> choices = find_choices(analysis);
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>()) {
        if (comparison.operation != Operation::equal && comparison.operation != Operation::not_equal)
            continue;
        const bool zero_left = is_zero(comparison.left);
        if (!zero_left && !is_zero(comparison.right)) continue;
        const dataflow::Value& value = zero_left ? comparison.right : comparison.left;
        if (value.vacancy != dataflow::Vacancy::maybe || value.vacancy_origin == 0) continue;
        const auto variable = queries::plain_variable(program, zero_left ? comparison.right_expression
                                                                         : comparison.left_expression);
        if (!variable || !queries::may_hold_vacant(program, *variable) ||
            std::ranges::find(choices, *variable) != choices.end() ||
            tests_both(analysis, comparison, *variable))
            continue;
        const auto used = queries::use_after_zero_test(analysis, comparison, value, *variable);
        if (!used) continue;
        const Span span = program.expressions[comparison.expression].span;
        const std::string name = program.spell(*variable);
        Finding& finding = reporter.report({analysis, comparison}, span,
                                           comparison.operation == Operation::equal ? "equal" : "not-equal",
                                           {quoted(program, span), queries::with_letter(program, *variable),
                                            line_number(analysis.file(), used->begin)});
        finding.same_cause =
            program.name + (comparison.operation == Operation::equal ? " EQ" : " NE"); // a habit
        finding.related.push_back({analysis.source(), *used, name + " is used here"});
        trace_vacancy(finding, analysis, value.vacancy_origin, name, comparison.node,
                      name + " is compared with 0");
    }
}

} // namespace
} // namespace maclint::rules
