//! MAC316: loops that overlap.
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/region_faults.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule crossed_loops{
    .code = "MAC316",
    .name = "crossed-loops",
    .aliases = "",
    .summary = "Two loops cross: the outer one ends inside the inner one",
    .why = "The control pairs END with the loop that is open: it stops with an alarm, or repeats"
           " other blocks than the author meant.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .on_by_default = true,
    .off_reason = "",
    .data_flow = false,
    .messages = {{"plain",
                  "'{0}' ends its loop while the loop of '{1}' inside it is still open. Exchange the "
                  "two ENDs."}},
    .bad = {{"fanuc", "O9316(GRID)\n"
                      "#100=0\n"
                      "#101=0\n"
                      "WHILE[#100LT5]DO1\n"
                      "#100=#100+1\n"
                      "WHILE[#101LT5]DO2\n"
                      "#101=#101+1\n"
                      "END1\n"
                      "END2\n"
                      "M30\n"}},
    .good = {{"fanuc", "O9316(GRID)\n"
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
    .sources = {"SEED-001:407"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const flow::RegionFault& fault : numbered_loop_faults(analysis, flow::Imbalance::crossed)) {
        const Span span = analysis.program().effects[fault.effect].span;
        Finding& finding = reporter.report(
            analysis.file(), span, "plain",
            {quoted(analysis.program(), span),
             fault.other ? quoted(analysis.program(), analysis.program().effects[*fault.other].span)
                         : std::string()});
        if (fault.other)
            finding.related.push_back(
                related_at_effect(analysis, *fault.other, "the inner loop begins here"));
    }
}

} // namespace
} // namespace maclint::rules
