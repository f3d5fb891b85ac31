//! Steps of the solver, taken one path at a time.
#include "analyzer/execution/path_run.hpp"

#include "analyzer/dataflow/domain/arithmetic.hpp"
#include "analyzer/execution/outcome.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace maclint::execution {
namespace {

using dataflow::Symbol;
using dataflow::SymbolId;
using dataflow::Value;

/// Evaluating it takes as long as looking at this number of assumptions.
constexpr std::size_t work_of_an_expression = 8;

} // namespace

namespace {

void collect(const Program& program, ExpressionId id, std::vector<dataflow::MachineValue>& values) {
    const auto& node = program.expressions[id].node;
    if (const auto* owned = std::get_if<LoadMachine>(&node)) values.push_back({owned->family, owned->number});
    if (const auto* apply = std::get_if<Apply>(&node))
        for (const ExpressionId operand : program.operands_of(*apply)) collect(program, operand, values);
}

/// What decides whether a loop goes on: whoever waits for an input expects it to change.
std::vector<dataflow::MachineValue> awaited_by(const ProgramAnalysis& analysis) {
    std::vector<dataflow::MachineValue> values;
    for (const dataflow::Loop& loop : analysis.loops())
        for (const flow::EdgeId exit : loop.exit_edges)
            if (const auto& condition = analysis.graph().edges[exit].condition)
                collect(analysis.program(), *condition, values);
    return values;
}

} // namespace

bool acts(const Program& program, const flow::Node& node) {
    if (node.is_run) return true;
    for (Id i = node.effects.first; i < node.effects.first + node.effects.count; ++i) {
        const auto& what = program.effects[i].what;
        if (!std::holds_alternative<Assign>(what) && !std::holds_alternative<Guarded>(what) &&
            !std::holds_alternative<RegionMark>(what) && !std::holds_alternative<Jump>(what))
            return true;
    }
    return false;
}

PathRun::PathRun(const ProgramAnalysis& analysis, SearchWork& work, std::size_t most_of_a_step)
    : program_(analysis.program())
    , graph_(analysis.graph())
    , work_(work)
    , states_(program_, analysis.data().knowledge())
    , transfer_(program_, graph_, states_, analysis.data().callees())
    , assumptions_(program_.control->vacant_equals_zero, work)
    , skips_(program_, graph_)
    , most_of_a_step_(most_of_a_step) {
    for (const Expression& expression : program_.expressions) {
        if (const auto* load = std::get_if<LoadModal>(&expression.node)) asked_groups_.push_back(load->group);
        reads_by_index_ = reads_by_index_ || std::holds_alternative<LoadAt>(expression.node);
    }
    std::ranges::sort(asked_groups_);
    asked_groups_.erase(std::ranges::unique(asked_groups_).begin(), asked_groups_.end());
    transfer_.follow_one_path(awaited_by(analysis));
}

std::uint64_t hash_mixed(const PathRun::Step& step) {
    std::uint64_t hash =
        dataflow::mix(static_cast<std::uint64_t>(step.kind), dataflow::side_by_side(step.id, step.root));
    hash = dataflow::mix(hash, dataflow::side_by_side(step.havoc, step.assumed));
    return dataflow::mix(hash, dataflow::side_by_side(step.time.acted, step.time.stored));
}

template<class Take>
std::optional<PathRun::Point> PathRun::remembered(Step::Kind kind, std::uint32_t id, const Point& before,
                                                  const Take& take) {
    const std::uint32_t step =
        steps_({kind, id, before.state.root, before.state.havoc, before.assumed, before.time});
    if (step == taken_.size()) {
        const Budget budget(most_of_a_step_);
        const std::size_t done = work_.done();
        const std::size_t evaluated = transfer_.evaluated();
        const std::optional<Point> after = take();
        work_.allows((transfer_.evaluated() - evaluated) * work_of_an_expression);
        taken_.push_back({after, work_.done() - done});
    }
    (void)Budget::allows(taken_[step].work);
    return taken_[step].after;
}

/// What was assumed on the way makes no difference there.
PathRun::Point PathRun::run(flow::NodeId node, Point point) {
    const Assumptions::Id assumed = std::exchange(point.assumed, Assumptions::none);
    point = *remembered(Step::Kind::node, node, point, [&] { return run_now(node, point); });
    point.assumed = assumed;
    return point;
}

