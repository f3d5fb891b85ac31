//! MAC710: EQ or NE between numbers that rounding has touched.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/numbers/inexact_counter.hpp"
#include "rules/numbers/inexact_sum.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule float_equality{
    .code = "MAC710",
    .name = "float-equality",
    .aliases = "DIN327",
    .summary = "A result that has been rounded is compared with EQ or NE: 0.002*1000 need not be "
               "2",
    .why = "The comparison fails although both numbers look the same on the display: the last "
           "pass is left out, or the loop goes on.",
    .severity = Severity::warning,
    .severity_elsewhere = {{"dinplus", Severity::note}},
    .precision = Precision::high,
    .data_flow = true,
    .messages = {{"equal",
                  "'{0}' may be false for numbers that are equal on paper: '{1}' is rounded. Compare "
                  "the distance instead: whether its ABS is less than 0.001."},
                 {"not-equal",
                  "'{0}' may be true for numbers that are equal on paper: '{1}' is rounded. Compare "
                  "the distance instead: whether its ABS is 0.001 or more."},
                 {"sum-equal",
                  "'{0}' may be false when the steps added to {1} have decimals: ten steps of 0.1 are not 1. "
                  "Compare the distance instead: whether its ABS is less than 0.001."},
                 {"sum-not-equal",
                  "'{0}' may stay true for ever when the steps added to {1} have decimals: ten steps of "
                  "0.1 are not 1. Compare the distance instead: whether its ABS is 0.001 or more."}},
    .bad = {{"fanuc", R"nc(
O9710(HALF A TURN, A ANGLE)
#33=#1/3
IF[#33EQ60]GOTO9
G90 G0 X#33
N9 M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 INPUT("Taper",#l1)
N20 #l3=#l1/7
N30 IF #l3==1.2
N40 THEN
N50 PRINT("Steep taper")
N60 ENDIF
N70 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9710(HALF A TURN, A ANGLE)
#33=#1/3
IF[ABS[#33-60]LT0.001]GOTO9
G90 G0 X#33
N9 M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 INPUT("Taper",#l1)
N20 #l3=#l1/7
N30 IF ABS(#l3-1.2)<0.001
N40 THEN
N50 PRINT("Steep taper")
N60 ENDIF
N70 M30
END
)nc"}},
    .sources = {"SEED-001:306-314", "HAAS-LA", "MITSU-326"},
    .check = &check,
};

namespace {

using dataflow::Value;

/// The symbol of the operand when the value is FIX, FUP or ROUND of something.
std::optional<dataflow::SymbolId> rounded_operand(const ProgramAnalysis& analysis, const Value& value) {
    const dataflow::Symbol& symbol = analysis.data().table().symbols[value.symbol];
    if (symbol.kind != dataflow::Symbol::Kind::result) return std::nullopt;
    const auto operation = static_cast<Operation>(symbol.a);
    const bool rounds =
        operation == Operation::truncate || operation == Operation::round || operation == Operation::round_up;
    return rounds ? std::optional(symbol.b) : std::nullopt;
}

/// Whether a number is whole: x EQ FIX[x].
bool asks_for_whole(const ProgramAnalysis& analysis, const Value& left, const Value& right) {
    return rounded_operand(analysis, left) == right.symbol || rounded_operand(analysis, right) == left.symbol;
}

/// Products and quotients are 0 exactly when an operand is.
bool is_safe_against_zero(const ProgramAnalysis& analysis, const Value& value, const Value& zero) {
    if (zero.constant() != 0.0) return false;
    const dataflow::Symbol& symbol = analysis.data().table().symbols[value.symbol];
    if (symbol.kind != dataflow::Symbol::Kind::result) return false;
    const auto operation = static_cast<Operation>(symbol.a);
    return operation == Operation::multiply || operation == Operation::divide;
}

/// Some assignment copies the very value that is compared with: IF[#14GT#2]THEN#14=#2 … IF[#14EQ#2].
bool is_copied_into(const ProgramAnalysis& analysis, ExpressionId expression, const Value& other) {
    const auto* load = std::get_if<Load>(&analysis.program().expressions[expression].node);
    return load != nullptr &&
           std::ranges::any_of(analysis.facts().all<dataflow::Store>(), [&](const dataflow::Store& store) {
               return store.variable == load->variable && store.value.symbol == other.symbol;
           });
}

bool is_harmless(const ProgramAnalysis& analysis, const dataflow::Comparison& c) {
    return c.left.symbol == c.right.symbol || asks_for_whole(analysis, c.left, c.right) ||
           is_safe_against_zero(analysis, c.left, c.right) ||
           is_safe_against_zero(analysis, c.right, c.left) ||
           is_copied_into(analysis, c.left_expression, c.right) ||
           is_copied_into(analysis, c.right_expression, c.left);
}

/// What makes a side of the comparison inexact.
struct Inexact {
    ExpressionId side;
    dataflow::OriginId rounding; ///< where it was rounded; 0: summed up by `sum`
    const dataflow::Store* sum;
};

std::optional<Inexact> inexact_side(const ProgramAnalysis& analysis, const Sums& sums,
                                    const dataflow::Comparison& comparison) {
    if (comparison.left.exactness == dataflow::Exactness::rounded)
        return Inexact{comparison.left_expression, comparison.left.rounding, nullptr};
    if (comparison.right.exactness == dataflow::Exactness::rounded)
        return Inexact{comparison.right_expression, comparison.right.rounding, nullptr};
    for (const ExpressionId side : {comparison.left_expression, comparison.right_expression})
        if (const dataflow::Store* sum = sum_in(analysis, sums, side)) return Inexact{side, 0, sum};
    return std::nullopt;
}

void report(const ProgramAnalysis& analysis, Reporter& reporter, const dataflow::Comparison& comparison,
            const Inexact& inexact) {
    const Program& program = analysis.program();
    const Span span = program.expressions[comparison.expression].span;
    const std::string side = quoted(program, program.expressions[inexact.side].span);
    const bool equal = comparison.operation == Operation::equal;
    if (inexact.sum == nullptr) {
        Finding& finding = reporter.report({analysis, comparison}, span, equal ? "equal" : "not-equal",
                                           {quoted(program, span), side});
        trace(finding, analysis, inexact.rounding, "the result is rounded here", comparison.node,
              "and compared here");
        return;
    }
    Finding& finding = reporter.report({analysis, comparison}, span, equal ? "sum-equal" : "sum-not-equal",
                                       {quoted(program, span), side});
    trace(finding, analysis, inexact.sum->node,
          related_at_effect(analysis, inexact.sum->effect, "a step is added in every pass"), comparison.node,
          "and the sum is compared here");
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const std::vector<InexactCounter> counters = find_inexact_counters(analysis);
    const Sums sums = find_sums(analysis);
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>()) {
        if (comparison.operation != Operation::equal && comparison.operation != Operation::not_equal)
            continue;
        const auto inexact = inexact_side(analysis, sums, comparison);
        if (!inexact || is_harmless(analysis, comparison) || decides(counters, comparison)) continue;
        report(analysis, reporter, comparison, *inexact);
    }
}

} // namespace
} // namespace maclint::rules
