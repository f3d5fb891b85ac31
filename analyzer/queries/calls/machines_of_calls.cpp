//! Runs a program again for each call, where that may tell something.
#include "analyzer/queries/calls/machines_of_calls.hpp"

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/solver/known_calls.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace maclint::queries {
namespace {

/// Nodes with a block on a circle, or in a canned cycle.
std::vector<bool> nodes_with_shapes(const ProgramAnalysis& analysis) {
    std::vector<bool> nodes(analysis.graph().nodes.size(), false);
    for (flow::NodeId node = 0; node < nodes.size(); ++node)
        analysis.machine().for_each_step_of(node, [&](const machine::Step& step) {
            if (machine::moves_on_shape(step, analysis.control())) nodes[node] = true;
        });
    return nodes;
}

/// Nothing where no calculated word is known.
std::optional<MachineOfCall> machine_of(const ProgramAnalysis& analysis, const NumberedCall& call) {
    dataflow::Analysis begun = analysis.data().begun_with(call.start, dataflow::facts<dataflow::Read>());
    machine::OneCall one{numbers_of_words(analysis.program(), begun), {}};
    if (one.numbers.empty()) return std::nullopt;
    for (flow::EdgeId edge = 0; edge < analysis.graph().edges.size(); ++edge)
        one.passable.push_back(begun.passable(edge));
    machine::States states = analysis.machine().begun_by(std::move(one));
    return MachineOfCall(analysis, call, std::move(begun), std::move(states));
}

} // namespace

bool MachineOfCall::surely_comes_by(flow::NodeId node) const {
    std::vector<bool> only(analysis_.graph().nodes.size(), false);
    only[node] = true;
    return always_comes_by(analysis_.graph(), begun_, only);
}

void for_each_machine_of_call(const ProgramAnalysis& analysis,
                              const std::function<void(const MachineOfCall&)>& visit) {
    const auto calls = calls_with_numbers(analysis);
    if (calls.empty()) return;
    const dataflow::WaysAround ways(analysis.program(), analysis.graph(), analysis.data(),
                                    nodes_with_shapes(analysis));
    for (const NumberedCall& call : calls) {
        if (ways.may_leave(call.start, [](std::span<const dataflow::CallBegun>) { return true; })) continue;
        if (const auto machine = machine_of(analysis, call)) visit(*machine);
    }
}

} // namespace maclint::queries
