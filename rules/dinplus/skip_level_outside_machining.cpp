//! DIN020: a skip level where no block is skipped.
#include "analyzer/program/model.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule skip_level_outside_machining{
    .code = "DIN020",
    .name = "skip-level-outside-machining",
    .summary = "A block outside of MACHINING has a skip level",
    .why = "Skip levels are for the blocks of MACHINING: what the control makes of others is not said, "
           "and a contour may lack an element.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sections},
    .messages = {{"plain", "Skip level outside of MACHINING: '{0}' belongs to {1}.",
                  "Remove the level, and decide by IF in MACHINING."}},
    .bad = {{"dinplus", R"nc(
FINISHED
N1 G0 X0 Z0
/1 N2 G1 X60
N3 G1 Z-50
MACHINING
N10 T1
N99 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
FINISHED
N1 G0 X0 Z0
N2 G1 X60
N3 G1 Z-50
MACHINING
/1 N10 T1
N99 M30
END
)nc"}},
    .sources = {"SEED-003:19892-19900"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    for (const Program& program : file.programs)
        for (const Section& section : program.sections) {
            if (section.executed == Section::Executed::when_reached) continue;
            for (ItemId item = section.items.first; item < section.items.first + section.items.count; ++item)
                if (const auto* block = std::get_if<Block>(&program.items[item]);
                    block != nullptr && block->skip_levels != 0)
                    reporter.report({file, block->span}, block->span, "plain",
                                    {quoted(program, block->span), std::string(section.kind)});
        }
}

} // namespace
} // namespace maclint::rules
