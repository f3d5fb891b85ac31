//! DIN619: G41 or G42 is still on at a tool change or at the end.
#include "analyzer/dataflow/facts/call_made.hpp"
#include "analyzer/dataflow/facts/clobber.hpp"
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/dataflow/facts/modal_write.hpp"
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/left_active.hpp"
#include "analyzer/queries/modal/modal_leaks.hpp"
#include "analyzer/queries/modal/modal_parts.hpp"
#include "analyzer/queries/values/origins.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "rules/dinplus/left_active.hpp"
#include "rules/path.hpp"
#include "rules/rule.hpp"
#include "rules/trace.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace maclint::rules {

namespace {
void check(const ProgramAnalysis& analysis, Reporter& reporter);
}

extern const Rule radius_comp_not_cancelled{
    .code = "DIN619",
    .name = "radius-comp-not-cancelled",
    .summary = "G41 or G42 is still active at T, G14, a change of the plane or the end of the program",
    .why = "The next tool is moved beside its path by the radius of its own tip, and G14 is not allowed "
           "while the compensation is being switched off.",
    .severity = Severity::error,
    .precision = Precision::high,
    .facts = dataflow::facts<dataflow::BeforeToolChange, dataflow::BeforeWatchedWord, dataflow::ModalWrite,
                             dataflow::CallMade, dataflow::ExitState, dataflow::Store, dataflow::Clobber>(),
    .data_flow = true,
    .messages = {{"tool", "Radius compensation left on: '{0}' is still active at '{2}' on line {3}.",
                  "Write {1} before line {3}."},
                 {"every-path", "Radius compensation left on: '{0}' is still active when the program ends.",
                  "Write {1} before the end."},
                 {"some-paths", "Radius compensation left on: '{0}' is active on some paths to the end.",
                  "Write {1} on those, too."}},
    .bad = {{"dinplus", R"nc(
MACHINING
N10 T2
N11 G0 X18 Z3
N12 G42
N13 G1 Z-30
N14 G0 X36 Z5
N15 G14 Q0
N16 M30
END
)nc"},
            {"dinplus", R"nc(
MACHINING
N10 T2
N11 G0 X18 Z3
N12 G42
N13 G1 Z-30
N14 G0 X36 Z5
N15 M30
END
)nc"}},
    .good = {{"dinplus", R"nc(
MACHINING
N10 T2
N11 G0 X18 Z3
N12 G42
N13 G1 Z-30
N14 G40
N15 G0 X36 Z5
N16 G14 Q0
N17 M30
END
)nc"}},
    .sources = {"SEED-003:12675-12680"},
    .check = &check,
};

namespace {

constexpr ModalRole compensation = ModalRole::cutter_compensation;

/// Where the compensation must be off: tool changes and changes of the plane.
std::vector<dataflow::PointState> find_points(const ProgramAnalysis& analysis) {
    const auto changes = analysis.facts().all<dataflow::BeforeToolChange>();
    std::vector<dataflow::PointState> points(changes.begin(), changes.end());
    std::ranges::copy_if(analysis.facts().all<dataflow::BeforeWatchedWord>(), std::back_inserter(points),
                         [&](const dataflow::PointState& point) {
                             return queries::sets_another_code(analysis, point, ModalRole::plane);
                         });
    std::ranges::stable_sort(points, {}, &dataflow::PointState::effect);
    return points;
}

void report_at_tool(const ProgramAnalysis& analysis, GroupId group, const dataflow::ModalPart& part,
                    flow::NodeId set, const dataflow::PointState& change, Reporter& reporter) {
    const Span span = queries::span_of_origin(analysis, part.origin);
    const Span there = analysis.program().effects[change.effect].span;
    auto words = words_of(analysis, group, *queries::own_code(analysis, part));
    words.push_back(quoted(analysis.program(), there));
    words.push_back(line_number(analysis.file(), there.begin));
    Finding& finding = reporter.report(cause_at(analysis, part.origin), span, "tool", std::move(words));
    trace(finding, analysis, set, "the compensation is switched on here");
    report_path_on(finding, analysis, set, change.node);
    finding.related.push_back(related_at_effect(analysis, change.effect, "it is still active here"));
}

void check(const ProgramAnalysis& analysis, Reporter& reporter) {
    const auto group = queries::find_own_group(analysis.control(), compensation);
    if (!group) return;
    queries::Lasting lasting(analysis);
    std::set<dataflow::OriginId> reported; // one finding for each block that switches it on
    for (const queries::ModalLeak& leak : queries::left_at_return(analysis)) // those are reported as such
        if (leak.group == *group) reported.insert(leak.part.origin);
    for (const dataflow::PointState& change : find_points(analysis)) {
        const dataflow::ModalValue value = analysis.data().modal(change, *group);
        if (value.unknown) continue;
        for (const dataflow::ModalPart& part : value.parts) {
            if (!queries::is_switched_on(analysis, analysis.control().groups[*group], part)) continue;
            const flow::NodeId set = queries::node_of_origin(analysis, part.origin);
            if (reported.contains(part.origin) || !lasting.until(change.node, *group, set)) continue;
            reported.insert(part.origin);
            report_at_tool(analysis, *group, part, set, change, reporter);
        }
    }
    const auto leak = queries::left_at_end(analysis, compensation);
    if (leak && !reported.contains(leak->part.origin)) report_left_at_end(analysis, compensation, reporter);
}

} // namespace
} // namespace maclint::rules
