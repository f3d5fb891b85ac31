//! One function a kind of event.
#include "tests/execution/live_stores.hpp"

#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/tables.hpp"
#include "tests/support/analysed.hpp"

namespace maclint::test {

std::optional<LiveStores::Place> LiveStores::place_of(const ProgramAnalysis& analysis,
                                                      Variable variable) const {
    const Variable meant = analysis.program().meant_by(variable);
    const VariableSpace& space = analysis.control().spaces[meant.space];
    if (space.scope == Scope::frame) return Place{locals_.back(), meant.space, meant.number};
    if (space.named) return std::nullopt;
    return Place{0, meant.space, meant.number};
}

void LiveStores::observe(execution::Stepper& stepper, const execution::Event& event) {
    const ProgramAnalysis& analysis = stepper.program();
    std::visit(overloaded{
                   [&](const execution::ProgramBegins&) {
                       locals_.resize(stepper.depth());
                       locals_.push_back(fresh_ || locals_.empty() ? ++sets_ : locals_.back());
                   },
                   [&](const execution::CallBegins& call) {
                       fresh_ = !call.shares_locals;
                       in_unknown_ = !call.target;
                   },
                   [&](const execution::CallEnds&) {
                       locals_.resize(stepper.depth() + 1);
                       in_unknown_ = false;
                   },
                   [&](const execution::Stored& store) {
                       const auto place = place_of(analysis, store.variable);
                       if (!place) return;
                       if (in_unknown_ || !stepper.effect())
                           held_by_.erase(*place);
                       else
                           held_by_.insert_or_assign(*place, Store{&analysis, *stepper.effect()});
                   },
                   [&](const execution::VariableRead& read) {
                       const auto place = place_of(analysis, read.variable);
                       const auto store = place ? held_by_.find(*place) : held_by_.end();
                       if (store == held_by_.end()) return;
                       ++held_;
                       const auto& [by, effect] = store->second;
                       // A local variable bears the number that its own program gives to the name.
                       const bool same_number =
                           by == &analysis || !analysis.control().spaces[read.variable.space].named;
                       if (!same_number || by->liveness().is_live_after(effect, read.variable) || refuted_)
                           return;
                       refuted_ = by->program().name + ", line " +
                                  std::to_string(line_of(*by, by->program().effects[effect].span.begin)) +
                                  ": the store is said to be dead, and is read on line " +
                                  std::to_string(line_of(
                                      analysis, analysis.program().expressions[read.expression].span.begin));
                   },
                   [](const auto&) {},
               },
               event);
}

} // namespace maclint::test
