//! MAC614: a program returns under the limit of look-ahead that it has switched on.
#include "analyzer/flow/graph.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/timing/look_ahead_limit_left_on_finder.hpp"
#include "rules/trace.hpp"

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule look_ahead_limit_left_on{
    .code = "MAC614",
    .name = "look-ahead-limit-left-on",
    .summary = "A program limits look-ahead, ends that on one way, and returns on another with the limit on",
    .why = "The caller goes on block by block: contours of short blocks are cut slowly and leave marks, and "
           "cutter "
           "compensation, which needs the blocks ahead, stops with an alarm.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .data_flow = true,
    .messages =
        {{"returns",
          "Look-ahead still limited: '{0}' returns under the limit of line {1}, which line {2} ends on "
          "another way.",
          "End it here, too, with '{3}' before the return."}},
    .bad = {{"fanuc", R"nc(
O9614(CLAMP, C 0 OR 1)
G103 P1
IF[#3EQ1]GOTO2
#1101=1
M99
N2 #1101=0
G103 P0
M99
)nc"}},
    .good = {{"fanuc", R"nc(
O9614(CLAMP, C 0 OR 1)
G103 P1
IF[#3EQ1]GOTO2
#1101=1
G103 P0
M99
N2 #1101=0
G103 P0
M99
)nc"}},
    .sources = {"H07:91", "HAAS-LA"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto left = limit_left_on(analysis);
    if (!left) return;
    const Program& program = analysis.program();
    for (const flow::NodeId node : left->returns) {
        const Span span = analysis.graph().nodes[node].part;
        Finding& finding =
            reporter.report({analysis, span}, span, "returns",
                            {quoted(program, span), line_number(analysis.file(), left->limit),
                             line_number(analysis.file(), left->end.begin), quoted(program, left->end)});
        finding.related.push_back({analysis.source(), left->end, "it is ended here"});
        trace(finding, analysis, node, "it returns");
        finding.same_cause = line_number(analysis.file(), left->limit);
    }
}

} // namespace
} // namespace maclint::rules
