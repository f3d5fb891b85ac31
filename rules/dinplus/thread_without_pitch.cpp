//! DIN720: G31 cuts a thread where its contour has none.
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/program/whole_number.hpp"
#include "analyzer/program/word_lookup.hpp"
#include "analyzer/queries/contours/contour_blocks.hpp"
#include "analyzer/queries/structure/text_order.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule thread_without_pitch{
    .code = "DIN720",
    .name = "g31-no-pitch",
    .summary = "G31 names a contour without a thread, and gives no pitch",
    .why = "On a plain line the pitch stands in G31: without F and without G24, G34 or G37 the control does "
           "not know it and stops with an error.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::block_references},
    .messages = {{"plain",
                  "Thread without a pitch: '{0}' has no F, and the contour at N{1} holds no G24, G34 or G37.",
                  "Name the block of the thread, or give F."}},
    .bad = {{"dinplus", R"nc(
BLANK
N1 G20 X60 Z80 K1
FINISHED
N2 G0 X0 Z0
N3 G1 X50
N4 G1 Z-40
N5 G34 F2
N6 G25 H7 FP2
N7 G1 X56
N8 G1 Z-60
MACHINING
N10 T1
N11 G97 S800 M3
N12 G0 X62 Z6
N13 G31 NS8 NE8 B5 P2 V0 H1
N14 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
BLANK
N1 G20 X60 Z80 K1
FINISHED
N2 G0 X0 Z0
N3 G1 X50
N4 G1 Z-40
N5 G34 F2
N6 G25 H7 FP2
N7 G1 X56
N8 G1 Z-60
MACHINING
N10 T1
N11 G97 S800 M3
N12 G0 X62 Z6
N13 G31 NS4 NE4 B5 P2 V0 H1
N14 M30
END
)nc"}},
    .sources = {"SEED-003:14596", "SEED-003:14690", "SEED-003:14702"},
    .check = &check,
};

namespace {

constexpr double thread_cycle = 31;
constexpr std::array threads = {24.0, 34.0, 37.0};
constexpr std::array elements = {0.0, 1.0, 2.0, 3.0, 12.0, 13.0};

/// Whether the blocks from `first` to `last`, with what lies on the last one, hold a thread, or anything that
/// nobody knows.
bool may_hold_thread(const NumberedBlock& first, double last) {
    const Section* section = section_at(*first.program, first.number_span.begin);
    if (section == nullptr) return true;
    bool inside = false, at_last = false;
    const auto blocks = queries::blocks_in_order(*first.program, *section);
    if (!blocks) return true;
    for (const queries::TextBlock& block : *blocks) {
        const auto code = block.code();
        inside |= block.block.number == first.number;
        if (!inside) continue;
        const bool is_element = code && std::ranges::find(elements, *code) != elements.end();
        if (at_last && is_element) return false;
        if (block.breaks || !code || std::ranges::find(threads, *code) != threads.end()) return true;
        at_last |= block.block.number == whole_number(last);
    }
    return !inside || !at_last;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for_each_running_block_with(program, "NS", [&](const BlockView& view, std::span<const Word> words) {
        const auto from = number_of(words, "NS");
        const Word* end = find_word(words, "NE");
        const auto to = end == nullptr ? from : number_of(end);
        if (number_of(words, "G") != thread_cycle || !from || !to || *to < *from) return;
        if (find_word(words, "F") != nullptr || find_word(words, "ID") != nullptr) return;
        const auto first = queries::find_contour_block(analysis.file(), *from);
        if (!first || may_hold_thread(*first, *to)) return;
        reporter.report({analysis, view.span}, view.span, "plain",
                        {quoted(program, view.span), number_word(*from)});
    });
}

} // namespace
} // namespace maclint::rules
