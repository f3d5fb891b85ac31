//! DIN106: a section more often than a program may have it.
#include "analyzer/queries/structure/sections.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/rule.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule section_repeated{
    .code = "DIN106",
    .name = "section-repeated",
    .aliases = "DIN107",
    .summary = "A section stands more often than a program may have it",
    .why = "Of two heads, or of two descriptions of the same part, the control takes one; a fifth contour "
           "group it"
           " refuses.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"again", "Section {0} once more: a program has {1} at most.",
                  "Join them, or give each part a contour group."}},
    .bad = {{"dinplus", R"nc(
BLANK
N1 G20 X50 Z80 K1
BLANK
N2 G20 X60 Z80 K1
MACHINING
N3 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
CONTOUR Q1 X0 Z0
BLANK
N1 G20 X50 Z80 K1
CONTOUR Q2 X0 Z0
BLANK
N2 G20 X60 Z80 K1
MACHINING
N3 M30
END
)nc"}},
    .sources = {"SEED-003:2622", "SEED-003:2827"},
    .check = &check,
};

namespace {

/// How often a program, or each of its contour groups, has a section at most.
struct Most {
    std::string_view kind;
    std::size_t sections;
    bool of_group;
};
constexpr std::array mosts = {Most{"PROGRAM HEAD", 1, false}, Most{"MACHINING", 1, false},
                              Most{"BLANK", 1, true}, Most{"FINISHED", 1, true}, Most{"CONTOUR", 4, false}};

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const Most& most : mosts) {
        std::size_t seen = 0;
        for (const Section& section : analysis.program().sections) {
            if (most.of_group && section.kind == "CONTOUR") seen = 0;
            if (section.kind != most.kind || ++seen != most.sections + 1) continue;
            const std::string count = most.sections == 1 ? "one" : "four";
            reporter.report(
                {analysis, section.heading}, section.heading, "again",
                {std::string(section.kind), count + (most.of_group ? " in a contour group" : "")});
        }
    }
}

} // namespace
} // namespace maclint::rules