std::optional<PathRun::Point> PathRun::along(flow::EdgeId id, const Point& after) {
    if (!after.state.reached) return std::nullopt;
    const flow::Edge& edge = graph_.edges[id];
    if (!edge.condition && !edge.label && skips_.at(id) == Switches{} &&
        graph_.channels_at(edge.from).running == graph_.all_channels)
        return after;
    return remembered(Step::Kind::edge, id, after, [&] { return along_now(id, after); });
}

PathRun::Point PathRun::after_changes(const Changes& changes, Point point) {
    return *remembered(Step::Kind::rounds, changes.id, point, [&] { return change(changes, point); });
}

PathRun::Point PathRun::run_now(flow::NodeId node, Point point) {
    transfer_.set_machine_time(point.time);
    point.state = transfer_.run(node, point.state);
    const flow::Node& n = graph_.nodes[node];
    if (acts(program_, n)) point.time.acted = node;
    if (may_store_in_machine(n)) point.time.stored = node;
    transfer_.set_machine_time(point.time);
    return point;
}

/// Or may: a program that it calls, a block that waits for the machine (G10), one that nobody can read; and
/// any assignment in what an index reads.
bool PathRun::may_store_in_machine(const flow::Node& node) const {
    return std::ranges::any_of(program_.effects_in(node.effects), [this](const Effect& effect) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        if (assign != nullptr) return reads_by_index_ || !std::holds_alternative<Variable>(assign->target);
        return std::holds_alternative<Call>(effect.what) ||
               std::holds_alternative<Synchronise>(effect.what) ||
               std::holds_alternative<UnreadableBlock>(effect.what);
    });
}

// ---- decisions

std::optional<PathRun::Point> PathRun::along_now(flow::EdgeId id, const Point& after) {
    const flow::Edge& edge = graph_.edges[id];
    Point next = after;
    transfer_.turn_back();
    transfer_.set_machine_time(after.time);
    next.state = transfer_.along(edge, after.state);
    if (!next.state.reached || !assume_switches(next, skips_.at(id))) return std::nullopt;
    // A condition that not all channels ask says nothing of the others.
    const bool asked_by_all = graph_.channels_at(edge.from).running == graph_.all_channels;
    if (edge.condition && asked_by_all &&
        !(assume_outcome(next, after.state, *edge.condition, edge.holds) &&
          assume(next, after.state, *edge.condition, edge.holds)))
        return std::nullopt;
    return next;
}

bool PathRun::assume_switches(Point& point, const Switches& switches) {
    if ((switches.on & switches.off) != 0) return false; // past one block of a level into another
    for (std::uint32_t level = 0; level < std::numeric_limits<std::uint16_t>::digits; ++level) {
        const bool on = (switches.on >> level & 1U) != 0;
        if (!on && (switches.off >> level & 1U) == 0) continue;
        if (!assume_is(point, states_.table().symbols(Symbol::switch_of(level)), on)) return false;
    }
    return true;
}

/// Of what is true (1) or false (0).
bool PathRun::assume_is(Point& point, SymbolId subject, bool holds) {
    const double number = holds ? 1 : 0;
    if (!work_.allows(assumptions_.count(point.assumed))) return true;
    for (Assumptions::Id id = point.assumed; id != Assumptions::none; id = assumptions_[id].earlier)
        if (assumptions_[id].subject == subject) return assumptions_[id].number == number;
    Value value = dataflow::number_value(subject, 0);
    value.high = 1;
    const auto assumed = assumptions_.add(point.assumed, Operation::equal, value,
                                          dataflow::number_value(states_.table(), number));
    if (assumed) point.assumed = *assumed;
    return assumed.has_value();
}

/// Of several comparisons it may not be said how each turned out: asked again they turn out the same.
bool PathRun::assume_outcome(Point& point, const dataflow::State& before, ExpressionId condition,
                             bool holds) {
    const auto outcome = outcome_of(program_, transfer_, states_.table(), before, condition);
    if (!outcome) return true;
    return assume_is(point, outcome->symbol, holds != outcome->negated);
}

/// Takes what must be so when the condition turned out like this.
bool PathRun::assume(Point& point, const dataflow::State& before, ExpressionId condition, bool holds) {
    const auto* apply = std::get_if<Apply>(&program_.expressions[condition].node);
    if (apply == nullptr) return true;
    const auto operands = program_.operands_of(*apply);
    if (apply->operation == Operation::not_of) return assume(point, before, operands.front(), !holds);
    if (apply->operation == (holds ? Operation::any_of : Operation::all_of))
        return assume_some(point, before, operands, holds);
    if (apply->operation == (holds ? Operation::all_of : Operation::any_of))
        return std::ranges::all_of(
            operands, [&](ExpressionId operand) { return assume(point, before, operand, holds); });
    const auto found = comparison_in(before, condition, holds);
    return !found || assume_one(point, *found);
}

