//! DIN903: slides that wait for each other for good.
#include "analyzer/queries/channels/sync_order.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule sync_deadlock{
    .code = "DIN903",
    .name = "sync-deadlock",
    .summary = "Slides wait for each other, and none of them goes on",
    .why = "The machine stands until somebody stops it, perhaps with a tool in the cut.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"both",
                  "Endless wait: slide {1} waits at '{0}' for slide {2}, which waits at '{3}' on line {4}.",
                  "Change the order of the marks in one of the slides."},
                 {"alone", "Endless wait: slide {1} waits at '{0}' for slide {2}, which comes to no M97.",
                  "Write M97 in slide {2}, too, or leave it out."}},
    .bad = {{"dinplus", R"nc(
PROGRAM HEAD
#SLIDE $1$2
MACHINING
$1 N10 G62 Q2 H1
$1 N11 G162 H2
$2 N12 G62 Q1 H2
$2 N13 G162 H1
N99 M30
END
)nc"},
            {"dinplus", R"nc(
PROGRAM HEAD
#SLIDE $1$2
MACHINING
$1 N10 M97
$2 N11 G0 X50
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
PROGRAM HEAD
#SLIDE $1$2
MACHINING
$1 N10 G162 H2
$1 N11 G62 Q2 H1
$2 N12 G62 Q1 H2
$2 N13 G162 H1
$1$2 N14 M97
$1 N15 M97 Q12
$2 N16 M97 Q12
N99 M30
END
)nc"}},
    .sources = {"SEED-003:20105-20200"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto wait = queries::find_endless_wait(analysis);
    if (!wait) return;
    const Program& program = analysis.program();
    const std::string here = quoted(program, wait->wait), slide = std::to_string(wait->channel),
                      other = std::to_string(wait->other_channel);
    if (wait->meets_nobody) {
        reporter.report({analysis, wait->wait}, wait->wait, "alone", {here, slide, other});
        return;
    }
    reporter
        .report({analysis, wait->wait}, wait->wait, "both",
                {here, slide, other, quoted(program, wait->other),
                 line_number(analysis.file(), wait->other.begin)})
        .related.push_back({analysis.source(), wait->other, "the other slide waits here"});
}

} // namespace
} // namespace maclint::rules
