//! MAC463: a block with the number 0.
#include "analyzer/dialect/number_limits.hpp"
#include "analyzer/program/model.hpp"
#include "rules/calls/block_numbers.hpp"
#include "rules/rule.hpp"

#include <limits>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule sequence_number_zero{
    .code = "MAC463",
    .name = "sequence-number-zero",
    .summary = "A block has the sequence number 0",
    .why = "N0 must not be used: a program whose first block has it may be stored under another number, and "
           "no jump goes there.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::sequence_numbers},
    .messages = {{"plain", "Sequence number 0: the manual forbids '{0}', and no jump finds it.",
                  "Give the block another number."}},
    .bad = {{"fanuc", R"nc(
O9463(PLATE)
N0 G90 G0 X0
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9463(PLATE)
N1 G90 G0 X0
M30
)nc"}},
    .sources = {"MAN-PB129"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    for (const Program& program : file.programs) {
        if (number_limits(*program.control) == nullptr) continue;
        if (const auto zero = first_number_outside(program, 1, std::numeric_limits<std::int64_t>::max()))
            reporter.report({file, zero->span}, zero->span, "plain",
                            {std::string(program.slice(zero->span))});
    }
}

} // namespace
} // namespace maclint::rules
