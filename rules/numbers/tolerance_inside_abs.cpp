//! MAC727: a tolerance that stands inside the ABS of a difference.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <cmath>
#include <optional>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule tolerance_inside_abs{
    .code = "MAC727",
    .name = "tolerance-inside-abs",
    .summary = "A tolerance is taken from a difference before its amount is taken",
    .why = "ABS[a-b-0.01] is no distance with a tolerance: on one side of b the limit is 0.01 nearer, on the "
           "other "
           "0.01 farther. A check that is to take a small error takes it in one direction, and stops in the "
           "other.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::Comparison>(),
    .messages = {{"plain",
                  "Tolerance inside ABS: '{0}' shifts the difference by {1} before its amount is taken, so "
                  "the limit is "
                  "another on each side.",
                  "Add it to the amount, or to what that is compared with."}},
    .bad = {{"fanuc", R"nc(
O0727(CHECK THE WAY)
#32=#5001
G91 G31 X20. F50.
G90
G53
IF[ABS[#5001-#32-.001]LT20.]GOTO803
M30
N803 #3000=3(HIT TOO EARLY)
)nc"}},
    .good = {{"fanuc", R"nc(
O0727(CHECK THE WAY)
#32=#5001
G91 G31 X20. F50.
G90
G53
IF[[ABS[#5001-#32]+.001]LT20.]GOTO803
IF[ABS[#5001-#32-2.5]LT.1]GOTO803
M30
N803 #3000=3(HIT TOO EARLY)
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

const Apply* applied(const Program& program, ExpressionId id, Operation operation) {
    const auto* apply = std::get_if<Apply>(&program.expressions[id].node);
    return apply != nullptr && apply->operation == operation ? apply : nullptr;
}

/// A number so small that nobody means a place by it: a hundredth of a millimetre, a thousandth of an inch.
bool is_tolerance(const Program& program, ExpressionId id) {
    constexpr double greatest = 0.02;
    const auto* literal = std::get_if<Literal>(&program.expressions[id].node);
    return literal != nullptr && literal->value != 0 && std::abs(literal->value) <= greatest;
}

/// The tolerance of `ABS[a-b-0.01]` or `ABS[a-b+0.01]`; nothing for anything else.
std::optional<ExpressionId> tolerance_in(const Program& program, ExpressionId id) {
    const Apply* absolute = applied(program, id, Operation::absolute);
    if (absolute == nullptr) return std::nullopt;
    const ExpressionId inside = program.operands_of(*absolute).front();
    for (const Operation operation : {Operation::subtract, Operation::add}) {
        const Apply* outer = applied(program, inside, operation);
        if (outer == nullptr) continue;
        const ExpressionId difference = program.operands_of(*outer)[0], last = program.operands_of(*outer)[1];
        if (applied(program, difference, Operation::subtract) != nullptr && is_tolerance(program, last))
            return last;
    }
    return std::nullopt;
}

bool is_relational(Operation operation) {
    return operation == Operation::less || operation == Operation::less_equal ||
           operation == Operation::greater || operation == Operation::greater_equal;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>()) {
        if (!is_relational(comparison.operation)) continue;
        for (const ExpressionId side : {comparison.left_expression, comparison.right_expression}) {
            const auto tolerance = tolerance_in(program, side);
            if (!tolerance) continue;
            const Span span = program.expressions[side].span;
            reporter.report({analysis, comparison.effect, side}, span, "plain",
                            {quoted(program, span), quoted(program, program.expressions[*tolerance].span)});
        }
    }
}

} // namespace
} // namespace maclint::rules
