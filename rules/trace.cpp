//! Paths of findings, made of the paths through the flow graph.
#include "rules/trace.hpp"

#include "analyzer/queries/origins.hpp"
#include "rules/path.hpp"

#include <utility>

namespace maclint::rules {
namespace {

void add_path(std::vector<RelatedLocation>& related, const ProgramAnalysis& analysis, flow::NodeId from,
              flow::NodeId to) {
    if (from == to) return;
    for (RelatedLocation& step : path_between(analysis, from, to)) related.push_back(std::move(step));
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
    add_path(finding.path, analysis, from, node);
    finding.path.push_back({finding.source, finding.span, std::move(ends)});
}

void trace(Finding& finding, const ProgramAnalysis& analysis, flow::NodeId node, std::string ends) {
    add_path(finding.path, analysis, 0, node);
    finding.path.push_back({finding.source, finding.span, std::move(ends)});
}

void report_path_on(Finding& finding, const ProgramAnalysis& analysis, flow::NodeId from, flow::NodeId node) {
    add_path(finding.related, analysis, from, node);
}

void trace_round(Finding& finding, const ProgramAnalysis& analysis, const dataflow::Loop& loop,
                 std::string ends) {
    add_path(finding.path, analysis, 0, loop.head);
    add_path(finding.path, analysis, loop.head, loop.latch);
    const flow::Node& latch = analysis.graph().nodes[loop.latch];
    finding.path.push_back({finding.source, latch.part, "the loop goes back to its head here"});
    finding.path.push_back({finding.source, finding.span, std::move(ends)});
}

} // namespace maclint::rules
