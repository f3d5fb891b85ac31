//! Paths of findings, made of the paths through the flow graph.
#include "rules/trace.hpp"

#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/calls/provoking_calls.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/queries/values/origins.hpp"
#include "rules/path.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace maclint::rules {
namespace {

using Edges = std::vector<flow::EdgeId>;

/// The edges of a path that the control can take; the finding takes note of it where there is none.
std::optional<Edges> find_path(Finding& finding, const ProgramAnalysis& analysis, flow::NodeId from,
                               flow::NodeId to) {
    execution::PathFound found = queries::path_on_from(analysis, from, to);
    if (!found.path) finding.proof = found.gave_up ? std::max(finding.proof, Proof::gave_up) : Proof::no_path;
    if (found.gave_up && found.visits == 0) return Edges{}; // no more searches, nor steps that explain
    return std::move(found.path);
}

void add_steps(std::vector<RelatedLocation>& to_list, const ProgramAnalysis& analysis,
               const std::optional<Edges>& path, flow::NodeId from, flow::NodeId to) {
    if (from == to) return;
    for (RelatedLocation& step : path ? steps_along(analysis, *path) : path_between(analysis, from, to))
        to_list.push_back(std::move(step));
}

void add_path(Finding& finding, std::vector<RelatedLocation>& to_list, const ProgramAnalysis& analysis,
              flow::NodeId from, flow::NodeId to) {
    add_steps(to_list, analysis, find_path(finding, analysis, from, to), from, to);
}

} // namespace

void trace(Finding& finding, const ProgramAnalysis& analysis, dataflow::OriginId origin, std::string begins,
           flow::NodeId node, std::string ends) {
    trace(finding, analysis, queries::node_of_origin(analysis, origin),
          related_at(analysis, origin, std::move(begins)), node, std::move(ends));
}

RelatedLocation begin_of_vacancy(const ProgramAnalysis& analysis, dataflow::OriginId origin,
                                 std::span<const flow::EdgeId> path, std::string otherwise) {
    const auto argument = queries::variable_of_origin(analysis, origin);
    const Caller* call = argument ? queries::call_that_leaves_out(analysis, *argument, path) : nullptr;
    return call == nullptr ? related_at(analysis, origin, std::move(otherwise))
                           : related_at_effect(queries::calling_program(analysis, *call), call->effect,
                                               "leaves " + with_letter(analysis, *argument) + " out");
}

void trace_vacancy(Finding& finding, const ProgramAnalysis& analysis, dataflow::OriginId origin,
                   const std::string& name, flow::NodeId node, std::string ends) {
    const flow::NodeId from = queries::node_of_origin(analysis, origin);
    const auto path = find_path(finding, analysis, from, node);
    finding.path.push_back(begin_of_vacancy(analysis, origin,
                                            path ? std::span(*path) : std::span<flow::EdgeId>{},
                                            name + " may be vacant from here on"));
    add_steps(finding.path, analysis, path, from, node);
    finding.path.push_back({finding.source, finding.span, std::move(ends)});
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
