//! MAC233: the value of an offset picks a variable, and its number was meant; or the other way round.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/variables/value_for_number_finder.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule value_for_number{
    .code = "MAC233",
    .name = "value-for-number",
    .summary = "An index adds the value of an offset where the number of the first one is meant, or takes a "
               "variable from the number of one whose value is meant",
    .why =
        "#[2400+#7] is offset #7 counted from #2400. With one # more the control adds what #2400 holds, some "
        "millimetres, and reads whatever variable has that number.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::vacancy},
    .messages =
        {{"value", "Value for a number: '{0}' adds what {1} holds, and picks a variable by that.",
          "Write {2} without its #."},
         {"number", "Number for a value: '#{0}' is the variable whose number is {1} less {2}, and no length.",
          "Write the difference of {3} and {2}, the # inside of the bracket."},
         {"stored", "Number for a value: {0} holds the number of a variable, and is added up as a length.",
          "Write #[{1}], or #[…] around the sum that picks the variable."},
         {"limit", "Number for a value: '{0}' compares {1}, which holds the number of a variable, with {2}.",
          "Compare what that variable holds, #[{1}]."},
         {"compared", "Numbers for values: '{0}' compares two numbers of variables, always alike.",
          "Compare what the variables hold, #[…] on both sides."}},
    .bad = {{"fanuc", R"nc(
O9233(LENGTH OF TOOL D)
IF[#7LT1]GOTO9
IF[#7GT50]GOTO9
G0 Z#[#2000+#7]
M99
N9 #3000=1(D)
)nc"},
            {"fanuc", R"nc(
O9233(CORNER OF RADIUS R)
IF[#18LE0]GOTO9
#31=#18/4
G91 G1 X-#[18-#31] F200.
G90
M99
N9 #3000=1(R)
)nc"}},
    .good = {{"fanuc", R"nc(
O9233(LENGTH OF TOOL D)
IF[#7LT1]GOTO9
IF[#7GT50]GOTO9
G0 Z#[2000+#7]
M99
N9 #3000=1(D)
)nc"}},
    .sources = {"T"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const ValueForNumber& found : find_values_for_numbers(program)) {
        const Span span = program.expressions[found.index].span;
        const std::string value = quoted(program, program.expressions[found.value].span);
        reporter.report({analysis, span}, span, "value", {quoted(program, span), value, value});
    }
    for (const ExpressionId id : find_numbers_compared(program)) {
        const Span span = program.expressions[id].span;
        reporter.report({analysis, span}, span, "compared", {quoted(program, span)});
    }
    for (const NumberAgainstLimit& found : find_numbers_against_limits(program)) {
        const Span span = program.expressions[found.comparison].span;
        reporter.report({analysis, span}, span, "limit",
                        {quoted(program, span), quoted(program, program.expressions[found.number].span),
                         quoted(program, program.expressions[found.limit].span)});
    }
    for (const ExpressionId id : find_numbers_stored(program)) {
        const Span span = program.expressions[id].span;
        const std::string number = quoted(program, span);
        reporter.report({analysis, span}, span, "stored", {number, number});
    }
    for (const NumberForValue& found : find_numbers_for_values(program)) {
        const Span span = program.expressions[found.index].span;
        Finding& finding = reporter.report({analysis, span}, span, "number",
                                           {quoted(program, span), std::to_string(found.first.number),
                                            quoted(program, program.expressions[found.second].span),
                                            program.spell(found.first)});
        finding.severity = Severity::note;
    }
}

} // namespace
} // namespace maclint::rules
