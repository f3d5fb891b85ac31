//! MAC231: a variable is read that exists to be written.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/values/variable_numbers.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule read_of_write_only_variable{
    .code = "MAC231",
    .name = "read-of-write-only-variable",
    .summary = "A variable is read that can only be written",
    .why = "What is stored in #3000 or #3006 stops the program, and nothing is kept there. Newer controls "
           "stop with "
           "an alarm where it is read.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .messages = {{"plain", "Variable that can only be written: '{0}' ({1}) has no value to read.",
                  "Read the variable that decided what was stored there."}},
    .bad = {{"fanuc", R"nc(
O9231(AGAIN)
IF[#3006EQ1]GOTO9
#3006=1(TURN THE PART)
N9 M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9231(AGAIN)
IF[#500EQ1]GOTO9
#500=1
#3006=1(TURN THE PART)
N9 M99
)nc"}},
    .alarms = {{"FANUC 30i/0i-D", "1115", "READ PROTECTED VARIABLE"}},
    .sources = {"GH-ALM"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    for (const Program& program : file.programs)
        for (const queries::NumberUse& use : queries::uses_of_numbers(program)) {
            if (use.written || !use.is_write_only()) continue;
            Finding& finding =
                reporter.report({file, use.span}, use.span, "plain",
                                {queries::spell_number(program, use.number), std::string(use.range->what)});
            // The older lists have no such alarm.
            if (finding.alarm.empty()) finding.severity = std::min(finding.severity, Severity::warning);
            finding.same_cause = program.name + " " + std::to_string(use.number);
        }
}

} // namespace
} // namespace maclint::rules
