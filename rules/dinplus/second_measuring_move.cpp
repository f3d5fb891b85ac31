//! DIN951: under the monitoring of a measuring move stands more than one.
#include "analyzer/program/word_lookup.hpp"
#include "analyzer/queries/structure/text_order.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule second_measuring_move{
    .code = "DIN951",
    .name = "second-measuring-move",
    .summary = "Under the monitoring of a measuring move stands more than one feed move",
    .why = "G911 watches a single feed move: behind it the probe runs into the part unwatched.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"second",
                  "Second move under G911: '{0}' follows the feed move on line {1}, and only one is watched.",
                  "Write it behind G914."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N1 T5
N2 G94 F400
N3 G910 V0 D1
N4 G911 V0
N5 G1 Xi-10
N6 G1 Zi-1
N7 G914
N8 G912 Q1
N9 G913
N10 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N1 T5
N2 G94 F400
N3 G910 V0 D1
N4 G911 V0
N5 G1 Xi-10
N6 G914
N7 G912 Q1
N8 G913
N9 M30
END
)nc"}},
    .sources = {"SEED-003:22307-22309"},
    .check = &check,
};

namespace {

constexpr double on = 911, off = 914, end = 913, rapid = 0;
constexpr std::array feed_moves = {1.0, 2.0, 3.0, 12.0, 13.0, 101.0, 102.0, 103.0, 111.0, 112.0, 113.0};
constexpr std::array<std::string_view, 5> axes = {"X", "Y", "Z", "C", "XK"};

/// The code by which moves go on behind the block: its own, or the one before.
std::optional<double> motion_of(const queries::TextBlock& block, std::optional<double> before) {
    for (const Word& word : block.words) {
        const auto code = word.address == "G" ? number_of(&word) : std::nullopt;
        const bool is_feed = code && std::ranges::find(feed_moves, *code) != feed_moves.end();
        if (is_feed || code == rapid) before = code;
    }
    return before;
}

bool moves(const queries::TextBlock& block) {
    return std::ranges::any_of(
        axes, [&](std::string_view axis) { return find_word(block.words, axis) != nullptr; });
}

void check_section(const ProgramAnalysis& analysis, const Section& section, Reporter& reporter) {
    const Program& program = analysis.program();
    bool watches = false;
    std::optional<Offset> move;
    std::optional<double> motion;
    const auto blocks = queries::blocks_in_order(program, section);
    if (!blocks) return;
    for (const queries::TextBlock& block : *blocks) {
        const auto code = block.code();
        const Span span = block.block.span;
        motion = block.breaks ? std::nullopt : motion_of(block, motion);
        if (block.breaks || code == end || code == off) {
            watches = false;
        } else if (code == on) {
            watches = true;
            move.reset();
        }
        if (!watches || !motion || *motion == rapid || !moves(block)) continue;
        if (move)
            reporter.report({analysis, span}, span, "second",
                            {quoted(program, span), line_number(analysis.file(), *move)});
        watches = !move;
        move = span.begin;
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const Section& section : analysis.program().sections)
        if (section.executed == Section::Executed::when_reached) check_section(analysis, section, reporter);
}

} // namespace
} // namespace maclint::rules
