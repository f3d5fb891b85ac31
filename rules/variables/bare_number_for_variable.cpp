//! MAC229: a number is compared that is meant as a variable.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);

constexpr Exemption meant_to_hold;
} // namespace

extern const Rule bare_number_for_variable{
    .code = "MAC229",
    .name = "bare-number-for-variable",
    .summary = "A condition compares two numbers, one of which is a variable's without its #",
    .why = "The comparison has the same result whatever the variable holds: a check never stops the program, "
           "or always does.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::vacancy},
    .facts = dataflow::facts<dataflow::Comparison>(),
    .messages = {{"used", "Number for a variable: '{0}' compares the number {1}, and other blocks say #{1}.",
                  "Write #{1}."},
                 {"system",
                  "Number for a variable: '{0}' compares the number {1}, and #{1} is a variable of "
                  "the control.",
                  "Write #{1}."}},
    .bad = {{"fanuc", R"nc(
O9229(ONLY UNDER G56)
IF[4012EQ56]GOTO5
#3000=1(G56 WANTED)
N5 G0 X10.
M99
)nc"},
            {"fanuc", R"nc(
O9229(COUNT)
#500=#500+1
IF[500LT20]GOTO5
#3000=2(NEW TOOL)
N5 M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9229(ONLY UNDER G56)
IF[#4012EQ56]GOTO5
#3000=1(G56 WANTED)
N5 G0 X10.
WHILE[1EQ1]DO1
IF[#1000EQ1]GOTO9
END1
N9 M99
)nc"}},
    .exemptions = {{&meant_to_hold,
                    "number-with-itself",
                    "A number is compared with itself: the condition is meant to be always true.",
                    {"fanuc", R"nc(
O9229(SLOT, A)
WHILE[1EQ1]DO1
G91 G1 X#1 F100.
IF[#5041GT100.]GOTO9
END1
N9 M99
)nc"}}},
    .sources = {"T"},
    .check = &check,
};

namespace {

/// The whole number that the expression is, and that a variable can have.
std::optional<std::int64_t> number_in(const Program& program, ExpressionId id) {
    const auto* literal = std::get_if<Literal>(&program.expressions[id].node);
    constexpr double most = 1e6;
    if (literal == nullptr || literal->value < 1 || literal->value > most ||
        literal->value != std::floor(literal->value) || literal->decimal_point)
        return std::nullopt;
    return static_cast<std::int64_t>(literal->value);
}

bool says_variable(std::string_view text, const std::string& written) {
    for (std::size_t at = text.find(written); at != std::string_view::npos; at = text.find(written, at + 1)) {
        const std::size_t end = at + written.size();
        if (end == text.size() || text[end] < '0' || text[end] > '9') return true;
    }
    return false;
}

bool is_of_the_control(const ControlModel& control, std::int64_t number) {
    return std::ranges::any_of(control.families, [&](const VariableFamily& family) {
        const VariableRange* range = family.find(number);
        return range != nullptr && (range->meaning == Meaning::modal || range->meaning == Meaning::machine);
    });
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const auto is_literal = [&](ExpressionId id) {
        return std::holds_alternative<Literal>(program.expressions[id].node);
    };
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>()) {
        if (!is_literal(comparison.left_expression) || !is_literal(comparison.right_expression)) continue;
        const auto left = number_in(program, comparison.left_expression);
        const auto right = number_in(program, comparison.right_expression);
        if (meant_to_hold.is_on() && left == right) continue; // [1000EQ1000] is meant to be true
        const std::string_view text = program.text.substr(program.span.begin, program.span.length());
        for (const auto& number : {left, right}) {
            if (!number) continue;
            const bool used = says_variable(text, "#" + std::to_string(*number));
            if (!used && !is_of_the_control(analysis.control(), *number)) continue;
            const Span span = program.expressions[comparison.expression].span;
            reporter.report({analysis, comparison}, span, used ? "used" : "system",
                            {quoted(program, span), std::to_string(*number)});
            break;
        }
    }
}

} // namespace
} // namespace maclint::rules
