//! MAC127: DPRNT, BPRNT and SETVN in a form that the control does not take.
#include "analyzer/program/faults.hpp"
#include "rules/rule.hpp"
#include "rules/syntax_errors.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule format_of_output{
    .code = "MAC127",
    .name = "format-of-output",
    .summary = "An output or naming statement in a form that the control does not take",
    .why = "DPRNT wants [ ] around what it prints, and two figures in [ ] behind each variable: those before "
           "and behind the point. BPRNT wants one, SETVN names of eight letters and figures at most. The "
           "control stops in the block, often at the end of a measurement.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .yields_to = "MAC122",
    .messages = {{"output", "Form of an output: the control stops at '{0}'.", "Write {1}."},
                 {"name", "Name that the control does not take: it stops at '{0}'.", "Write {1}."}},
    .bad = {{"fanuc", R"nc(
O9127(REPORT)
POPEN
DPRNT[X#101[5]]
PCLOS
M30
)nc"},
            {"fanuc", R"nc(
O9127(REPORT)
POPEN
DPRNTX#101[53]
PCLOS
M30
)nc"},
            {"fanuc", R"nc(
O9127(NAMES)
SETVN510[]
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9127(REPORT)
POPEN
DPRNT[X#101[53]***Y#102[44]]
BPRNT[C**X#101[3]]
PCLOS
M30
)nc"},
             {"fanuc", R"nc(
O9127(NAMES)
SETVN510[DEPTH,WIDTH_2]
M30
)nc"}},
    .alarms = {{"FANUC 30i/0i-D", "1143", "BPRNT/DPRNT STATEMENT FORMAT ERROR", true, "output-form"},
               {"FANUC 30i/0i-D", "1139", "SETVN STATEMENT FORMAT ERROR", true, "naming-form"},
               {"FANUC 30i/0i-D", "1141", "ILLEGAL CHARACTER IN VAR. NAME", true, "name-character"},
               {"FANUC 30i/0i-D", "1142", "TOO LONG V-NAME (SETVN)", true, "long-name"}},
    .sources = {"GH-ALM", "T: the figures of a format"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    constexpr SyntaxErrorKind kind = SyntaxErrorKind::unreadable;
    report_syntax_error(file, kind, reporter, {.without = "output", .faults = {faults::output_form}});
    report_syntax_error(
        file, kind, reporter,
        {.without = "name", .faults = {faults::naming_form, faults::name_character, faults::long_name}});
}

} // namespace
} // namespace maclint::rules
