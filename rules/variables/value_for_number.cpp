//! MAC233: the value of an offset picks a variable, and its number was meant.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/variables/value_for_number_finder.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule value_for_number{
    .code = "MAC233",
    .name = "value-for-number",
    .summary = "An index adds the value of an offset where the number of the first one is meant",
    .why =
        "#[2400+#7] is offset #7 counted from #2400. With one # more the control adds what #2400 holds, some "
        "millimetres, and reads whatever variable has that number.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::vacancy},
    .messages = {{"value", "Value for a number: '{0}' adds what {1} holds, and picks a variable by that.",
                  "Write {2} without its #."}},
    .bad = {{"fanuc", R"nc(
O9233(LENGTH OF TOOL D)
IF[#7LT1]GOTO9
IF[#7GT50]GOTO9
G0 Z#[#2000+#7]
M99
N9 #3000=1(D)
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
}

} // namespace
} // namespace maclint::rules
