//! Runs a program again for each call, where that may tell something.
#include "analyzer/queries/calls/machines_of_calls.hpp"

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/solver/known_calls.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/modes_at.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <variant>
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

/// Whether numbers are stored and words calculated, in a program that is short enough to be run again.
bool calculates_words(const ProgramAnalysis& analysis) {
    constexpr std::size_t most_nodes = 1000;
    const auto has = [&](const auto& is_wanted) {
        return std::ranges::any_of(analysis.program().effects, is_wanted);
    };
    return analysis.graph().nodes.size() <= most_nodes &&
           has([](const Effect& effect) { return std::holds_alternative<Assign>(effect.what); }) &&
           has([](const Effect& effect) { return std::holds_alternative<EvaluateWords>(effect.what); });
}

/// The plane in force at the call; nothing where it is not known.
std::optional<double> plane_at(const NumberedCall& call) {
    const ProgramAnalysis& calling = *call.program;
    const auto group = calling.control().group_with(ModalRole::plane);
    const auto node = call.effect ? calling.graph().node_of(*call.effect) : std::nullopt;
    std::optional<double> code;
    if (!group || !node) return code;
    ModesAt modes_at(calling);
    for_each_block(calling.program(), calling.graph().nodes[*node].stretch(),
                   [&](const BlockView& block) { code = modes_at(block).before(*group).sure_code(); });
    return code;
}

/// Nothing where no calculated word is known.
std::optional<MachineOfCall> machine_of(const ProgramAnalysis& analysis, const NumberedCall& call) {
    dataflow::Analysis begun = analysis.data().begun_with(call.start, dataflow::facts<dataflow::Read>());
    machine::OneCall one{numbers_of_words(analysis.program(), begun), {}, plane_at(call)};
    if (one.numbers.empty()) return std::nullopt;
    for (flow::EdgeId edge = 0; edge < analysis.graph().edges.size(); ++edge)
        one.passable.push_back(begun.passable(edge));
    machine::States states = analysis.machine().begun_by(std::move(one));
    return MachineOfCall(analysis, call, std::move(begun), std::move(states));
}

} // namespace

bool MachineOfCall::surely_comes_by(flow::NodeId node) const {
    const std::vector<bool> none(analysis_.graph().nodes.size(), false);
    std::vector<bool> only = none;
    only[node] = true;
    if (always_comes_by(analysis_.graph(), begun_, only)) return true;
    // What paths have in common says too little of a WHILE whose first test is known to hold.
    const auto may_leave = [&](std::vector<bool> around) {
        return dataflow::WaysAround(analysis_.program(), analysis_.graph(), analysis_.data(),
                                    std::move(around))
            .may_leave(call_.start, [](std::span<const dataflow::CallBegun>) { return true; });
    };
    return may_leave(none) && !may_leave(std::move(only));
}

void for_each_machine_of_call(const ProgramAnalysis& analysis,
                              const std::function<void(const MachineOfCall&)>& visit) {
    auto calls = calls_with_numbers(analysis);
    // What the numbers in its own text make of a program that nobody calls.
    if (calls.empty() && analysis.is_main() && calculates_words(analysis))
        calls.push_back({&analysis, {}, false, {}, std::nullopt});
    if (calls.empty()) return;
    const dataflow::WaysAround ways(analysis.program(), analysis.graph(), analysis.data(),
                                    nodes_with_shapes(analysis));
    for (const NumberedCall& call : calls) {
        if (ways.may_leave(call.start, [](std::span<const dataflow::CallBegun>) { return true; })) continue;
        if (const auto machine = machine_of(analysis, call)) visit(*machine);
    }
}

} // namespace maclint::queries