/// One of them at least turned out like this: where all others cannot, the last one did.
bool PathRun::assume_some(Point& point, const dataflow::State& before, std::span<const ExpressionId> operands,
                          bool holds) {
    constexpr std::size_t most = 8;
    const bool few = operands.size() <= most;
    std::optional<Point> only;
    std::size_t possible = 0;
    std::vector<Assumptions::Found> alternatives;
    for (const ExpressionId operand : operands) {
        Point with = point;
        if (!assume(with, before, operand, holds)) continue;
        if (++possible > 1 && !few) return true;
        only = with;
        if (const auto found = comparison_in(before, operand, holds)) alternatives.push_back(*found);
    }
    if (possible == 1) point = *only;
    if (possible > 1 && alternatives.size() == possible)
        point.assumed = assumptions_.add_one_of(point.assumed, std::move(alternatives));
    return possible > 0;
}

std::optional<Assumptions::Found> PathRun::comparison_in(const dataflow::State& before,
                                                         ExpressionId condition, bool holds) {
    const auto* apply = std::get_if<Apply>(&program_.expressions[condition].node);
    if (apply == nullptr) return std::nullopt;
    const auto operands = program_.operands_of(*apply);
    if (apply->operation == Operation::not_of) return comparison_in(before, operands.front(), !holds);
    const bool test = semantics::is_vacancy_test(apply->operation);
    if (!test && !(dataflow::is_comparison(apply->operation) && operands.size() == 2)) return std::nullopt;
    const Value left = transfer_.value_in(before, operands.front());
    return Assumptions::Found{holds ? apply->operation : dataflow::opposite(apply->operation), left,
                              test ? left : transfer_.value_in(before, operands.back())};
}

bool PathRun::assume_one(Point& point, const Assumptions::Found& found) {
    const semantics::Truth truth = semantics::is_vacancy_test(found.operation)
                                       ? semantics::test_vacancy(found.operation, found.left)
                                       : dataflow::compare(found.operation, found.left, found.right,
                                                           program_.control->vacant_equals_zero);
    if (!truth.can_hold) return false;
    const auto assumed = assumptions_.add(point.assumed, found.operation, found.left, found.right);
    if (assumed) point.assumed = *assumed;
    return assumed.has_value();
}

// ---- loops

/// The changed variables and their unknown values, which are the same whenever the path comes to the node.
dataflow::Root PathRun::unknown_after(const Changes& changes) {
    const auto [known, fresh] = unknown_.try_emplace(changes.id);
    if (!fresh) return known->second;
    dataflow::State state;
    for (const Variable variable : changes.variables) {
        Value value;
        value.symbol = states_.table().symbols(Symbol::joined_at(dataflow::key_of(variable), changes.at, 1));
        if (std::ranges::binary_search(changes.fractions, dataflow::key_of(variable), {},
                                       [](Variable each) { return dataflow::key_of(each); }))
            assumptions_.may_be_fraction(value.symbol);
        states_.write(state, variable, value);
    }
    return known->second = state.root;
}

PathRun::Point PathRun::change(const Changes& changes, Point point) {
    for (const SpaceId space : changes.spaces)
        states_.havoc(point.state, space, {dataflow::Origin::Kind::effect, changes.at, changes.at});
    point.state.root = states_.trees().united(unknown_after(changes), point.state.root);
    if (!changes.machine) return point;
    point.time = {changes.at, changes.at};
    for (std::size_t i = 0; i < program_.control->groups.size(); ++i)
        for_each_channel(graph_.all_channels, [&](std::uint8_t channel) {
            const auto group = static_cast<GroupId>(i);
            dataflow::ModalValue value = states_.read(point.state, dataflow::ChannelGroup{channel, group});
            value.unknown = true;
            states_.write(point.state, dataflow::ChannelGroup{channel, group}, std::move(value));
        });
    return point;
}

// ---- what makes a difference

std::uint32_t PathRun::see(SymbolId id, std::uint32_t place) {
    if (id >= seen_.size()) seen_.resize(std::max<std::size_t>(id + 1, 2 * seen_.size()));
    if (!is_seen(id)) seen_[id] = {fingerprints_, place};
    return seen_[id].place;
}

