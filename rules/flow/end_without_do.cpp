//! MAC313: an END that closes nothing.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/region_faults.hpp"
#include "rules/rule.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule end_without_do{
    .code = "MAC313",
    .name = "end-without-do",
    .aliases = "",
    .summary = "END without an open DO",
    .why = "The control stops with an alarm when it reaches the END.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = false,
    .messages = {{"plain",
                  "'{0}' closes no loop, and the control stops here. Remove it, or correct its number."}},
    .bad = {{"fanuc", "O9313(ROW)\n"
                      "#100=5\n"
                      "END1\n"
                      "M30\n"}},
    .good = {{"fanuc", "O9313(ROW)\n"
                       "#100=0\n"
                       "WHILE[#100LT5]DO1\n"
                       "#100=#100+1\n"
                       "END1\n"
                       "M30\n"}},
    .alarms = {{"FANUC 30i/0i-D", "1124", "MISSING DO STATEMENT"},
               {"FANUC 16i/18i/21i", "124", "MISSING END STATEMENT"}},
    .sources = {"GH-ALM"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const flow::RegionFault& fault : numbered_loop_faults(analysis, flow::Imbalance::never_opened)) {
        const Span span = analysis.program().effects[fault.effect].span;
        reporter.report(analysis.file(), span, "plain", {quoted(analysis.program(), span)});
    }
}

} // namespace
} // namespace maclint::rules
