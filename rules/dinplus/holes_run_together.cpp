//! DIN244: a pattern puts its holes so close that they run into each other.
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/program/word_lookup.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule holes_run_together{
    .code = "DIN244",
    .name = "holes-run-together",
    .summary = "A pattern puts its holes so close that they run into each other",
    .why = "The drill cuts on one side only, runs off and breaks.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain", "Holes run into each other: '{0}' puts them {1} apart, and they have B{2}.",
                  "Correct the pattern, or the diameter of the hole."}},
    .bad = {{"dinplus", R"nc(
FINISHED
N1 G0 X150 Z0
N2 G1 Z-40
FACE_C Z0
N3 G308 ID"RING" P-20
N4 G402 Q48 K120 A0 XK0 YK0
N5 G300 B9 P20
N6 G309
MACHINING
N10 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
FINISHED
N1 G0 X150 Z0
N2 G1 Z-40
FACE_C Z0
N3 G308 ID"RING" P-20
N4 G402 Q8 K120 A0 XK0 YK0
N5 G300 B9 P20
N6 G309
MACHINING
N10 M30
END
)nc"}},
    .sources = {"SEED-003:11866-11887"},
    .check = &check,
};

namespace {

constexpr std::array circles = {402.0, 412.0, 472.0, 482.0};
constexpr std::array holes = {300.0, 310.0, 370.0, 380.0};

bool is_one_of(double code, const std::array<double, 4>& codes) {
    return std::ranges::find(codes, code) != codes.end();
}

/// How far two figures of the pattern in a row are apart, by geometry from the words of the manual; nothing
/// where it does not stand there.
std::optional<double> step_of(double code, std::span<const Word> words) {
    if (is_one_of(code, circles)) {
        const auto count = number_of(words, "Q"), across = number_of(words, "K");
        const Word* part = find_word(words, "W"); // of the circle, or its step
        if (!count || !across || *count < 2 || part != nullptr) return std::nullopt;
        return std::abs(*across) * std::sin(std::numbers::pi / *count);
    }
    const bool lateral = code == 481, face = code == 401 || code == 471;
    if (!lateral && !face) return std::nullopt;
    const Word *first = find_word(words, lateral ? "K" : "I"), *second = find_word(words, "J");
    const auto a = number_of(first), b = number_of(second), holes_in_row = number_of(words, "Q");
    if (!a || !b || !holes_in_row || *holes_in_row < 2 || !first->incremental || !second->incremental)
        return std::nullopt;
    return std::hypot(*a, *b);
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    constexpr double rounding = 0.001; // mm
    const Program& program = analysis.program();
    for (const Section& section : program.sections) {
        const SectionKind* kind = kind_of(*program.control, section);
        if (kind == nullptr || kind->role != SectionKind::Role::contour) continue;
        std::optional<double> step; // of the pattern in the block before
        Span pattern{};
        for_each_block_of(program, section, [&](const BlockView& block, std::span<const Word> words) {
            const auto code = number_of(words, "G"), across = number_of(words, "B");
            if (code && is_one_of(*code, holes) && step && across && *step < *across - rounding)
                reporter.report({analysis, pattern}, pattern, "plain",
                                {quoted(program, pattern), number_word(std::round(*step * 100) / 100),
                                 number_word(*across)});
            step = code ? step_of(*code, words) : std::nullopt;
            pattern = block.span;
        });
    }
}

} // namespace
} // namespace maclint::rules
