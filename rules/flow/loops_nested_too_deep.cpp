//! MAC315: one loop level too many.
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/structure/region_faults.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule loops_nested_too_deep{
    .code = "MAC315",
    .name = "loops-nested-too-deep",
    .summary = "Loops are nested deeper than the control allows",
    .why = "The control has only so many loop levels, whatever their numbers: it stops with an "
           "alarm, or the inner END closes the outer loop.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::loop_numbers},
    .messages = {{"plain", "Loops nested too deep: '{0}' opens level {1}, and the control has {2}.",
                  "Move the inner loop into a macro of its own."}},
    .bad = {{"fanuc", R"nc(
O9315(BLOCK)
#100=0
WHILE[#100LT5]DO1
#100=#100+1
#101=0
WHILE[#101LT5]DO2
#101=#101+1
#102=0
WHILE[#102LT5]DO3
#102=#102+1
#103=0
WHILE[#103LT5]DO1
#103=#103+1
END1
END3
END2
END1
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9315(BLOCK)
#100=0
WHILE[#100LT5]DO1
#100=#100+1
#101=0
WHILE[#101LT5]DO2
#101=#101+1
#102=0
WHILE[#102LT5]DO3
#102=#102+1
END3
END2
END1
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "124", "MISSING END STATEMENT"},
               {"FANUC 16i/18i/21i", "126", "ILLEGAL LOOP NUMBER"}},
    .sources = {"SEED-001:395", "SEED-001:407"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const flow::RegionFault& fault :
         queries::numbered_loop_faults(analysis, flow::Imbalance::nested_too_deep)) {
        const Span span = analysis.program().effects[fault.effect].span;
        reporter.report({analysis, fault.effect}, span, "plain",
                        {quoted(analysis.program(), span),
                         std::to_string(analysis.control().limits.loop_levels + 1),
                         std::to_string(analysis.control().limits.loop_levels)});
    }
}

} // namespace
} // namespace maclint::rules
