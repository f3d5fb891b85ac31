//! SIN701: a difference of rounded numbers is compared with 0.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/conditions/conditions.hpp"
#include "analyzer/queries/values/calculations.hpp"
#include "analyzer/queries/values/origins.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <span>

namespace maclint::rules {

namespace {
constexpr Exemption whole_number_asked_for;
void check(const ProgramAnalysis& analysis, Reporter& reporter);
} // namespace

extern const Rule difference_compared_with_zero{
    .code = "SIN701",
    .name = "difference-compared-with-zero",
    .summary = "A difference of numbers that have been rounded is compared with 0",
    .why = "The control takes two numbers for equal whose 12th digits differ: R1==R2 says what is meant. "
           "What is "
           "left of a difference is compared with 0, beside which nothing is small, and one wrong digit far "
           "behind "
           "the point decides.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Comparison, dataflow::Store>(),
    .data_flow = true,
    .messages =
        {{"plain",
          "Difference compared with 0: in '{0}' the last digit of '{1}' decides, which is rounded (line "
          "{2}).",
          "Compare the two with each other, or the ABS of the difference with a tolerance, as 0.001."}},
    .bad = {{"sinumerik", R"nc(
DEF REAL THIRD, STEP
THIRD=R10/3
STEP=R11/7
IF THIRD-STEP==0 GOTOF DONE
G0 X=THIRD
DONE: M30
)nc"}},
    .good = {{"sinumerik", R"nc(
DEF REAL THIRD, STEP
THIRD=R10/3
STEP=R11/7
IF THIRD==STEP GOTOF DONE
G0 X=THIRD
DONE: M30
)nc"}},
    .exemptions = {{&whole_number_asked_for,
                    "asks-for-a-whole-number",
                    "What TRUNC or ROUND make of a number is taken away from it: of counts that divide "
                    "without a rest nothing is left.",
                    {"sinumerik", R"nc(
R20=R20+1
IF R20/R21-TRUNC(R20/R21)==0 GOTOF DRESS
M17
DRESS: M30
)nc"}}},
    .sources = {"NCP19 p.444"},
    .check = &check,
};

namespace {

/// `R20/R21-TRUNC(R20/R21)`
bool asks_for_whole(const Program& program, std::span<const ExpressionId> operands) {
    const auto* made_whole = std::get_if<Apply>(&program.expressions[operands[1]].node);
    const bool is_made_whole = made_whole != nullptr && (made_whole->operation == Operation::truncate ||
                                                         made_whole->operation == Operation::round);
    return is_made_whole &&
           queries::same_expression(program, operands[0], program.operands_of(*made_whole).front());
}

/// The side that is a difference of rounded numbers, where the other one is 0; nullptr: there is none.
const dataflow::Value* difference_with_zero(const ProgramAnalysis& analysis,
                                            const dataflow::Comparison& comparison) {
    const auto is_rounded_difference = [&](ExpressionId id, const dataflow::Value& value) {
        const auto* apply = std::get_if<Apply>(&analysis.program().expressions[id].node);
        return apply != nullptr && apply->operation == Operation::subtract &&
               !(whole_number_asked_for.is_on() &&
                 asks_for_whole(analysis.program(), analysis.program().operands_of(*apply))) &&
               value.exactness == dataflow::Exactness::rounded && !queries::is_as_written(value) &&
               !queries::is_zero_as_on_paper(analysis, value);
    };
    if (comparison.right.constant() == 0.0 &&
        is_rounded_difference(comparison.left_expression, comparison.left))
        return &comparison.left;
    if (comparison.left.constant() == 0.0 &&
        is_rounded_difference(comparison.right_expression, comparison.right))
        return &comparison.right;
    return nullptr;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>()) {
        if (comparison.operation != Operation::equal && comparison.operation != Operation::not_equal)
            continue;
        const dataflow::Value* difference = difference_with_zero(analysis, comparison);
        if (difference == nullptr) continue;
        const ExpressionId side =
            difference == &comparison.left ? comparison.left_expression : comparison.right_expression;
        const Span span = program.expressions[comparison.expression].span;
        const Span rounded = queries::span_of_origin(analysis, difference->rounding);
        Finding& finding =
            reporter.report({analysis, comparison}, span, "plain",
                            {quoted(program, span), quoted(program, program.expressions[side].span),
                             line_number(analysis.file(), rounded.begin)});
        trace(finding, analysis, difference->rounding, "the result is rounded here", comparison.node,
              "and compared here");
    }
}

} // namespace
} // namespace maclint::rules
