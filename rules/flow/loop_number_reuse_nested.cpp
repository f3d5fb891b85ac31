//! MAC317: a loop number that is in use.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/region_faults.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule loop_number_reuse_nested{
    .code = "MAC317",
    .name = "loop-number-reuse-nested",
    .aliases = "",
    .summary = "An inner loop uses the number of a loop that is still open",
    .why = "The control cannot tell the two loops apart: it stops with an alarm, or the first "
           "END closes both.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = false,
    .messages = {{"plain", "'{0}' uses the number of a loop that is still open. Give the inner loop another "
                           "number."}},
    .bad = {{"fanuc", "O9317(GRID)\n"
                      "#100=0\n"
                      "#101=0\n"
                      "WHILE[#100LT5]DO1\n"
                      "#100=#100+1\n"
                      "WHILE[#101LT5]DO1\n"
                      "#101=#101+1\n"
                      "END1\n"
                      "END1\n"
                      "M30\n"}},
    .good = {{"fanuc", "O9317(GRID)\n"
                       "#100=0\n"
                       "#101=0\n"
                       "WHILE[#100LT5]DO1\n"
                       "#100=#100+1\n"
                       "WHILE[#101LT5]DO2\n"
                       "#101=#101+1\n"
                       "END2\n"
                       "END1\n"
                       "M30\n"}},
    .alarms = {{"FANUC 16i/18i/21i", "124", "MISSING END STATEMENT"}},
    .sources = {"SEED-001:407", "ISORP"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const flow::RegionFault& fault : numbered_loop_faults(analysis, flow::Imbalance::number_reused)) {
        const Span span = analysis.program().effects[fault.effect].span;
        Finding& finding =
            reporter.report(analysis.file(), span, "plain", {quoted(analysis.program(), span)});
        if (fault.other)
            finding.related.push_back(
                related_at_effect(analysis, *fault.other, "the loop with this number is open since here"));
    }
}

} // namespace
} // namespace maclint::rules
