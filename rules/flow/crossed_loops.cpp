//! MAC316: loops that overlap.
#include "analyzer/queries/structure/region_faults.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"

#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule crossed_loops{
    .code = "MAC316",
    .name = "crossed-loops",
    .summary = "Two loops cross: the outer one ends inside the inner one",
    .why = "The control pairs END with the loop that is open: it stops with an alarm, or repeats"
           " other blocks than the author meant.",
    .severity = Severity::error,
    .precision = Precision::very_high,
    .needs = {Capability::loop_numbers},
    .messages = {{"plain",
                  "Crossed loops: '{0}' ends its loop while the loop of '{1}' inside it is still open.",
                  "Exchange the two ENDs."}},
    .bad = {{"fanuc", R"nc(
O9316(GRID)
#100=0
WHILE[#100LT5]DO1
#100=#100+1
#101=0
WHILE[#101LT5]DO2
#101=#101+1
END1
END2
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9316(GRID)
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
    .sources = {"SEED-001:407", "GH-ALM"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    for (const flow::RegionFault& fault : queries::numbered_loop_faults(analysis, flow::Imbalance::crossed)) {
        const Span span = analysis.program().effects[fault.effect].span;
        Finding& finding = reporter.report(
            {analysis, fault.effect}, span, "plain",
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
