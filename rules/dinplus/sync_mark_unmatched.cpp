//! DIN902: a wait for a mark that is never set.
#include "analyzer/queries/channels/sync_marks.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule sync_mark_unmatched{
    .code = "DIN902",
    .name = "sync-mark-unmatched",
    .summary = "A slide waits for a mark that the other slide never sets",
    .why = "The slide waits until somebody stops the machine.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"channel",
                  "Mark that nobody sets: '{0}' waits for mark {1} of slide {2}, which has no G162 H{1}.",
                  "Set the mark there, or correct the number."},
                 {"plain", "Mark that nobody sets: '{0}' waits for mark {1}, and there is no G162 H{1}.",
                  "Set the mark in the other slide, or correct the number."}},
    .bad = {{"dinplus", R"nc(
PROGRAM HEAD
#SLIDE $1$2
MACHINING
$1 N10 G62 Q2 H5
$2 N11 G162 H6
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
PROGRAM HEAD
#SLIDE $1$2
MACHINING
$1 N10 G62 Q2 H5
$2 N11 G162 H5
N99 M30
END
)nc"}},
    .sources = {"SEED-003:20105-20158"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    if (file.programs.empty()) return;
    const Program& program = file.programs.front(); // any: the text is the file's
    for (const queries::MarkWait& wait : queries::waits_for_nothing(file))
        reporter.report({file, wait.span}, wait.span, wait.channel ? "channel" : "plain",
                        {quoted(program, wait.span), number_word(wait.mark),
                         wait.channel ? std::to_string(*wait.channel) : ""});
}

} // namespace
} // namespace maclint::rules
