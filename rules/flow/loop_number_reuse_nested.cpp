//! MAC317: a loop number that is in use.
#include "analyzer/queries/structure/region_faults.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule loop_number_reuse_nested{
    .code = "MAC317",
    .name = "loop-number-reuse-nested",
    .summary = "An inner loop uses the number of a loop that is still open",
    .why = "The control cannot tell the two loops apart: it stops with an alarm, or the first "
           "END closes both.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::loop_numbers},
    .messages = {{"plain", "Loop number used twice: '{0}' uses the number of a loop that is still open.",
                  "Give the inner loop another number."}},
    .bad = {{"fanuc", R"nc(
O9317(GRID)
#100=0
WHILE[#100LT5]DO1
#100=#100+1
#101=0
WHILE[#101LT5]DO1
#101=#101+1
END1
END1
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9317(GRID)
#100=0
WHILE[#100LT5]DO1
#100=#100+1
#101=0
WHILE[#101LT5]DO2
#101=#101+1
END2
END1
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "124", "MISSING END STATEMENT"},
               {"FANUC 30i/0i-D", "124", "MISSING END STATEMENT"}},
    .sources = {"SEED-001:407", "ISORP", "GH-ALM"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const flow::RegionFault& fault :
         queries::numbered_loop_faults(analysis, flow::Imbalance::number_reused)) {
        const Span span = analysis.program().effects[fault.effect].span;
        Finding& finding =
            reporter.report({analysis, fault.effect}, span, "plain", {quoted(analysis.program(), span)});
        if (fault.other)
            finding.related.push_back(
                related_at_effect(analysis, *fault.other, "the loop with this number is open since here"));
    }
}

} // namespace
} // namespace maclint::rules
