//! MAC464: a sequence number that the control does not have.
#include "analyzer/dialect/number_limits.hpp"
#include "analyzer/program/model.hpp"
#include "rules/calls/block_numbers.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule sequence_number_range{
    .code = "MAC464",
    .name = "sequence-number-range",
    .summary = "A sequence number is greater than the control takes",
    .why =
        "Series 16i numbers blocks from 1 to 99999, the 30i and the 0i-D to 99999999. The control stops at "
        "a longer number, mostly in the middle of a long program from CAM.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::sequence_numbers},
    .messages = {{"plain", "Sequence number too great: '{0}', and the control has them up to {1}.",
                  "Number the blocks in smaller steps, or only those that something jumps to."}},
    .bad = {{"fanuc", R"nc(
O9464(POCKET)
N1 G90 G0 X0
N100000000 G0 Y0
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9464(POCKET)
N99999 G90 G0 X0
N100000 G0 Y0
M30
)nc"}},
    .sources = {"MAN-PB129", "NCT-9", "GH-ALM"},
    .check = &check,
};

namespace {

/// The first one of a program: those behind it are mostly as great.
void check(const ProgramFile& file, Reporter& reporter) {
    for (const Program& program : file.programs) {
        const NumberLimits* limits = number_limits(*program.control);
        if (limits == nullptr) continue;
        const auto great = first_number_outside(program, 0, limits->last_block);
        if (!great) continue;
        Finding& finding =
            reporter.report({file, great->span}, great->span, "plain",
                            {std::string(program.slice(great->span)), std::to_string(limits->last_block)});
        if (program.control->assumed) finding.severity = Severity::warning;
    }
}

} // namespace
} // namespace maclint::rules
