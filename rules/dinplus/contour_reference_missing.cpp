//! DIN704: NS or NE names a block that is no contour block.
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/section_kinds.hpp"
#include "analyzer/queries/structure/wrong_places.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule contour_reference_missing{
    .code = "DIN704",
    .name = "contour-reference-missing",
    .summary = "NS or NE names a block that does not exist or stands in no contour section",
    .why = "The cycle does not find its contour, and the control stops with an error when it gets there.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::block_references},
    .messages = {{"missing", "Missing contour block: '{0}' names N{1}, which does not exist.",
                  "Correct the number."},
                 {"elsewhere", "Reference outside the contour: '{0}' names N{1}, which stands in {2}.",
                  "Name a block of the contour."}},
    .bad = {{"dinplus", R"nc(
BLANK
N1 G20 X60 Z80 K1
FINISHED
N2 G0 X0 Z0
N3 G1 X50
N4 G1 Z-40
MACHINING
N10 T1
N11 G0 X62 Z2
N12 G810 NS3 NE99 P2
N13 M30
END
)nc"},
            {"dinplus", R"nc(
BLANK
N1 G20 X60 Z80 K1
FINISHED
N2 G0 X0 Z0
N3 G1 X50
N4 G1 Z-40
MACHINING
N10 T1
N11 G0 X62 Z2
N12 G810 NS3 NE11 P2
N13 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
BLANK
N1 G20 X60 Z80 K1
FINISHED
N2 G0 X0 Z0
N3 G1 X50
N4 G1 Z-40
MACHINING
N10 T1
N11 G0 X62 Z2
N12 G810 NS3 NE4 P2
N13 M30
END
)nc"}},
    .sources = {"SEED-003:10203", "SEED-003:13166-13167"},
    .check = &check,
};

namespace {

using Role = SectionKind::Role;

/// Whether the file describes contours, and no subprogram a part of them.
bool describes_whole_contours(const ProgramFile& file) {
    bool described = false, whole = true;
    for (const Program& program : file.programs)
        for (const Section& section : program.sections) {
            const SectionKind* kind = kind_of(*program.control, section);
            if (kind == nullptr || kind->role != Role::contour) continue;
            described = true;
            for_each_block_with_effects(program, section.items, [&](const BlockView& block) {
                for (const Effect& effect : program.effects_in(block.effects))
                    whole &= !std::holds_alternative<Call>(effect.what) &&
                             !std::holds_alternative<UnreadableBlock>(effect.what);
            });
        }
    return described && whole;
}

void check(const ProgramFile& file, Reporter& reporter) {
    if (!describes_whole_contours(file)) return;
    queries::WrongPlaces places(file, [](const NumberedBlock& block) {
        // A subprogram may hold a contour as well as machining.
        return block.section == nullptr || block.section->role == Role::contour ||
               block.section->role == Role::subprogram;
    });
    for (const Program& program : file.programs)
        for (const BlockUser& user : find_block_users(program)) {
            if (user.target != Role::contour) continue;
            const auto& elsewhere = places.of(user.number);
            if (!elsewhere) continue;
            const Span span = program.effects[user.effect].span;
            reporter.report({file, span}, span, elsewhere->empty() ? "missing" : "elsewhere",
                            {quoted(program, span), std::to_string(user.number), *elsewhere});
        }
}

} // namespace
} // namespace maclint::rules
