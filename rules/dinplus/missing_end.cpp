//! DIN102: a main program without END.
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/structure/sections.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);

constexpr Exemption breaks_off;
} // namespace

extern const Rule missing_end{
    .code = "DIN102",
    .name = "missing-end",
    .summary = "A main program without the word that closes it",
    .why = "END (in German ENDE) is one of the two words that every program must have. A file without it may "
           "have been cut off on its way.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain", "Missing {0}: the program is not closed after this block.",
                  "Add {0}, or look for the rest of the file."}},
    .bad = {{"dinplus", R"nc(
%PIN.nc
MACHINING
N10 G14 Q0
N20 M30
)nc"}},
    .good = {{"dinplus", R"nc(
%PIN.nc
MACHINING
N10 G14 Q0
N20 M30
END
)nc"}},
    .exemptions = {{&breaks_off,
                    "breaks-off",
                    "The machining part is empty, or breaks off with a block that nobody can read: a sketch, "
                    "or an example.",
                    {"dinplus", R"nc(
PROGRAM HEAD
#UNIT METRIC
MACHINING
)nc"}}},
    .sources = {"SEED-003:2223", "SEED-003:2941"},
    .check = &check,
};

namespace {

/// The machining part breaks off with a block that nobody can read, or has none: the text is a sketch, or its
/// last word is reported as what it is.
bool is_cut_off(const Program& program) {
    if (program.sections.empty() || program.sections.back().items.count == 0) return true;
    const auto last = last_block(program);
    return last && std::ranges::any_of(program.effects_in(last->effects), [](const Effect& effect) {
               return std::holds_alternative<UnreadableBlock>(effect.what);
           });
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    if (!queries::is_whole_main_program(program)) return;
    const auto& kinds = analysis.control().sections;
    const auto end = std::ranges::find(kinds, SectionKind::Role::end, &SectionKind::role);
    // A program that lacks its machining part, too, was cut off before it: that is reported.
    if (!queries::has_section(program, SectionKind::Role::machining) ||
        (breaks_off.is_on() && is_cut_off(program)))
        return;
    if (end == kinds.end() || queries::has_section(program, *end)) return;
    const Span last = last_block(program)->span;
    reporter.report({analysis, last}, last, "plain", {std::string(end->name)});
}

} // namespace
} // namespace maclint::rules
