//! DIN833: a cycle in another plane than the contour of the Y axis that it machines.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/program/word_lookup.hpp"
#include "analyzer/queries/contours/contour_blocks.hpp"
#include "analyzer/queries/modal/modes_at.hpp"
#include "analyzer/queries/words/block_words.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace maclint::rules {

namespace {
void check(const queries::WordsOfBlock& block, Reporter& reporter);
}

extern const Rule plane_of_contour{
    .code = "DIN833",
    .name = "plane-of-contour",
    .summary = "A cycle works in another plane than the contour of the Y axis that it machines",
    .why = "Contours of FACE_Y and REAR_Y are machined under G17, those of LATERAL_Y under G19: in another "
           "plane the tool drills or mills in another direction.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::block_references},
    .facts = dataflow::facts<dataflow::BeforeNode>(),
    .messages = {{"plain", "Wrong plane: '{0}' machines N{1} of {2} under G{3}.", "Choose G{4} before."}},
    .bad = {{"dinplus", R"nc(
BLANK
N1 G20 X60 Z80 K1
FINISHED
N2 G0 X60 Z0
N3 G1 Z-60
LATERAL_Y X60
N4 G380 Z-20 Y0 B8 P10
MACHINING
N9 T1
N10 G197 S1200 G195 F0.1 M103
N11 G17
N12 G0 X70 Z-20
N13 G71 NS4 V2
N14 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
BLANK
N1 G20 X60 Z80 K1
FINISHED
N2 G0 X60 Z0
N3 G1 Z-60
LATERAL_Y X60
N4 G380 Z-20 Y0 B8 P10
MACHINING
N9 T1
N10 G197 S1200 G195 F0.1 M103
N11 G19
N12 G0 X70 Z-20
N13 G71 NS4 V2
N14 M30
END
)nc"}},
    .sources = {"SEED-003:23167-23181"},
    .check = WordCheck{.addresses = "NS", .blocks = WordCheck::Blocks::all, .check = &check},
};

namespace {

/// Drilling and milling that take their contour by NS.
constexpr std::array cycles = {71.0, 72.0, 73.0, 74.0, 75.0, 840.0, 845.0, 846.0, 847.0, 848.0};

/// The plane of a section; nothing: it has none of its own.
std::optional<double> plane_of(const SectionKind* section) {
    if (section == nullptr) return std::nullopt;
    if (section->name == "FACE_Y" || section->name == "REAR_Y") return 17;
    if (section->name == "LATERAL_Y") return 19;
    return std::nullopt;
}

void check(const queries::WordsOfBlock& block, Reporter& reporter) {
    const auto code = number_of(block.words, "G"), number = number_of(block.words, "NS");
    if (!code || !number || std::ranges::find(cycles, *code) == cycles.end()) return;
    const auto named = queries::find_contour_block(block.analysis.file(), *number);
    const auto wanted = named ? plane_of(named->section) : std::nullopt;
    const auto group = block.analysis.control().group_with(ModalRole::plane);
    if (!wanted || !group) return;
    const auto plane = block.modes_at(block.block).with_words(*group).sure_code();
    if (!plane || *plane == *wanted) return;
    const Span span = block.block.span;
    reporter.report({block.analysis, span}, span, "plain",
                    {quoted(block.analysis.program(), span), number_word(*number),
                     std::string(named->section->name), number_word(*plane), number_word(*wanted)});
}

} // namespace
} // namespace maclint::rules
