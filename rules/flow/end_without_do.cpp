//! MAC313: an END that closes nothing.
#include "analyzer/queries/structure/region_faults.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule end_without_do{
    .code = "MAC313",
    .name = "end-without-do",
    .summary = "END without an open DO",
    .why = "The control stops with an alarm when it reaches the END.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::loop_numbers},
    .messages = {{"plain", "END without DO: '{0}' closes no loop, and the control stops here.",
                  "Remove it, or correct its number."}},
    .bad = {{"fanuc", R"nc(
O9313(ROW)
#100=5
END1
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9313(ROW)
#100=0
WHILE[#100LT5]DO1
#100=#100+1
END1
M30
)nc"}},
    .alarms = {{"FANUC 30i/0i-D", "1124", "MISSING DO STATEMENT"},
               {"FANUC 16i/18i/21i", "124", "MISSING END STATEMENT"}},
    .sources = {"GH-ALM"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const flow::RegionFault& fault :
         queries::numbered_loop_faults(analysis, flow::Imbalance::never_opened)) {
        const Span span = analysis.program().effects[fault.effect].span;
        reporter.report({analysis, fault.effect}, span, "plain", {quoted(analysis.program(), span)});
    }
}

} // namespace
} // namespace maclint::rules
