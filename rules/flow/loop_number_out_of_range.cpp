//! MAC314: a loop number that the control does not have.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/region_faults.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule loop_number_out_of_range{
    .code = "MAC314",
    .name = "loop-number-out-of-range",
    .aliases = "",
    .summary = "The number of a loop is not one that the control has",
    .why = "The control stops with an alarm at the DO.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = false,
    .messages = {{"plain", "'{0}' uses a loop number that the control does not have. Use {1} to {2}."}},
    .bad = {{"fanuc", "O9314(ROW)\n"
                      "#100=0\n"
                      "WHILE[#100LT5]DO4\n"
                      "#100=#100+1\n"
                      "END4\n"
                      "M30\n"}},
    .good = {{"fanuc", "O9314(ROW)\n"
                       "#100=0\n"
                       "WHILE[#100LT5]DO3\n"
                       "#100=#100+1\n"
                       "END3\n"
                       "M30\n"}},
    .alarms = {{"FANUC 16i/18i/21i", "126", "ILLEGAL LOOP NUMBER"}},
    .sources = {"SEED-001:395", "ISORP"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const flow::RegionFault& fault :
         numbered_loop_faults(analysis, flow::Imbalance::number_out_of_range)) {
        const Span span = analysis.program().effects[fault.effect].span;
        reporter.report(analysis.file(), span, "plain",
                        {quoted(analysis.program(), span),
                         std::to_string(analysis.control().limits.first_loop_number),
                         std::to_string(analysis.control().limits.last_loop_number)});
    }
}

} // namespace
} // namespace maclint::rules
