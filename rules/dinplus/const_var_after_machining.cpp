//! DIN310: CONST or VAR behind MACHINING in a subprogram.
#include "analyzer/program/model.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <optional>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule const_var_after_machining{
    .code = "DIN310",
    .name = "const-var-after-machining",
    .summary = "In a subprogram CONST or VAR stands behind MACHINING",
    .why = "The names have to be known before the blocks that use them: the control refuses the section.",
    .severity = Severity::error,
    .precision = Precision::high,
    .also = "MAC460",
    .messages = {{"plain", "Section too late: {0} stands behind MACHINING on line {1}.",
                  "Move it in front of MACHINING."}},
    .bad = {{"dinplus", R"nc(
%DWELL.ncs
MACHINING
N1 G4 F#__la
RETURN
VAR
#_wait=#l1(3)
)nc"}},
    .good = {{"dinplus", R"nc(
%DWELL.ncs
VAR
#_wait=#l1(3)
MACHINING
N1 G4 F#_wait
RETURN
)nc"}},
    .sources = {"SEED-003:19444"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    for (const Program& program : file.programs) {
        if (program.started != Program::Started::by_call || program.local) continue;
        std::optional<Span> machining;
        for (const Section& section : program.sections) {
            if (section.kind == "MACHINING") machining = section.heading;
            if (!machining || (section.kind != "CONST" && section.kind != "VAR")) continue;
            reporter.report({file, section.heading}, section.heading, "plain",
                            {quoted(program, section.heading), line_number(file, machining->begin)});
        }
    }
}

} // namespace
} // namespace maclint::rules
