//! Reading, writing and joining states.
#include "analyzer/dataflow/domain/state.hpp"

#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <utility>

namespace maclint::dataflow {
namespace {

/// Keeps the parts sorted.
void add_part(ModalValue& value, const ModalPart& part) {
    const auto position = std::ranges::lower_bound(value.parts, part);
    if (position != value.parts.end() && *position == part) return;
    value.parts.insert(position, part);
}

/// A vacant value has no number: then the other value says where the number comes from.
OriginId joined_origin(const Value& a, const Value& b) {
    if (a.origin == b.origin) return a.origin;
    const bool a_vacant = a.vacancy == Vacancy::vacant, b_vacant = b.vacancy == Vacancy::vacant;
    if (a_vacant == b_vacant) return 0;
    return a_vacant ? b.origin : a.origin;
}

} // namespace

States::States(const Program& program, EntryKnowledge knowledge)
    : program_(program)
    , knowledge_(std::move(knowledge)) {
    for (const Variable variable : handed_down()) handed_down_.push_back(key_of(variable));
    std::ranges::sort(handed_down_);
    entry_modals_.reserve(program.control->groups.size());
    for (std::size_t i = 0; i < program.control->groups.size(); ++i) {
        const ModalGroup& group = program.control->groups[i];
        ModalValue value;
        if (knowledge_.entry == Entry::main && group.reset)
            value.parts = {{table_.constant(*group.reset), 0}};
        else
            value.parts = {{table_.symbols(Symbol::group_at_entry(i)), 0}};
        entry_modals_.push_back(table_.modals(value));
    }
}

State States::at_entry() const {
    State state;
    state.reached = true;
    return state;
}

bool States::may_be_handed_down(Variable variable) const {
    if (!program_.control->spaces[variable.space].handed_down) return false;
    return !knowledge_.handed_down || std::ranges::binary_search(handed_down_, key_of(variable));
}

Vacancy States::vacancy_at_entry(Variable variable) const {
    if (knowledge_.entry == Entry::main) return Vacancy::vacant;
    if (is_set_by_no_caller(variable)) return Vacancy::maybe; // others may call it as well
    if (knowledge_.locals_are_callers || may_be_handed_down(variable)) return Vacancy::unknown;
    if (knowledge_.arguments) {
        const auto known =
            std::ranges::find(*knowledge_.arguments, variable, &std::pair<Variable, Vacancy>::first);
        return known == knowledge_.arguments->end() ? Vacancy::vacant : known->second;
    }
    const auto& passed = knowledge_.passed_somewhere;
    const bool argument = program_.is_formal(variable) || std::ranges::find(passed, variable) != passed.end();
    return argument ? Vacancy::maybe : Vacancy::vacant;
}

bool States::is_vacant_at_entry(Variable variable) const {
    const VariableSpace& space = program_.control->spaces[variable.space];
    return space.scope == Scope::frame && !initial_number(variable) &&
           vacancy_at_entry(variable) == Vacancy::vacant;
}

bool States::is_set_by_no_caller(Variable variable) const {
    const auto& set = knowledge_.set_by_callers;
    return knowledge_.locals_are_callers && set && std::ranges::find(*set, variable) == set->end() &&
           program_.control->spaces[variable.space].scope == Scope::frame;
}

/// What a local variable holds in front of the first store, unless the call sets it; nothing: it is vacant.
std::optional<double> States::initial_number(Variable variable) const {
    const Declaration* declaration = program_.declaration_of(variable);
    if (declaration != nullptr && declaration->initial) return declaration->initial;
    return program_.control->spaces[variable.space].initial_value == InitialValue::zero ? std::optional(0.0)
                                                                                        : std::nullopt;
}

Value States::typed(const Value& value, Variable variable) {
    const VariableType type = program_.type_of(variable);
    if (type == VariableType::number || value.vacancy == Vacancy::vacant) return value;
    Value held = value;
    held.choices = 0;
    if (type == VariableType::text) {
        held.symbol = table_.symbols(Symbol::opaque(value.symbol, variable.space, 4));
        return held;
    }
    held.know(semantics::stored_in(type, value));
    held.rounding = 0;
    if (semantics::fits(type, value)) return held;
    if (value.constant()) return number_value(table_, held.low);
    held.symbol = table_.symbols(Symbol::opaque(value.symbol, variable.space, 5));
    return held;
}

Value States::entry_value(Variable variable) {
    const VariableSpace& space = program_.control->spaces[variable.space];
    const OriginId origin = table_.origins(Origin::at_entry(variable));
    Value value;
    value.symbol = table_.symbols(Symbol::at_entry(key_of(variable)));
    const auto known = std::ranges::find(knowledge_.known, variable, &KnownVariable::variable);
    if (known != knowledge_.known.end())
        return known->number ? number_value(table_, *known->number) : vacant_value(table_, origin);
    if (space.scope == Scope::frame) {
        value.vacancy = vacancy_at_entry(variable);
        const auto initial = initial_number(variable);
        if (value.vacancy == Vacancy::vacant)
            return initial ? number_value(table_, *initial) : vacant_value(table_, origin);
        if (initial)
            value.vacancy = Vacancy::set;
        else if (value.vacancy == Vacancy::maybe)
            value.vacancy_origin = origin;
    } else if (space.scope == Scope::machine) {
        value.vacancy = Vacancy::set;
    }
    const VariableType type = program_.type_of(variable);
    value.integer = type == VariableType::integer || type == VariableType::truth;
    if (type == VariableType::truth) {
        value.low = 0;
        value.high = 1;
    }
    return value;
}

Value States::absent(const State& state, Key key) {
    const SymbolId site = table_.havoc(state.havoc).by_space[variable_of(key).space];
    if (site == 0) return table_.values[entry_id(key)];
    Value value;
    value.symbol = table_.symbols(Symbol::opaque(key, site, 1));
    return value;
}

/// The number of the value at the program's start.
std::uint32_t States::entry_id(Key key) {
    if (const auto known = maps_.find(entry_values_, key)) return *known;
    const std::uint32_t id = table_.values(entry_value(variable_of(key)));
    entry_values_ = maps_.set(entry_values_, key, id);
    return id;
}

ModalId States::absent_modal(Key key) const { return entry_modals_[group_of(key).group]; }

Value States::read(const State& state, Variable variable) {
    const auto found = maps_.find(state.root, key_of(variable));
    return found ? table_.values[*found] : absent(state, key_of(variable));
}

std::uint32_t States::id_of(const State& state, Variable variable) {
    const Key key = key_of(variable);
    if (const auto found = maps_.find(state.root, key)) return *found;
    const bool forgotten = table_.havoc(state.havoc).by_space[variable.space] != 0;
    return forgotten ? table_.values(absent(state, key)) : entry_id(key);
}

const ModalValue& States::read(const State& state, ChannelGroup of) const {
    return table_.modals[id_of(state, of)];
}

ModalId States::id_of(const State& state, ChannelGroup of) const {
    return maps_.find(state.root, key_of(of)).value_or(entry_modals_[of.group]);
}

ModalValue States::read(const State& state, Channels channels, GroupId group) const {
    if (std::has_single_bit(channels))
        return read(state, ChannelGroup{static_cast<std::uint8_t>(std::countr_zero(channels)), group});
    ModalValue all;
    for_each_channel(channels, [&](std::uint8_t channel) {
        const ModalValue& one = read(state, ChannelGroup{channel, group});
        all.unknown |= one.unknown;
        for (const ModalPart& part : one.parts) add_part(all, part);
    });
    return all;
}

std::optional<double> States::entry_code(const State& state, ChannelGroup of) const {
    const auto found = maps_.find(state.root, entry_code_key(of));
    return found ? table_.number_of(*found) : std::nullopt;
}

void States::write(State& state, Variable variable, const Value& value) {
    state.root = maps_.set(state.root, key_of(variable), table_.values(value));
}

void States::write(State& state, ChannelGroup of, ModalValue value) {
    write(state, of, remember(std::move(value)));
}

void States::write(State& state, ChannelGroup of, ModalId value) {
    state.root = maps_.set(state.root, key_of(of), value);
}

void States::write_groups(State& state, std::uint8_t channel, std::span<const ModalId> values) {
    state.root = maps_.set_all(state.root, key_of(ChannelGroup{channel, 0}), values);
}

ModalId States::remember(ModalValue value) {
    if (value.parts.size() > most_modal_parts) value = {{}, true};
    return table_.modals(value);
}

void States::know_entry_code(State& state, ChannelGroup of, double code) {
    state.root = maps_.set(state.root, entry_code_key(of), table_.constant(code));
}

void States::leave_out(State& state, Channels channels) {
    const std::vector<ModalId> nothing(entry_modals_.size(), table_.modals(ModalValue{}));
    for_each_channel(channels, [&](std::uint8_t channel) { write_groups(state, channel, nothing); });
}

void States::havoc(State& state, SpaceId space, const Origin& site) {
    const Key first = (Key{space} + 1) << 32U;
    state.root = maps_.without(state.root, first, first | 0xFFFFFFFFU);
    HavocSet havoc = table_.havoc(state.havoc);
    havoc.by_space[space] = table_.symbols(Symbol::opaque(site.id, 2, site.node));
    state.havoc = table_.remember(havoc);
}

/// Such an origin says more than that another variable was vacant at the start.
bool States::is_entry_of(OriginId vacancy_origin, Key key) const {
    const Origin& origin = table_.origins[vacancy_origin];
    const Variable variable = variable_of(key);
    return origin.kind == Origin::Kind::entry && origin.id == static_cast<std::uint32_t>(variable.number) &&
           origin.node == variable.space;
}

Value States::join_values(const Value& a, const Value& b, Key key, std::uint32_t node) {
    if (a == b) return a;
    Value joined;
    joined.know(semantics::join(a, b));
    joined.symbol = a.symbol == b.symbol ? a.symbol : table_.symbols(Symbol::joined_at(key, node));
    joined.origin = joined_origin(a, b);
    joined.vacancy_origin =
        a.vacancy_origin != 0 && !is_entry_of(b.vacancy_origin, key) ? a.vacancy_origin : b.vacancy_origin;
    joined.rounding = a.rounding != 0 ? a.rounding : b.rounding;
    joined.choices = table_.either(a, b);
    return joined;
}

ModalId States::join_modals(ModalId a, ModalId b) {
    if (a == b) return a;
    const ModalValue& other = table_.modals[b];
    if (table_.modals[a].includes(other)) return a;
    if (other.includes(table_.modals[a])) return b;
    ModalValue joined = table_.modals[a];
    joined.unknown |= other.unknown;
    for (const ModalPart& part : other.parts) add_part(joined, part);
    return remember(std::move(joined));
}

bool States::equal(const State& a, const State& b) const {
    return a.reached == b.reached && a.havoc == b.havoc && maps_.equal(a.root, b.root);
}

State States::merge(const State& a, const State& b, std::uint32_t node, Widening& widening) {
    if (!a.reached) return b;
    if (!b.reached || equal(a, b)) return a;
    State joined;
    joined.reached = true;
    constexpr std::uint32_t nothing = 0; // the constant symbol of no code: "not known"
    const auto join_variable = [&](Key key, const Value& x, const Value& y) {
        Value now = join_values(x, y, key, node);
        widening(x, now);
        return table_.values(now);
    };
    joined.root = maps_.merge(
        a.root, b.root,
        [&](Key key, std::uint32_t x, std::uint32_t y) {
            if (is_group_key(key)) return join_modals(x, y);
            return is_variable_key(key) ? join_variable(key, table_.values[x], table_.values[y]) : nothing;
        },
        [&](Key key, std::uint32_t x) {
            if (is_group_key(key)) return join_modals(x, absent_modal(key));
            if (!is_variable_key(key)) return nothing;
            const Value other = absent(b, key);
            return table_.values[x] == other ? x : join_variable(key, table_.values[x], other);
        },
        [&](Key key, std::uint32_t y) {
            if (is_group_key(key)) return join_modals(absent_modal(key), y);
            if (!is_variable_key(key)) return nothing;
            const Value other = absent(a, key);
            return table_.values[y] == other ? y : join_variable(key, other, table_.values[y]);
        });
    joined.havoc = a.havoc;
    if (a.havoc == b.havoc) return joined;
    HavocSet havoc = table_.havoc(a.havoc);
    const HavocSet other = table_.havoc(b.havoc);
    for (std::size_t space = 0; space < most_spaces; ++space)
        if (havoc.by_space[space] != other.by_space[space])
            havoc.by_space[space] = table_.symbols(Symbol::opaque(space, 3, node));
    joined.havoc = table_.remember(havoc);
    return joined;
}

State States::join(const State& a, const State& b, std::uint32_t node) {
    return merge(a, b, node, [](const Value&, Value&) {});
}

State States::widen(const State& old, const State& now, std::uint32_t node,
                    std::span<const double> thresholds) {
    return merge(old, now, node, [thresholds](const Value& before, Value& after) {
        if (after.choices != 0) return; // few numbers do not grow for long
        if (after.high > before.high) {
            const auto next = std::ranges::lower_bound(thresholds, after.high);
            after.high = next == thresholds.end() ? semantics::infinity : *next;
        }
        if (after.low < before.low) {
            const auto next = std::ranges::upper_bound(thresholds, after.low);
            after.low = next == thresholds.begin() ? -semantics::infinity : *std::prev(next);
        }
    });
}

void States::keep_groups_of(std::span<State* const> states) {
    std::vector<Root*> roots;
    for (State* state : states) {
        state->root = maps_.without(state->root, 0, group_keys - 1);
        state->root = maps_.without(state->root, entry_code_keys, std::numeric_limits<Key>::max());
        roots.push_back(&state->root);
    }
    entry_values_ = 0;
    maps_.keep_only(roots);
    table_.values = {};
    table_.fit();
}

} // namespace maclint::dataflow
