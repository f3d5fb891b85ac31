//! Compares what a program reads with what its callers pass.
#include "analyzer/queries/calls/missing_arguments.hpp"

#include "analyzer/execution/path_search.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/calls/callers.hpp"
#include "analyzer/queries/calls/provoking_calls.hpp"
#include "analyzer/queries/paths/feasible_paths.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

namespace maclint::queries {
namespace {

/// Whether a call whose program only the running program knows may mean it.
bool may_be_computed(const ProgramAnalysis& analysis) {
    return analysis.has_possible_callers() ||
           std::ranges::any_of(analysis.workspace().files(), [&](const WorkspaceFile& file) {
               return file.file.get() == &analysis.file() && file.may_be_computed;
           });
}

/// The value of the variable at the program's start.
bool is_as_passed(const ProgramAnalysis& analysis, const dataflow::Read& read) {
    const dataflow::Symbol& symbol = analysis.data().table().symbols[read.value.symbol];
    return symbol.is_entry_of(dataflow::key_of(read.variable));
}

bool is_asked_for(const ProgramAnalysis& analysis, const dataflow::Read& wanted) {
    return any_within_budget(analysis.facts().all<dataflow::Read>(), [&](const dataflow::Read& read) {
        const bool asks = read.use == dataflow::Use::vacancy_test || read.use == dataflow::Use::comparison;
        return asks && (read.value.symbol == wanted.value.symbol || read.variable == wanted.variable);
    });
}

/// The first call that comes to the read with the variable as it has left it. What it passes decides where it
/// goes: another call's path may be closed to it, and another way open.
const Caller* call_that_comes_to(execution::PathSearch& search, const ProgramAnalysis& analysis,
                                 const dataflow::Read& read) {
    const auto changing = nodes_that_may_change(analysis, read.variable, read.node);
    if (read.node != 0 && std::ranges::binary_search(changing, flow::NodeId{0})) return nullptr;
    std::set<std::vector<flow::NodeId>> in_vain; // calls that go the same ways
    for (const Caller& caller : analysis.callers()) {
        if (!Budget::allows()) return nullptr;
        const std::vector<bool> reached = nodes_reached_by(analysis, caller, changing);
        if (!reached[read.node]) continue;
        std::vector<flow::NodeId> barred = changing;
        for (flow::NodeId node = 0; node < reached.size(); ++node)
            if (!reached[node]) barred.push_back(node);
        std::ranges::sort(barred);
        if (in_vain.contains(barred)) continue;
        if (search.find(std::array{execution::Leg{read.node, barred}}).path) return &caller;
        in_vain.insert(std::move(barred));
    }
    return nullptr;
}

} // namespace

std::vector<MissingArgument> find_missing_arguments(const ProgramAnalysis& analysis) {
    std::vector<MissingArgument> found;
    const auto& callers = analysis.callers();
    const auto& formals = analysis.control().formals;
    if (callers.empty() || may_be_computed(analysis) ||
        !std::ranges::all_of(callers, [&](const Caller& caller) { return opens_locals(analysis, caller); }))
        return found;
    std::optional<execution::PathSearch> search; // most programs have no such read
    for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>()) {
        const bool known = std::ranges::any_of(
            found, [&](const MissingArgument& other) { return other.read->variable == read.variable; });
        if (known || read.use != dataflow::Use::arithmetic || !is_as_passed(analysis, read) ||
            std::ranges::find(formals, read.variable) == formals.end() ||
            (exemptions::compared_somewhere.is_on() && is_asked_for(analysis, read)))
            continue;
        if (any_within_budget(callers, [&](const Caller& caller) {
                return argument_for(analysis, caller, read.variable) != nullptr;
            }))
            continue;
        if (!search) search.emplace(analysis);
        const Caller* call = call_that_comes_to(*search, analysis, read);
        if (call != nullptr) found.push_back({&read, call});
    }
    return found;
}

} // namespace maclint::queries
