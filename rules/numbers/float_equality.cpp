//! MAC710: EQ or NE between numbers that rounding has touched.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/numbers/inexact_counter.hpp"
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
               "2.",
    .why = "The comparison fails although both numbers look the same on the display: the last "
           "pass is left out, or the loop goes on.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = true,
    .messages = {{"equal", "'{0}' may fail for numbers that are equal on paper: '{1}' is rounded. Compare "
                           "the distance instead: IF[ABS[...]LT0.001]."},
                 {"not-equal",
                  "'{0}' may hold for numbers that are equal on paper: '{1}' is rounded. Compare "
                  "the distance instead: IF[ABS[...]GE0.001]."}},
    .bad = {{"fanuc", "O9710(HALF A TURN, A ANGLE)\n"
                      "#33=#1/3\n"
                      "IF[#33EQ60]GOTO9\n"
                      "G90 G0 X#33\n"
                      "N9 M99\n"}},
    .also = {},
    .good = {{"fanuc", "O9710(HALF A TURN, A ANGLE)\n"
                       "#33=#1/3\n"
                       "IF[ABS[#33-60]LT0.001]GOTO9\n"
                       "G90 G0 X#33\n"
                       "N9 M99\n"}},
    .alarms = {},
    .sources = {"SEED-001:306-314", "HAAS-LA", "MITSU-326"},
    .check = &check,
};

namespace {

using dataflow::Value;

/// The symbol of the operand when the value is FIX, FUP or ROUND of something.
std::optional<dataflow::SymbolId> rounded_operand(const ProgramAnalysis& analysis, const Value& value) {
    const dataflow::Symbol& symbol = analysis.data().pool().symbols[value.symbol];
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
    const dataflow::Symbol& symbol = analysis.data().pool().symbols[value.symbol];
    if (symbol.kind != dataflow::Symbol::Kind::result) return false;
    const auto operation = static_cast<Operation>(symbol.a);
    return operation == Operation::multiply || operation == Operation::divide;
}

/// Some assignment copies the very value that is compared with: IF[#14GT#2]THEN#14=#2 … IF[#14EQ#2].
bool is_copied_into(const ProgramAnalysis& analysis, ExpressionId expression, const Value& other) {
    const auto* load = std::get_if<Load>(&analysis.program().expressions[expression].node);
    return load != nullptr && std::ranges::any_of(analysis.facts().stores, [&](const dataflow::Store& store) {
               return store.place == load->place && store.value.symbol == other.symbol;
           });
}

bool is_harmless(const ProgramAnalysis& analysis, const dataflow::Comparison& c) {
    return c.left.symbol == c.right.symbol || asks_for_whole(analysis, c.left, c.right) ||
           is_safe_against_zero(analysis, c.left, c.right) ||
           is_safe_against_zero(analysis, c.right, c.left) ||
           is_copied_into(analysis, c.left_expression, c.right) ||
           is_copied_into(analysis, c.right_expression, c.left);
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const std::vector<InexactCounter> counters = find_inexact_counters(analysis);
    for (const dataflow::Comparison& comparison : analysis.facts().comparisons) {
        if (comparison.operation != Operation::equal && comparison.operation != Operation::not_equal)
            continue;
        const bool left = comparison.left.exactness == dataflow::Exactness::rounded;
        if (!left && comparison.right.exactness != dataflow::Exactness::rounded) continue;
        if (is_harmless(analysis, comparison) || decides(counters, comparison)) continue;
        const Value& value = left ? comparison.left : comparison.right;
        const Span span = program.expressions[comparison.expression].span;
        const Span side =
            program.expressions[left ? comparison.left_expression : comparison.right_expression].span;
        Finding& finding = reporter.report(analysis.file(), span,
                                           comparison.operation == Operation::equal ? "equal" : "not-equal",
                                           {quoted(program, span), quoted(program, side)});
        trace(finding, analysis, value.rounding, "the result is rounded here", comparison.node,
              "and compared here");
    }
}

} // namespace
} // namespace maclint::rules
