//! MAC229: a number stands where a variable is meant.
#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/fixes.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/variables/bare_number_for_variable_finder.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);

constexpr Exemption meant_to_hold;
} // namespace

extern const Rule bare_number_for_variable{
    .code = "MAC229",
    .name = "bare-number-for-variable",
    .summary = "A number stands where the variable of that number is meant: its # is missing",
    .why =
        "A comparison has the same result whatever the variable holds: a check never stops the program, or "
        "always does. A word gets the number itself: X18 moves to 0.018, F[517] feeds at 517.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::vacancy},
    .facts = dataflow::facts<dataflow::Comparison>(),
    .messages = {{"used", "Number for a variable: '{0}' compares the number {1}, and other blocks say #{1}.",
                  "Write #{1}."},
                 {"system",
                  "Number for a variable: '{0}' compares the number {1}, and #{1} is a variable of "
                  "the control.",
                  "Write #{1}."},
                 {"bracket", "Number for a variable: '{0}' is the number {1}, and other blocks say #{1}.",
                  "Write [#{1}]."},
                 {"set-in-vain",
                  "Number for a variable: '{0}' is a number here, and #{1}, which the program {4}, is read "
                  "nowhere.",
                  "Write #{1}."},
                 {"sibling", "Number for a variable: '{0}' is the number {1}, and line {2} has '{3}'.",
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
)nc"},
            {"fanuc", R"nc(
O0229(PROBE)
#517=50.
G65 P9229 X30. F[#517]
G65 P9229 X-30. F[517]
M30
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

bool is_of_the_control(const ControlModel& control, std::int64_t number) {
    return std::ranges::any_of(control.families, [&](const VariableFamily& family) {
        const VariableRange* range = family.find(number);
        return range != nullptr && (range->meaning == Meaning::modal || range->meaning == Meaning::machine);
    });
}

bool is_argument(const Program& program, std::int64_t number) {
    return std::ranges::any_of(program.control->formals,
                               [&](Variable formal) { return formal.number == number; });
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    const auto is_literal = [&](ExpressionId id) {
        return std::holds_alternative<Literal>(program.expressions[id].node);
    };
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>()) {
        if (!is_literal(comparison.left_expression) || !is_literal(comparison.right_expression)) continue;
        const auto left = number_of_a_variable(program, comparison.left_expression);
        const auto right = number_of_a_variable(program, comparison.right_expression);
        if (meant_to_hold.is_on() && left == right) continue; // [1000EQ1000] is meant to be true
        for (const auto& number : {left, right}) {
            if (!number) continue;
            const bool used = names_variable(program, *number);
            if (!used && !is_of_the_control(analysis.control(), *number)) continue;
            const Span span = program.expressions[comparison.expression].span;
            Finding& finding = reporter.report({analysis, comparison}, span, used ? "used" : "system",
                                               {quoted(program, span), std::to_string(*number)});
            const ExpressionId literal =
                number == left ? comparison.left_expression : comparison.right_expression;
            offer_text(finding, Applicability::unsafe, program.expressions[literal].span,
                       "#" + std::to_string(*number));
            break;
        }
    }
    for (const BareNumber& bare : find_bare_numbers(program)) {
        Finding& finding =
            reporter.report({analysis, bare.span}, bare.span,
                            bare.is_set_in_vain    ? "set-in-vain"
                            : bare.sibling.empty() ? "bracket"
                                                   : "sibling",
                            {quoted(program, bare.span), std::to_string(bare.number),
                             line_number(analysis.file(), bare.sibling.begin), quoted(program, bare.sibling),
                             is_argument(program, bare.number) ? "asks for" : "sets"});
        if (!bare.sibling.empty())
            finding.related.push_back({analysis.source(), bare.sibling, "the variable stands here"});
    }
}

} // namespace
} // namespace maclint::rules
