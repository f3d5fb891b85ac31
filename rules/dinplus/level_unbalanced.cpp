//! DIN225: G308 and G309 that do not pair.
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/section_blocks.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <span>
#include <vector>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule level_unbalanced{
    .code = "DIN225",
    .name = "g308-unbalanced",
    .summary = "G308 begins a pocket or island that no G309 ends, or G309 ends none",
    .why = "The figures behind it get the depth of another pocket, and the control stops with an error.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"open", "Open level: no G309 ends '{0}' in {1}.", "Write G309 behind its figures."},
                 {"closed", "G309 without G308: '{0}' ends nothing in {1}.", "Remove it, or write G308."}},
    .bad = {{"dinplus", R"nc(
FINISHED
N1 G0 X60 Z0
N2 G1 Z-40
FACE_C Z0
N3 G308 ID"BORE" P-10
N4 G300 XK10 YK5 B8
MACHINING
N10 M30
END
)nc"},
            {"dinplus", R"nc(
FINISHED
N1 G0 X60 Z0
N2 G1 Z-40
FACE_C Z0
N3 G308 ID"BORE" P-10
N4 G300 XK10 YK5 B8
N5 G309
N6 G309
MACHINING
N10 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
FINISHED
N1 G0 X60 Z0
N2 G1 Z-40
FACE_C Z0
N3 G308 ID"POCKET" P-10
N4 G305 XK0 YK0 K30 B20
N5 G308 ID"BORE" P-15
N6 G300 XK10 YK5 B8
N7 G309
N8 G309
MACHINING
N10 M30
END
)nc"}},
    .sources = {"SEED-003:11495"},
    .check = &check,
};

namespace {

constexpr double opens = 308, closes = 309;

void look_at(const ProgramAnalysis& analysis, const Section& section, Reporter& reporter) {
    const Program& program = analysis.program();
    std::vector<Span> open;
    bool is_whole = true;
    for_each_block_of(program, section, [&](const BlockView& block, std::span<const Word> words) {
        for (const Effect& effect : program.effects_in(block.effects))
            is_whole &= !std::holds_alternative<Call>(effect.what) &&
                        !std::holds_alternative<UnreadableBlock>(effect.what);
        for (const Word& word : words) {
            const auto* code = std::get_if<Literal>(&word.value);
            if (code == nullptr || word.address != "G") continue;
            if (code->value == opens) open.push_back(block.span);
            if (code->value != closes) continue;
            if (!open.empty())
                open.pop_back();
            else if (is_whole)
                reporter.report({analysis, word.span}, word.span, "closed",
                                {quoted(program, block.span), std::string(section.kind)});
        }
    });
    if (is_whole && !open.empty())
        reporter.report({analysis, open.front()}, open.front(), "open",
                        {quoted(program, open.front()), std::string(section.kind)});
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const Section& section : analysis.program().sections) {
        const SectionKind* kind = kind_of(analysis.control(), section);
        if (kind != nullptr && kind->role == SectionKind::Role::contour) look_at(analysis, section, reporter);
    }
}

} // namespace
} // namespace maclint::rules
