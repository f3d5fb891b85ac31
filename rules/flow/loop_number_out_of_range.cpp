//! MAC314: a loop number that the control does not have.
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

extern const Rule loop_number_out_of_range{
    .code = "MAC314",
    .name = "loop-number-out-of-range",
    .summary = "The number of a loop is not one that the control has",
    .why = "The control stops with an alarm at the DO.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::loop_numbers},
    .messages = {{"plain", "Loop number out of range: '{0}' uses one that the control does not have.",
                  "Use {1} to {2}."},
                 {"assumed",
                  "Loop number out of range: the assumed control has no number as high as in '{0}'.",
                  "Use {1} to {2}; or, if the control has more, name it (--control), or say so in the "
                  "configuration (\"loop-numbers\")."}},
    .bad = {{"fanuc", R"nc(
O9314(ROW)
#100=0
WHILE[#100LT5]DO4
#100=#100+1
END4
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9314(ROW)
#100=0
WHILE[#100LT5]DO3
#100=#100+1
END3
M30
)nc"}},
    .alarms = {{"FANUC 16i/18i/21i", "126", "ILLEGAL LOOP NUMBER"},
               {"FANUC 30i/0i-D", "126", "ILLEGAL LOOP NUMBER"}},
    .sources = {"SEED-001:395", "ISORP", "GH-ALM"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const flow::RegionFault& fault :
         queries::numbered_loop_faults(analysis, flow::Imbalance::number_out_of_range)) {
        const ControlModel& control = analysis.control();
        const Effect& effect = analysis.program().effects[fault.effect];
        const auto number = std::get<RegionMark>(effect.what).number;
        const bool elsewhere = control.limits_at_most && number &&
                               *number >= control.limits_at_most->first_loop_number &&
                               *number <= control.limits_at_most->last_loop_number;
        Finding& finding = reporter.report(
            {analysis, fault.effect}, effect.span, elsewhere ? "assumed" : "plain",
            {quoted(analysis.program(), effect.span), std::to_string(control.limits.first_loop_number),
             std::to_string(control.limits.last_loop_number)});
        if (!elsewhere) continue;
        finding.severity = Severity::warning;
        finding.alarm = {};
    }
}

} // namespace
} // namespace maclint::rules
