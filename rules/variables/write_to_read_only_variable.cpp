//! MAC203: a value is stored where it can only be read.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/values/variable_numbers.hpp"
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule write_to_read_only_variable{
    .code = "MAC203",
    .name = "write-to-read-only-variable",
    .aliases = "DIN304 SIN205",
    .summary = "A value is stored in a variable that can only be read",
    .why = "The control owns the variable and tells its state by it: what is stored there is lost, or "
           "the control stops.",
    .severity = Severity::error,
    .severity_elsewhere = {{"dinplus", Severity::warning}},
    .precision = Precision::high,
    .messages = {{"cure", "Variable that can only be read: '{0}' holds {1}.",
                  "Store the value in a variable of your own, or program the function that sets it."},
                 {"number", "Variable that can only be read: '{0}' ({1}), and the control stops here.",
                  "Store the value in a variable of your own, or program the function that sets it."},
                 {"memory", "Variable that can only be read: '{0}' ({1}).",
                  "Store the value in a variable of your own, or program the function that sets it."}},
    .bad = {{"fanuc", R"nc(
O9203(SKIP)
G31 Z#26 F50.
#5063=#5063+#18
M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 #i21=0
N99 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9203(SKIP)
G31 Z#26 F50.
IF[#5063LE#26]GOTO9
#100=#5063+#18
#5221=#100
#1100=1
M99
N9 #3000=1(NO TOUCH)
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 #l1=#i21
N11 G4 F#l1
N99 M30
END
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "116", "WRITE PROTECTED VARIABLE", true, "number"},
               {"FANUC 30i/0i-D", "116", "WRITE PROTECTED VARIABLE", true, "number"},
               {"SINUMERIK", "17070", "data write-protected", false}},
    .sources = {"GH-ALM", "SEED-001:1337-1378", "IMD-IO", "SEED-003:19105-19387"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::read_only_variable, reporter);
    for (const Program& program : file.programs)
        for (const queries::NumberUse& use : queries::uses_of_numbers(program)) {
            if (!use.written || !use.is_protected() || !file.syntax_errors_in(use.span).empty()) continue;
            const bool is_certain = !queries::rests_on_memory(*use.range) && !file.control->alarms.empty();
            Finding& finding =
                reporter.report({file, use.span}, use.span, is_certain ? "number" : "memory",
                                {queries::spell_number(program, use.number), std::string(use.range->what)});
            if (!is_certain) finding.severity = Severity::warning;
            finding.same_cause = program.name + " " + std::to_string(use.number);
        }
}

} // namespace

} // namespace maclint::rules
