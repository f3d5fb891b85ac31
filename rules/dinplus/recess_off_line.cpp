//! DIN213: a recess, an undercut or a run-out that its line has no room for.
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/word_lookup.hpp"
#include "analyzer/queries/contours/turning_outline.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule recess_off_line{
    .code = "DIN213",
    .name = "recess-off-line",
    .summary = "A recess or thread does not fit the line that it stands on",
    .why = "The control places recesses, undercuts and threads on the straight element before: one that lies "
           "beside it or is longer makes no contour.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"oblique", "Recess on an oblique line: '{0}' wants a line along an axis, as no '{1}' is.",
                  "Write G23, or correct the line."},
                 {"off", "Recess beside its line: '{0}' comes to {2}, and '{1}' ends before.",
                  "Correct the recess, or write it behind its own line."},
                 {"long", "Longer than its line: '{0}' takes {2}, and '{1}' is {3} long.",
                  "Correct the width, or the line."}},
    .bad = {{"dinplus", R"nc(
FINISHED
N1 G0 X40 Z0
N2 G1 Z-50
N3 G22 Z-49 I36 Ki-3
N4 G1 X60
MACHINING
N10 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
FINISHED
N1 G0 X40 Z0
N2 G1 Z-50
N3 G22 Z-30 I36 Ki-3
N4 G1 X60
MACHINING
N10 M30
END
)nc"}},
    .sources = {"SEED-003:10772-10790", "SEED-003:10815-10845", "SEED-003:10876-10900"},
    .check = &check,
};

namespace {

constexpr double rounding = 0.001; // mm

struct LineCheck {
    const ProgramAnalysis& analysis;
    const queries::OutlineElement& line;
    Span form;
    Reporter& reporter;

    /// A place along Z, or along X as a radius, of a form that ends there; lines across the axis hold any.
    bool at(std::optional<double> place, bool along_x) const {
        const double from = along_x ? line.from->x : line.from->z, to = along_x ? line.to->x : line.to->z;
        if (!place || std::abs(from - to) < rounding ||
            (*place >= std::min(from, to) - rounding && *place <= std::max(from, to) + rounding))
            return true;
        tell("off", {number_word(std::round(*place * (along_x ? 2000 : 1000)) / 1000)});
        return false;
    }
    void takes(std::optional<double> width) const {
        const double length = queries::distance(*line.from, *line.to);
        if (width && *width > length + rounding)
            tell("long", {number_word(*width), number_word(std::round(length * 1000) / 1000)});
    }
    [[nodiscard]] bool is_oblique() const {
        return std::abs(line.from->x - line.to->x) > rounding &&
               std::abs(line.from->z - line.to->z) > rounding;
    }
    void tell(std::string_view message, std::vector<std::string> more) const {
        std::vector<std::string> texts{quoted(analysis.program(), form),
                                       quoted(analysis.program(), line.block)};
        texts.insert(texts.end(), more.begin(), more.end());
        reporter.report({analysis, form}, form, message, texts);
    }
};

std::optional<double> half(std::optional<double> diameter) {
    return diameter ? std::optional(*diameter / 2) : std::nullopt;
}

/// Where the recess of G22 ends along Z.
std::optional<double> end_of(std::span<const Word> words, std::optional<double> z) {
    const Word* k = find_word(words, "K");
    const auto end = number_of(k);
    if (!z || !end) return std::nullopt;
    return k->incremental ? *z + *end : *end;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const queries::Outline& outline : queries::turning_contours(analysis.program())) {
        for_each_block_of(
            analysis.program(), *outline.section, [&](const BlockView& block, std::span<const Word> words) {
                const queries::OutlineElement* line = outline.before(block.span.begin);
                if (line == nullptr || block.skip_levels != 0) return;
                if (line->is_arc || !line->from || !line->to) return;
                const LineCheck on{analysis, *line, block.span, reporter};
                const auto code = number_of(words, "G"), z = number_of(words, "Z"), k = number_of(words, "K");
                if (code == 22 && on.is_oblique()) {
                    on.tell("oblique", {});
                } else if (code == 22) {
                    if (z ? on.at(z, false) : on.at(half(number_of(words, "X")), true))
                        on.at(end_of(words, z), false);
                } else if (code == 23) {
                    if (on.at(z, false)) on.takes(k);
                } else if (code == 24) {
                    on.takes(k);
                }
            });
    }
}

} // namespace
} // namespace maclint::rules
