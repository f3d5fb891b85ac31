//! Bounds the searches, and keeps one explorer for all of a program.
#include "analyzer/execution/path_search.hpp"

#include "analyzer/execution/path_explorer.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <memory>

namespace maclint::execution {
namespace {

constexpr std::size_t most_visits = 2000;        ///< of nodes, for one path
constexpr std::size_t most_visits_in_all = 8000; ///< for all paths that one search is asked for

} // namespace

PathFound PathSearch::find(std::span<const Leg> legs) {
    const Budget own = Budget::without_bound(); // it has bounds of its own
    const std::size_t left = most_visits_in_all - std::min(visits_, most_visits_in_all);
    SearchMemory& memory = analysis_->search_memory();
    PathFound found = memory.use<PathExplorer>(
        [&] { return std::make_shared<PathExplorer>(*analysis_); },
        [&](PathExplorer& explorer) { return explorer.find(legs, std::min(most_visits, left)); });
    memory.count(found.gave_up);
    visits_ += found.visits;
    return found;
}

} // namespace maclint::execution
