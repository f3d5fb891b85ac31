//! MAC222: the result of arithmetic is tested for vacancy, which it never is.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule vacancy_lost_in_arithmetic{
    .code = "MAC222",
    .name = "vacancy-lost-in-arithmetic",
    .summary = "The result of arithmetic is compared with #0: it is a number, never vacant",
    .why =
        "Arithmetic takes a vacant variable for 0. The test for a missing argument therefore never finds it "
        "missing, and the macro runs with 0.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::vacancy},
    .facts = dataflow::facts<dataflow::Comparison>(),
    .data_flow = true,
    .messages =
        {{"never-vacant",
          "Vacancy test of a calculated value: '{0}' is never true, because '{1}' comes from arithmetic, "
          "which takes vacant for 0.",
          "Write EQ 0 if zero was meant, or test the variable itself with EQ #0 before the calculation."},
         {"always-set",
          "Vacancy test of a calculated value: '{0}' is always true, because '{1}' comes from arithmetic, "
          "which takes vacant for 0.",
          "Write NE 0 if zero was meant, or test the variable itself with NE #0 before the calculation."}},
    .bad = {{"fanuc", R"nc(
O9222(FACE, K DEPTH)
IF[[#6*1]EQ#0]GOTO9
G90 G1 Z-#6
M99
N9 #3000=1(K MISSING)
)nc"}},
    .good = {{"fanuc", R"nc(
O9222(FACE, K DEPTH)
IF[#6EQ#0]GOTO9
G90 G1 Z-#6
M99
N9 #3000=1(K MISSING)
)nc"}},
    .sources = {"MITSU-326", "NCT-173"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>()) {
        const bool vacant = comparison.operation == Operation::is_vacant;
        if (!vacant && comparison.operation != Operation::is_set) continue;
        const Expression& operand = program.expressions[comparison.left_expression];
        const auto* apply = std::get_if<Apply>(&operand.node);
        if (apply == nullptr || apply->operation == Operation::unknown) continue;
        const Span span = program.expressions[comparison.expression].span;
        Finding& finding =
            reporter.report({analysis, comparison}, span, vacant ? "never-vacant" : "always-set",
                            {quoted(program, span), quoted(program, operand.span)});
        trace(finding, analysis, comparison.node, "the result of arithmetic is tested for vacancy");
    }
}

} // namespace
} // namespace maclint::rules
