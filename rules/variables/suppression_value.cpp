//! MAC232: #3003 or #3004 is set to a number that none of its bits are.
#include "analyzer/program/tables.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <cmath>
#include <cstddef>
#include <string>
#include <variant>

namespace maclint::rules {

namespace {
void check(const ProgramFile& file, Reporter& reporter);
}

extern const Rule suppression_value{
    .code = "MAC232",
    .name = "suppression-value-out-of-range",
    .summary = "#3003 is set to another number than 0 to 3, or #3004 to another than 0 to 7",
    .why = "Each bit of the number switches one thing off: single block, the wait for M, S and T; feed hold, "
           "override, exact stop. Of any other number no document tells what stays switched off.",
    .severity = Severity::warning,
    .precision = Precision::very_high,
    .needs = {Capability::suppression},
    .messages = {{"plain", "Value out of range: '{0}' sets {1}, which takes 0 to {2}.",
                  "Correct the number."}},
    .bad = {{"fanuc", R"nc(
O9232(NO HOLD)
#3004=8
G1 Z-5. F50.
#3004=0
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9232(NO HOLD)
#3003=3
#3004=7
G1 Z-5. F50.
#3003=0
#3004=0
M99
)nc"}},
    .sources = {"SEED-001:214-220", "SEED-001:226-234"},
    .check = &check,
};

namespace {

void check(const ProgramFile& file, Reporter& reporter) {
    for (const Program& program : file.programs)
        for (const Effect& effect : program.effects) {
            const auto* set = std::get_if<SetModal>(&effect.what);
            if (set == nullptr || !set->group) continue;
            const ModalGroup& group = program.control->groups[*set->group];
            const auto* value = std::get_if<Literal>(&program.expressions[set->value].node);
            const std::size_t bits = group.switched_off.size();
            if (value == nullptr || bits == 0) continue;
            const double most = std::exp2(static_cast<double>(bits)) - 1;
            if (value->value >= 0 && value->value <= most && value->value == std::floor(value->value))
                continue;
            reporter.report({file, effect.span}, effect.span, "plain",
                            {quoted(program, effect.span), std::string(group.name), number_word(most)});
        }
}

} // namespace
} // namespace maclint::rules
