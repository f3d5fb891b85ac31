//! MAC452: a program number that no program can have.
#include "analyzer/dialect/number_limits.hpp"
#include "analyzer/program/model.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule illegal_program_number{
    .code = "MAC452",
    .name = "illegal-o-number",
    .summary = "A program number that the control does not take",
    .why = "The control refuses the program when it is read in, or stores it under another number. Numbers "
           "are from 1 to 9999, with an option to 99999999.",
    .severity = Severity::error,
    .precision = Precision::high,
    .messages = {{"zero", "Program number 0: '{0}' names no program.", "Give it another number."},
                 {"long", "Program number too great: '{0}', and the control has them up to {1}.",
                  "Give it a shorter number."}},
    .bad = {{"fanuc", R"nc(
O0000(PLATE)
G90 G0 X0
M30
)nc"},
            {"fanuc", R"nc(
O123456789(PLATE)
G90 G0 X0
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O0001(PLATE)
G90 G0 X0
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "074", "ILLEGAL PROGRAM NUMBER"},
               {"FANUC 30i/0i-D", "074", "ILLEGAL PROGRAM NUMBER"}},
    .sources = {"MAN-PB129", "GH-ALM"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    for (const Program& program : file.programs) {
        const NumberLimits* limits = number_limits(*program.control);
        if (limits == nullptr || !program.number || program.name_span.empty()) continue;
        const bool zero = *program.number == 0 && !limits->zero_is_program;
        if (!zero && *program.number <= limits->last_program) continue;
        Finding& finding = reporter.report(
            {file, program.name_span}, program.name_span, zero ? "zero" : "long",
            {std::string(program.slice(program.name_span)), std::to_string(limits->last_program)});
        if (!program.control->assumed) continue;
        finding.severity = Severity::warning;
        finding.alarm = {};
    }
}

} // namespace
} // namespace maclint::rules
