//! Paths of findings, made of the paths through the flow graph.
#include "rules/trace.hpp"

#include "analyzer/queries/feasible_paths.hpp"
#include "analyzer/queries/origins.hpp"
#include "rules/path.hpp"

#include <algorithm>
#include <utility>

namespace maclint::rules {
namespace {

/// Adds the steps of a path that the control can take; the finding takes note of it where there is none.
void add_path(Finding& finding, std::vector<RelatedLocation>& to_list, const ProgramAnalysis& analysis,
              flow::NodeId from, flow::NodeId to) {
    const execution::PathFound found = queries::path_on_from(analysis, from, to);
    if (!found.path) finding.proof = found.gave_up ? std::max(finding.proof, Proof::gave_up) : Proof::no_path;
    if (from == to || (found.gave_up && found.visits == 0)) return; // no more searches, nor steps
    for (RelatedLocation& step :
         found.path ? steps_along(analysis, *found.path) : path_between(analysis, from, to))
        to_list.push_back(std::move(step));
}

} // namespace

void trace(Finding& finding, const ProgramAnalysis& analysis, dataflow::OriginId origin, std::string begins,
           flow::NodeId node, std::string ends) {
    trace(finding, analysis, queries::node_of_origin(analysis, origin),
          related_at(analysis, origin, std::move(begins)), node, std::move(ends));
}

void trace(Finding& finding, const ProgramAnalysis& analysis, flow::NodeId from, RelatedLocation begins,
           flow::NodeId node, std::string ends) {
    finding.path.push_back(std::move(begins));
    add_path(finding, finding.path, analysis, from, node);
    finding.path.push_back({finding.source, finding.span, std::move(ends)});
}

void trace(Finding& finding, const ProgramAnalysis& analysis, flow::NodeId node, std::string ends) {
    add_path(finding, finding.path, analysis, 0, node);
    finding.path.push_back({finding.source, finding.span, std::move(ends)});
}

void report_path_on(Finding& finding, const ProgramAnalysis& analysis, flow::NodeId from, flow::NodeId node) {
    add_path(finding, finding.related, analysis, from, node);
}

void trace_round(Finding& finding, const ProgramAnalysis& analysis, const dataflow::Loop& loop,
                 std::string ends) {
    add_path(finding, finding.path, analysis, 0, loop.head);
    add_path(finding, finding.path, analysis, loop.head, loop.latch);
    const flow::Node& latch = analysis.graph().nodes[loop.latch];
    finding.path.push_back({finding.source, latch.part, "the loop goes back to its head here"});
    finding.path.push_back({finding.source, finding.span, std::move(ends)});
}

} // namespace maclint::rules
