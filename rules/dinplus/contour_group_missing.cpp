//! DIN108: G99 chooses a contour group that the program does not describe.
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/word_lookup.hpp"
#include "analyzer/queries/structure/sections.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <set>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule contour_group_missing{
    .code = "DIN108",
    .name = "contour-group-missing",
    .summary = "G99 chooses a contour group that the program does not describe",
    .why = "The cycles behind it find no contour, and the control stops with an error.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain", "Missing contour group: '{0}' chooses group {1}, and no section CONTOUR has Q{1}.",
                  "Correct Q, or describe the group."}},
    .bad = {{"dinplus", R"nc(
CONTOUR Q1 X0 Z0
BLANK
N1 G20 X60 Z80 K1
FINISHED
N2 G0 X0 Z0
N3 G1 X50
MACHINING
N10 G99 Q2
N11 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
CONTOUR Q1 X0 Z0
BLANK
N1 G20 X60 Z80 K1
FINISHED
N2 G0 X0 Z0
N3 G1 X50
MACHINING
N10 G99 Q1
N11 M30
END
)nc"}},
    .sources = {"SEED-003:2822-2830", "SEED-003:20080-20086"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    constexpr double choice = 99;
    const Program& program = analysis.program();
    constexpr double most_groups = 4; // [SEED-003:2827]; what is beyond is told by the value's row
    std::set<double> groups;
    for (const Section& section : program.sections) {
        const bool is_group = section.kind == "CONTOUR";
        const SectionKind* kind = kind_of(*program.control, section);
        if (!is_group && groups.empty() && kind != nullptr && kind->role == SectionKind::Role::contour)
            return; // a contour of no group
        if (!is_group) continue;
        const auto number = number_of(queries::heading_words(program, section), "Q");
        if (!number) return;
        groups.insert(*number);
    }
    if (groups.empty()) return;
    for_each_running_block_with(program, "Q", [&](const BlockView& view, std::span<const Word> words) {
        const auto group = number_of(words, "Q");
        if (number_of(words, "G") != choice || !group || *group < 1 || *group > most_groups ||
            groups.contains(*group))
            return;
        reporter.report({analysis, view.span}, view.span, "plain",
                        {quoted(program, view.span), number_word(*group)});
    });
}

} // namespace
} // namespace maclint::rules
