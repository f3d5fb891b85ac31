//! DIN246: a contour behind a cycle that nothing ends; G80 without one.
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

extern const Rule contour_behind_cycle{
    .code = "DIN246",
    .name = "contour-behind-cycle",
    .summary = "A contour behind a cycle is not ended, or G80 ends none",
    .why = "A cycle without NS or ID takes the contour from the blocks behind it, up to G80: without G80 it "
           "takes moves of the tool for a part of the contour.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages =
        {{"unclosed",
          "Contour without its end: '{0}' follows the contour of '{1}' on line {2}, and no G80 has ended it.",
          "Write G80 behind the contour."},
         {"surplus", "G80 without a contour: '{0}' has it by name or number, and nothing is to be ended.",
          "Delete G80."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N2 G96 S200 G95 F0.2 M4 T1
N3 G0 X62 Z2
N4 G810 P2
N5 G0 X50 Z0
N6 G1 Z-30
N7 G1 X62
N8 G14 Q0
N9 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N2 G96 S200 G95 F0.2 M4 T1
N3 G0 X62 Z2
N4 G810 P2
N5 G0 X50 Z0
N6 G1 Z-30
N7 G1 X62
N8 G80
N9 G14 Q0
N10 M30
END
)nc"}},
    .sources = {"SEED-003:13089-13096", "SEED-003:14363-14366"},
    .check = &check,
};

namespace {

/// Cycles that take their contour from the blocks behind them [SEED-003:13089-13096].
constexpr std::array cycles = {810.0, 820.0, 830.0, 835.0, 860.0, 869.0, 890.0};
/// Codes of such a contour, with what stands beside its elements.
constexpr std::array contour = {0.0,  1.0,  2.0,  3.0,  10.0, 12.0, 13.0, 22.0, 23.0,
                                24.0, 25.0, 34.0, 37.0, 38.0, 39.0, 52.0, 95.0, 149.0};
constexpr double end_of_contour = 80, with_contour = 83;

template<class Codes>
bool is_one_of(std::optional<double> code, const Codes& codes) {
    return code && std::ranges::find(codes, *code) != codes.end();
}

/// Turning and milling cycles, and threads.
bool takes_contour(std::optional<double> code) {
    return code && (*code == 31 || (*code >= 800 && *code < 900));
}

struct Walk {
    const ProgramAnalysis& analysis;
    Reporter& reporter;
    std::optional<Span> open = {}; ///< the cycle whose contour the blocks describe
    int elements = 0;
    bool has_own_contour = false; ///< the block before is a cycle that names its contour
    bool in_cycle = false;        ///< G83 is not ended

    void look_at(const queries::TextBlock& block) {
        const auto code = block.code();
        const bool ends = std::ranges::any_of(block.words, [](const Word& word) {
            return word.address == "G" && number_of(&word) == end_of_contour;
        });
        const bool stops = number_of(block.words, "M") == 30 && block.words.size() == 1;
        if (ends && has_own_contour && block.words.size() == 1) tell("surplus", block.block.span);
        const bool goes_on = is_one_of(code, contour) || (find_word(block.words, "G") == nullptr && !stops);
        if (open && !ends && (!block.breaks || stops) && !goes_on) {
            if (elements > 0) tell("unclosed", block.block.span); // none at all is told at the cycle
        } else if (open && !ends && !block.breaks) {
            elements += static_cast<int>(is_one_of(code, contour));
            return;
        }
        open.reset();
        const bool is_cycle = is_one_of(code, cycles) && !ends && !block.breaks;
        const bool named = find_word(block.words, "NS") != nullptr || find_word(block.words, "ID") != nullptr;
        has_own_contour = named && !in_cycle && !ends && !block.breaks && takes_contour(code);
        elements = 0;
        if (is_cycle && !named) open = block.block.span;
        if (code == with_contour || ends) in_cycle = !ends;
    }

    void tell(std::string_view message, Span at) {
        const Program& program = analysis.program();
        reporter.report({analysis, at}, at, message,
                        {quoted(program, at), open ? quoted(program, *open) : "",
                         open ? line_number(analysis.file(), open->begin) : ""});
    }
};

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const Section& section : analysis.program().sections) {
        if (section.executed != Section::Executed::when_reached) continue;
        Walk walk{analysis, reporter};
        if (const auto blocks = queries::blocks_in_order(analysis.program(), section))
            for (const queries::TextBlock& block : *blocks) walk.look_at(block);
    }
}

} // namespace
} // namespace maclint::rules
