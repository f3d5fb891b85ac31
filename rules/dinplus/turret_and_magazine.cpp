//! DIN115: two lists of tools in one program.
#include "analyzer/program/model.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule turret_and_magazine{
    .code = "DIN115",
    .name = "turret-and-magazine",
    .summary = "A program has TURRET and MAGAZINE",
    .why = "A machine has one of the two: the tools of the other list are not found.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain", "Two lists of tools: {0} stands here, and {1} on line {2}.",
                  "Keep the one that the machine has."}},
    .bad = {{"dinplus", R"nc(
TURRET 1
T1 ID"ROUGH 80"
MAGAZINE
ID"FINISH 35"
MACHINING
N10 T1
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
TURRET 1
T1 ID"ROUGH 80"
MACHINING
N10 T1
N99 M30
END
)nc"}},
    .sources = {"SEED-003:2791-2810"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    for (const Program& program : file.programs) {
        const Section* first = nullptr;
        for (const Section& section : program.sections) {
            if (section.kind != "TURRET" && section.kind != "MAGAZINE") continue;
            if (first == nullptr) first = &section;
            if (first->kind == section.kind) continue;
            reporter.report({file, section.heading}, section.heading, "plain",
                            {std::string(section.kind), std::string(first->kind),
                             line_number(file, first->heading.begin)});
            break;
        }
    }
}

} // namespace
} // namespace maclint::rules
