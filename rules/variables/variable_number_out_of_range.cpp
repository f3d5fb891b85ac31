//! MAC202: a variable that the control does not have.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/values/variable_numbers.hpp"
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

#include <algorithm>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule variable_number_out_of_range{
    .code = "MAC202",
    .name = "variable-number-out-of-range",
    .aliases = "DIN302",
    .summary = "There is no variable of this number",
    .why = "The control has a fixed set of variables, and stops at any other. Often a figure too many "
           "was typed.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"cure", "Variable that does not exist: '{0}', and the control stops here.",
                  "Use one of those that there are: {1}."},
                 {"plain", "Variable that does not exist: '{0}', and the control stops here.",
                  "Use a letter of the language, as in #l1, #c1, #g1 or #x1."},
                 {"unknown", "Variable that no manual lists: '{0}'.",
                  "Use one of those that are listed: {1}."},
                 {"number", "Variable that does not exist: the control has no '{0}', and stops here.",
                  "Correct its number."},
                 {"system", "Variable that does not exist: no list of system variables holds '{0}'.",
                  "Correct its number."},
                 {"assumed", "Variable that does not exist: no FANUC or Haas has '{0}'.",
                  "If the program is for another control, name that.", true}},
    .bad = {{"fanuc", R"nc(
O9202(STATE)
IF[#4611EQ50]GOTO8
#3000=121(WRONG OFFSET)
N8 M99
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 #l100=5
N11 G0 X#l100 Z2
N99 M30
END
)nc"}},
    .good = {{"fanuc", R"nc(
O9202(STATE)
IF[#4111NE50]GOTO8
#133=#4109
#533=#133
N8 M99
)nc"},
             {"dinplus", R"nc(
MACHINING
N10 #l10=5
N11 G0 X#l10 Z2
N99 M30
END
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "115", "ILLEGAL VARIABLE NUMBER", true, "number"},
               {"FANUC 30i/0i-D", "115", "VARIABLE NO. OUT OF RANGE", true, "number"}},
    .sources = {"SEED-001:157-163", "SEED-001:1337-1367", "MITSU-389", "SEED-003:18946-18959",
                "SEED-003:19032-19387"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    report_syntax_error(file, SyntaxErrorKind::unknown_variable, reporter);
    for (const Program& program : file.programs)
        for (const queries::NumberUse& use : queries::uses_of_numbers(program)) {
            if (!use.is_absent() || !file.syntax_errors_in(use.span).empty()) continue;
            const bool is_listed = use.range == nullptr || !queries::rests_on_memory(*use.range);
            const std::string_view message = !is_listed              ? "system"
                                             : file.control->assumed ? "assumed"
                                                                     : "number";
            Finding& finding = reporter.report({file, use.span}, use.span, message,
                                               {queries::spell_number(program, use.number)});
            if (message != "number") finding.severity = Severity::warning;
            finding.same_cause = program.name + " " + std::to_string(use.number);
        }
}

} // namespace

} // namespace maclint::rules
