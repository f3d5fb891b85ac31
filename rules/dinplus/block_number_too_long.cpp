//! DIN004: a block number with more digits than the control reads.
#include "analyzer/program/block_view.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule block_number_too_long{
    .code = "DIN004",
    .name = "block-number-too-long",
    .summary = "A block number has more than five digits",
    .why = "The control reads block numbers of five digits at most: a longer one is refused, or names "
           "another block"
           " than the one that NS and NE mean.",
    .severity = Severity::error,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"long", "Block number '{0}' has more than five digits.", "Number the blocks anew."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N100000 G0 X80 Z5
N100001 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N99998 G0 X80 Z5
N99999 M30
END
)nc"}},
    .sources = {"SEED-003:2237"},
    .check = &check,
};

namespace {

constexpr std::int64_t greatest = 99'999;

struct TooLong {
    bool operator()(std::int64_t number) const { return number > greatest; }
    [[nodiscard]] static bool between(std::int64_t /*lowest*/, std::int64_t highest) {
        return highest > greatest;
    }
};

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const Program& program = analysis.program();
    bool is_told = false; // one number too long is followed by many
    for (const Section& section : program.sections)
        for_each_numbered_block(program, section, TooLong{}, [&](const BlockView& block) {
            if (is_told) return;
            is_told = true;
            reporter.report({analysis, block.number_span}, block.number_span, "long",
                            {quoted(program, block.number_span)});
        });
}

} // namespace
} // namespace maclint::rules
