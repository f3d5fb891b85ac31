//! MAC221: a missing argument passes a range check, because GT, GE, LT and LE take vacant for 0.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/vacancy/unset_reads.hpp"
#include "analyzer/semantics/concrete.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <unordered_set>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule vacant_in_relational_comparison{
    .code = "MAC221",
    .name = "vacant-in-relational-comparison",
    .summary = "GT, GE, LT and LE take a vacant variable for 0: a missing argument passes the check",
    .why = "A range check that 0 passes is passed by a missing argument, too. What follows then works with "
           "0, or "
           "leaves out the words that hold the variable.",
    .severity = Severity::note,
    .precision = Precision::medium,
    .needs = {Capability::vacancy},
    .on_by_default = false,
    .off_reason = "arguments that may be left out, with 0 as their default, are a custom of many macros",
    .facts = dataflow::facts<dataflow::Read, dataflow::Comparison>(),
    .data_flow = true,
    .messages =
        {{"passes",
          "Check passed by a missing argument: '{0}' takes a vacant {1} for 0, and {1} is used after it.",
          "Test it with EQ #0 first."}},
    .bad = {{"fanuc", R"nc(
O9221(PECK, K CLEARANCE)
IF[#6LT0]GOTO9
G90 G1 Z[10.-#6]
M99
N9 #3000=1(K NEGATIVE)
)nc"}},
    .good = {{"fanuc", R"nc(
O9221(PECK, K CLEARANCE)
IF[#6EQ#0]GOTO9
IF[#6LT0]GOTO9
G90 G1 Z[10.-#6]
M99
N9 #3000=1(K MISSING OR NEGATIVE)
)nc"}},
    .sources = {"SEED-001:415"},
    .check = &check,
};

namespace {

/// A later read of the variable that still may find it vacant.
const dataflow::Read* later_use(const ProgramAnalysis& analysis, const dataflow::Comparison& comparison,
                                Variable variable) {
    const auto reads = analysis.facts().about<dataflow::Read>(variable);
    const auto found = std::ranges::find_if(reads, [&](const dataflow::Read* read) {
        const bool used = read->use == dataflow::Use::word || read->use == dataflow::Use::arithmetic ||
                          read->use == dataflow::Use::argument || read->use == dataflow::Use::index;
        return used && read->node > comparison.node && read->value.vacancy == dataflow::Vacancy::maybe;
    });
    return found == reads.end() ? nullptr : *found;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    std::unordered_set<dataflow::Key> settled;
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>()) {
        if (!semantics::is_order(comparison.operation)) continue;
        const bool left = comparison.right.constant().has_value();
        if (!left && !comparison.left.constant()) continue;
        const dataflow::Value& value = left ? comparison.left : comparison.right;
        const auto variable =
            queries::plain_variable(program, left ? comparison.left_expression : comparison.right_expression);
        if (!variable || !queries::may_hold_vacant(program, *variable) ||
            value.vacancy != dataflow::Vacancy::maybe || value.vacancy_origin == 0)
            continue;
        // Reported, or not used after this comparison, and so after no later one.
        if (!settled.insert(dataflow::key_of(*variable)).second) continue;
        const dataflow::Read* use = later_use(analysis, comparison, *variable);
        if (use == nullptr) continue;
        const Span span = program.expressions[comparison.expression].span;
        const std::string name = with_letter(analysis, *variable);
        Finding& finding =
            reporter.report({analysis, comparison}, span, "passes", {quoted(program, span), name});
        trace_vacancy(finding, analysis, value.vacancy_origin, name, comparison.node,
                      "a vacant " + name + " counts as 0");
        finding.related.push_back({analysis.source(), program.expressions[use->expression].span,
                                   name + " is used here and may still be vacant"});
    }
}

} // namespace
} // namespace maclint::rules
