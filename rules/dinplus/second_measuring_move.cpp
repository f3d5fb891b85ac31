//! DIN951: under the monitoring of a measuring move stands no move, or more than one.
#include "analyzer/program/word_lookup.hpp"
#include "analyzer/queries/structure/text_order.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule second_measuring_move{
    .code = "DIN951",
    .name = "second-measuring-move",
    .summary = "Under the monitoring of a measuring move stands no feed move, or more than one",
    .why = "G911 watches a single feed move: behind it the probe runs into the part unwatched.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"second",
                  "Second move under G911: '{0}' follows the feed move on line {1}, and only one is watched.",
                  "Write it behind G914."},
                 {"none", "No move under G911: '{0}' ends the monitoring before anything has moved.",
                  "Write the measuring move in front of it."}},
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

constexpr double on = 911, off = 914, end = 913;
constexpr std::array feed_moves = {1.0, 2.0, 3.0, 12.0, 13.0, 101.0, 102.0, 103.0, 111.0, 112.0, 113.0};

void check_section(const ProgramAnalysis& analysis, const Section& section, Reporter& reporter) {
    const Program& program = analysis.program();
    bool watches = false;
    std::optional<Offset> move;
    for (const queries::TextBlock& block : queries::blocks_in_order(program, section)) {
        const auto code = block.code();
        const Span span = block.block.span;
        if (block.breaks || code == end) {
            watches = false;
        } else if (code == on) {
            watches = true;
            move.reset();
        } else if (code == off) {
            if (watches && !move) reporter.report({analysis, span}, span, "none", {quoted(program, span)});
            watches = false;
        } else if (watches && code && std::ranges::find(feed_moves, *code) != feed_moves.end()) {
            if (move)
                reporter.report({analysis, span}, span, "second",
                                {quoted(program, span), line_number(analysis.file(), *move)});
            watches = !move;
            move = span.begin;
        }
    }
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const Section& section : analysis.program().sections)
        if (section.executed == Section::Executed::when_reached) check_section(analysis, section, reporter);
}

} // namespace
} // namespace maclint::rules