/// Whether a decision can come upon the value again that sees what this fingerprint counts and the machine.
bool PathRun::can_be_seen(SymbolId id) const {
    const Symbol& symbol = states_.table().symbols[id];
    switch (symbol.kind()) {
    case Symbol::Kind::constant:
    case Symbol::Kind::vacant:
    case Symbol::Kind::machine:
    case Symbol::Kind::skip_switch: return true;
    case Symbol::Kind::result:
        if (can_be_seen(symbol.first()) && can_be_seen(symbol.second())) return true;
        break;
    default: break;
    }
    // 0: a result of one operand has no other.
    return id == 0 || is_seen(id);
}

/// How large it is, whether it is exact or vacant; which value it is counts only where something is assumed
/// of it, or another variable has the same.
std::uint64_t PathRun::print_of(std::uint32_t value) {
    if (value >= prints_.size()) prints_.resize(std::max<std::size_t>(value + 1, 2 * prints_.size()), 0);
    std::uint64_t& print = prints_[value];
    if (print != 0) return print;
    const Value& of = states_.table().values[value];
    print = dataflow::mix(static_cast<std::uint64_t>(of.vacancy), static_cast<std::uint64_t>(of.exactness));
    print = dataflow::mix(print, std::bit_cast<std::uint64_t>(of.low));
    return print = dataflow::mix(print, std::bit_cast<std::uint64_t>(of.high)) | 1U;
}

bool PathRun::share_a_value(const Point& point, std::span<const Variable> some,
                            std::span<const Variable> others) {
    if (some.empty() || others.empty()) return false;
    ++fingerprints_;
    work_.allows(some.size() + others.size());
    const auto symbol_of = [&](Variable variable) {
        return states_.table().values[states_.id_of(point.state, variable)].symbol;
    };
    for (const Variable variable : others) see(symbol_of(variable), 0);
    return std::ranges::any_of(some, [&](Variable variable) {
        const SymbolId symbol = symbol_of(variable);
        return is_seen(symbol) && states_.table().symbols[symbol].kind() != Symbol::Kind::constant;
    });
}

std::uint64_t PathRun::fingerprint(const Point& point, std::span<const Variable> deciding) {
    std::uint64_t print = 0;
    ++fingerprints_;
    work_.allows(deciding.size() + assumptions_.count(point.assumed));
    for (std::uint32_t place = 0; place < deciding.size(); ++place) {
        const std::uint32_t value = states_.id_of(point.state, deciding[place]);
        print = dataflow::mix(print, print_of(value));
        print = dataflow::mix(print, see(states_.table().values[value].symbol, place));
    }
    for (const GroupId group : asked_groups_)
        for_each_channel(graph_.all_channels, [&](std::uint8_t channel) {
            const dataflow::ModalValue& value =
                states_.read(point.state, dataflow::ChannelGroup{channel, group});
            for (const dataflow::ModalPart& part : value.parts) {
                print = dataflow::mix(print, part.symbol);
                see(part.symbol, static_cast<std::uint32_t>(deciding.size()));
            }
            print = dataflow::mix(print, value.unknown ? 1 : 0);
            if (const auto code = states_.entry_code(point.state, {channel, group}))
                print = dataflow::mix(print, std::bit_cast<std::uint64_t>(*code));
        });
    for (Assumptions::Id id = point.assumed; id != Assumptions::none; id = assumptions_[id].earlier) {
        const Assumptions::Assumption& assumption = assumptions_[id];
        const auto alternatives = assumptions_.alternatives(assumption);
        // One that cannot be seen again stays possible, and the others may be false.
        if (!std::ranges::all_of(alternatives, [&](const auto& each) { return counts(each); })) continue;
        if (alternatives.empty()) print_assumption(print, assumption);
        for (const Assumptions::Assumption& each : alternatives) {
            print = dataflow::mix(print, alternatives.size()); // not as if each were true
            print_assumption(print, each);
        }
    }
    return print;
}

/// Whether a later decision may contradict it.
bool PathRun::counts(const Assumptions::Assumption& assumption) const {
    return can_be_seen(assumption.subject) && can_be_seen(assumption.other);
}

void PathRun::print_assumption(std::uint64_t& print, const Assumptions::Assumption& assumption) const {
    if (!counts(assumption)) return;
    print = dataflow::mix(print, dataflow::side_by_side(assumption.subject, assumption.other));
    print = dataflow::mix(print, std::bit_cast<std::uint64_t>(assumption.number));
    print = dataflow::mix(print, static_cast<std::uint64_t>(assumption.operation));
}

} // namespace maclint::execution
