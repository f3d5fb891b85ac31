//! DIN243: a figure whose sizes do not go together.
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/program/whole_number.hpp"
#include "analyzer/program/word_lookup.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule figure_size{
    .code = "DIN243",
    .name = "figure-size",
    .summary = "Sizes of a figure do not go together",
    .why = "No such figure can be milled: the control refuses it, or it comes out as another one.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"slot", "Slot shorter than wide: '{0}' has length K{1} and width B{2}.",
                  "Correct one of them."},
                 {"corner", "Corner too large: in '{0}' two of R{1} do not fit a side of {2}.",
                  "Correct R, or the sides."},
                 {"bent", "Slot wider than its arc: in '{0}' B{2} reaches over the centre of R{1}.",
                  "Correct the width, or the radius."},
                 {"edges", "Too few edges: '{0}' has Q{1}.", "Give three edges or more."}},
    .bad = {{"dinplus", R"nc(
FINISHED
N1 G0 X80 Z0
N2 G1 Z-40
FACE_C Z0
N3 G308 ID"KEY" P-3
N4 G301 XK0 YK20 A0 K6 B8
N5 G309
MACHINING
N10 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
FINISHED
N1 G0 X80 Z0
N2 G1 Z-40
FACE_C Z0
N3 G308 ID"KEY" P-3
N4 G301 XK0 YK20 A0 K24 B8
N5 G309
MACHINING
N10 M30
END
)nc"}},
    .sources = {"SEED-003:11733-11736", "SEED-003:11784-11799", "SEED-003:11842"},
    .check = &check,
};

namespace {

/// The codes of the four surfaces end alike [SEED-003: the pages of these codes].
int figure_of(double code) {
    const std::int64_t number = whole_number(code).value_or(0);
    for (const int surface : {300, 310, 370, 380})
        if (number >= surface && number < surface + 10) return static_cast<int>(number - surface);
    return -1;
}
enum Figure : std::uint8_t { slot = 1, slot_left = 2, slot_right = 3, rectangle = 5, polygon = 7 };

void check_figure(const ProgramAnalysis& analysis, int figure, Span span, std::span<const Word> words,
                  Reporter& reporter) {
    const auto k = number_of(words, "K"), b = number_of(words, "B"), r = number_of(words, "R"),
               q = number_of(words, "Q");
    const auto tell = [&](std::string_view message, double first, double second) {
        reporter.report({analysis, span}, span, message,
                        {quoted(analysis.program(), span), number_word(first), number_word(second)});
    };
    if (figure == slot && k && b && std::abs(*k) < std::abs(*b)) tell("slot", *k, *b);
    if ((figure == slot_left || figure == slot_right) && r && *r != 0 && b && *b > 2 * std::abs(*r))
        tell("bent", *r, *b);
    if (figure == rectangle && k && b && r) {
        const double side = std::min(std::abs(*k), std::abs(*b));
        if (2 * std::abs(*r) > side) tell("corner", *r, side);
    }
    if (figure == polygon && q && *q < 3) tell("edges", *q, 0);
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const Section& section : program.sections) {
        const SectionKind* kind = kind_of(*program.control, section);
        if (kind == nullptr || kind->role != SectionKind::Role::contour) continue;
        for_each_block_of(program, section, [&](const BlockView& block, std::span<const Word> words) {
            if (const auto code = number_of(words, "G"))
                check_figure(analysis, figure_of(*code), block.span, words, reporter);
        });
    }
}

} // namespace
} // namespace maclint::rules
