//! DIN415: M99 NS names a block that is not there.
#include "analyzer/program/numbered_blocks.hpp"
#include "analyzer/program/section_kinds.hpp"
#include "analyzer/queries/structure/wrong_places.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule m99_target{
    .code = "DIN415",
    .name = "m99-target",
    .summary = "M99 NS restarts at a block that the machining part does not have",
    .why = "At the end of the part the control looks for the block, does not find it and stops with an "
           "error: the bar feeds no further part.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::sequence_numbers},
    .messages = {{"missing", "Missing restart block: '{0}' restarts at N{1}, which does not exist.",
                  "Correct the number."},
                 {"elsewhere", "Restart outside the machining: '{0}' restarts at N{1}, which stands in {2}.",
                  "Name a block of the machining part."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 G14 Q0
N20 T1
N30 G0 X0 Z2
N40 M99 NS15
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 G14 Q0
N20 T1
N30 G0 X0 Z2
N40 M99 NS20
END
)nc"}},
    .sources = {"SEED-003:20021"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    queries::WrongPlaces places(analysis.file(), [](const NumberedBlock& block) {
        return block.section == nullptr || block.section->role == SectionKind::Role::machining;
    });
    for (const BlockUser& user : find_block_users(program)) {
        if (!user.restarts) continue;
        const auto& elsewhere = places.of(user.number);
        if (!elsewhere) continue;
        const Span span = program.effects[user.effect].span;
        reporter.report({analysis, user.effect}, span, elsewhere->empty() ? "missing" : "elsewhere",
                        {quoted(program, span), std::to_string(user.number), *elsewhere});
    }
}

} // namespace
} // namespace maclint::rules
