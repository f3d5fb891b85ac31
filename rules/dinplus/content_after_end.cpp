//! DIN103: blocks after END.
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/section_kinds.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule content_after_end{
    .code = "DIN103",
    .name = "content-after-end",
    .summary = "Blocks or sections after the word that closes the program",
    .why = "The control reads a program up to END: what stands after it never runs.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain", "Block after the end: '{0}' stands after {1} on line {2} and never runs.",
                  "Move it before {1}, or remove it."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 G14 Q0
N20 M30
END
N30 G0 X0
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 G14 Q0
N20 G0 X0
N30 M30
END
)nc"}},
    .sources = {"SEED-003:2941"},
    .check = &check,
};

namespace {

/// The first thing after the heading; empty when nothing is there.
Span first_behind(const ProgramFile& file, Span heading) {
    Span first{};
    const auto take = [&](Span span) {
        const bool after = span.begin >= heading.end && span.end > span.begin;
        if (after && (first.end == 0 || span.begin < first.begin)) first = span;
    };
    for (const Program& program : file.programs) {
        for (const Section& section : program.sections) {
            take(section.heading);
            for_each_block(program, section, [&](const BlockView& block) {
                take(block.span);
                return block.span.begin < heading.end;
            });
        }
    }
    return first;
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    for (const Section& section : program.sections) {
        const SectionKind* kind = kind_of(analysis.control(), section);
        if (kind == nullptr || kind->role != SectionKind::Role::end) continue;
        const Span first = first_behind(analysis.file(), section.heading);
        if (first.end == 0) return;
        reporter.report({analysis, first}, first, "plain",
                        {quoted(program, first), quoted(program, section.heading),
                         line_number(analysis.file(), section.heading.begin)});
        return;
    }
}

} // namespace
} // namespace maclint::rules
