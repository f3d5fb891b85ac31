//! MAC413: a modal macro call that stays on.
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/paths/exits.hpp"
#include "analyzer/queries/values/origins.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/fixes.hpp"
#include "rules/modal/modal_leak.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <set>
#include <string>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule g66_not_cancelled{
    .code = "MAC413",
    .name = "g66-not-cancelled",
    .summary = "A modal macro call is still active at the end of the program or at a tool change",
    .why = "Every later move calls the macro: the next positioning block drills, probes or mills"
           " where nobody expects it.",
    .severity = Severity::warning,
    .precision = Precision::high,
    .needs = {Capability::modal_calls},
    .yields_to = "MAC415",
    .facts = dataflow::facts<dataflow::BeforeToolChange, dataflow::ExitState>(),
    .data_flow = true,
    .messages =
        {{"end",
          "Modal call left active: '{0}' is still active when the program is left, so every later move calls "
          "the macro.",
          "Write {2} before the program is left."},
         {"tool",
          "Modal call at a tool change: '{0}' is still active on line {1}, whose moves call the macro.",
          "Write {2} before line {1}."}},
    .bad = {{"fanuc", R"nc(
O9413(ROW)
G66P9010Z-20.R5.
G0 X10.
X20.
M30
)nc"}},
    .good = {{"fanuc", R"nc(
O9413(ROW)
G66P9010Z-20.R5.
G0 X10.
X20.
G67
M30
)nc"}},
    .sources = {"SEED-001:466", "CNCWIKI-CALL"},
    .check = &check,
};

namespace {

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto group = analysis.control().group_with(ModalRole::macro_call);
    if (!group) return;
    const std::string off = words_to_cancel(analysis.control(), *group);
    std::set<dataflow::OriginId> said;
    const auto report = [&](dataflow::OriginId call, flow::NodeId node, std::string_view message, Span left) {
        if (!said.insert(call).second) return;
        const Span span = queries::span_of_origin(analysis, call);
        Finding& finding = reporter.report(
            cause_at(analysis, call), span, message,
            {quoted(analysis.program(), span), line_number(analysis.file(), left.begin), off});
        offer_block_before(finding, Applicability::unsafe, left, off);
        finding.path.push_back({analysis.source(), span, "the modal call begins here"});
        for (RelatedLocation& step : path_between(analysis, queries::node_of_origin(analysis, call), node))
            finding.path.push_back(std::move(step));
        finding.path.push_back({analysis.source(), left, "it is still active here"});
    };
    for (const dataflow::PointState& change : analysis.facts().all<dataflow::BeforeToolChange>())
        for (const dataflow::OriginId call : analysis.own_modal_calls(change.state, change.node))
            report(call, change.node, "tool", analysis.program().effects[change.effect].span);
    for (const dataflow::ExitState& exit : analysis.facts().all<dataflow::ExitState>()) {
        if (exit.exit.kind == flow::ExitKind::alarm) continue;
        const Span left = queries::span_of_exit(analysis, exit.exit);
        for (const dataflow::OriginId call : analysis.own_modal_calls(exit.state, exit.exit.node))
            report(call, exit.exit.node, "end", left);
    }
}

} // namespace
} // namespace maclint::rules
