//! DIN101: a main program without MACHINING.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/structure/sections.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule missing_machining{
    .code = "DIN101",
    .name = "missing-machining",
    .summary = "A main program without the section that is run",
    .why = "MACHINING (in German BEARBEITUNG) is one of the two sections that every program must have: "
           "without it the control has nothing to run.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain", "Missing section {0}: nothing of this program is run.",
                  "Add the word before the first block of the machining."}},
    .bad = {{"dinplus", R"nc(
BLANK
N1 G20 X50 Z80
END
)nc"}},
    .good = {{"dinplus", R"nc(
BLANK
N1 G20 X50 Z80
MACHINING
N2 M30
END
)nc"}},
    .sources = {"SEED-003:2223", "SEED-003:2622", "SEED-003:2937"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    if (!queries::is_whole_main_program(program)) return;
    for (const SectionKind& kind : analysis.control().sections) {
        if (!kind.required || kind.role == SectionKind::Role::end || queries::has_section(program, kind))
            continue;
        const Span first = queries::first_heading(program);
        reporter.report({analysis, first}, first, "plain", {std::string(kind.name)});
    }
}

} // namespace
} // namespace maclint::rules
