//! MAC228: a variable that every path to the test has set is tested for vacancy.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/queries/vacancy/unset_reads.hpp"
#include "analyzer/queries/values/argument_names.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"
#include "rules/variables/vacancy_test_never_true_finder.hpp"

#include <utility>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule vacancy_test_never_true{
    .code = "MAC228",
    .name = "vacancy-test-never-true",
    .summary = "A variable that is set on every path to the test is compared with #0: it is never vacant",
    .why = "A test for 0 was probably meant. As it stands, what the test guards never runs, or always does.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::vacancy},
    .yields_to = "MAC718",
    .facts = dataflow::facts<dataflow::Comparison, dataflow::Store>(),
    .data_flow = true,
    .messages =
        {{"set",
          "Test of a variable that is never vacant: '{0}' is {1} true, because every path sets {2} (line "
          "{3}).",
          "Compare it with 0 if the value 0 is meant."},
         {"overwritten",
          "Test of an overwritten variable: '{0}' is {1} true, because {2} got another value on line {3}.",
          "Test the value from the call before that."},
         {"kept",
          "Test of an overwritten variable: '{0}' is {1} true, because {2} got another value on line {3}.",
          "Its value from the call is in {4}: test that."}},
    .bad = {{"fanuc", R"nc(
O9228(DRILL, Z DEPTH)
#33=#26
#26=#5003-#26
G90 G1 Z#26
IF[#26EQ#0]GOTO9
G0 Z#33
M99
N9 #3000=1(Z MISSING)
)nc"},
            {"fanuc", R"nc(
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
)nc"},
             {"fanuc", R"nc(
O9228(VALUE OF THE MACHINE BUILDER)
#24=#900018
IF[#24EQ#0]GOTO9
G90 G0 X#24
N9 M99
)nc"}},
    .exemptions = {{&exemptions::zero_made_sure,
                    "zero-made-sure",
                    "All that the test guards is to set the variable to 0: it makes sure, whether that is "
                    "needed or not.",
                    {"fanuc", R"nc(
O9228(WEB, Z)
#6=FUP[#26]
IF[#6EQ#0]THEN#6=0
G90 G0 Z#6
M99
)nc"}}},
    .sources = {"SEED-001:415", "MITSU-326"},
    .check = &check,
};

namespace {

/// What callers may have passed in it was meant, not what it was overwritten with. A test that makes no
/// difference, and one of a variable that no call sets, are not worth more than a note.
bool is_defect(const ProgramAnalysis& analysis, const dataflow::Comparison& comparison, Variable variable) {
    return analysis.control().spaces[variable.space].scope == Scope::frame &&
           !is_harmless_guard(analysis, comparison, variable);
}

void report(const ProgramAnalysis& analysis, Reporter& reporter, const dataflow::Comparison& comparison,
            Variable variable, KeptArguments& kept) {
    const Program& program = analysis.program();
    const Span span = program.expressions[comparison.expression].span;
    const dataflow::Store* store = last_store_before(analysis, variable, comparison.node);
    const Span set = store == nullptr ? span : program.effects[store->effect].span;
    std::vector<std::string> words{
        quoted(program, span), comparison.operation == Operation::is_vacant ? "never" : "always",
        queries::with_letter(program, variable), line_number(analysis.file(), set.begin)};
    std::string_view id = program.control->letter_of(variable) ? "overwritten" : "set";
    const auto keeper = kept.keeper_of(variable, comparison.node);
    if (keeper) {
        words.push_back(program.spell(*keeper));
        id = "kept";
    }
    Finding& finding = reporter.report({analysis, comparison}, span, id, std::move(words));
    if (!keeper && !is_defect(analysis, comparison, variable)) finding.severity = Severity::note;
    const std::string name = program.spell(variable), ends = name + " is tested for vacancy";
    if (store != nullptr)
        trace(finding, analysis, store->node, {analysis.source(), set, name + " is set"}, comparison.node,
              ends);
    else
        trace(finding, analysis, comparison.node, ends);
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    queries::WithoutAssignment unset(analysis);
    KeptArguments kept(analysis);
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>()) {
        if (!semantics::is_vacancy_test(comparison.operation)) continue;
        if (comparison.left.vacancy != dataflow::Vacancy::set) continue;
        const auto variable = queries::plain_variable(analysis.program(), comparison.left_expression);
        if (variable && queries::may_hold_vacant(analysis.program(), *variable) &&
            !unset.leads_to(*variable, comparison.node) && !sets_zero(analysis, comparison, *variable))
            report(analysis, reporter, comparison, *variable, kept);
    }
}

} // namespace
} // namespace maclint::rules
