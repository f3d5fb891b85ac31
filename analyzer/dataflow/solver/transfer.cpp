//! Effects: stores, modal groups, calls, and what a plain run leaves behind.
#include "analyzer/dataflow/solver/transfer.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/overloaded.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace maclint::dataflow {
namespace {

/// An index with so few possible numbers that each is a store of its own.
constexpr double most_indexed_variables = 64;

} // namespace

Transfer::Transfer(const Program& program, const flow::Graph& graph, States& states, const Callees& callees)
    : program_(program)
    , graph_(graph)
    , states_(states)
    , callees_(callees)
    , index_reaches_(program, graph)
    , modal_call_group_(program.control->group_with(ModalRole::macro_call))
    , ended_groups_(program.control->ended_groups)
    , constants_(program.expressions.size(), 0)
    , origins_(program.effects.size(), 0) {
    for (const Variable variable : program.handed_down) own_handed_down_.push_back(key_of(variable));
    std::ranges::sort(own_handed_down_);
}

/// The effect as an origin. An effect belongs to one node.
OriginId Transfer::here() {
    OriginId& known = origins_[effect_];
    if (known == 0) known = states_.table().origins({Origin::Kind::effect, effect_, node_});
    return known;
}

void Transfer::enter(flow::NodeId node) {
    node_ = node;
    channels_ = graph_.channels_at(node);
}

State Transfer::run(flow::NodeId node, State state) {
    enter(node);
    turn_back();
    const flow::Node& n = graph_.nodes[node];
    if (n.is_run) {
        run_of_plain_blocks(state, node);
        return state;
    }
    for (Id i = n.effects.first; i < n.effects.first + n.effects.count; ++i) {
        effect_ = i;
        apply(state, program_.effects[i]);
    }
    return state;
}

State Transfer::along(const flow::Edge& edge, State after) {
    if (!after.reached) return {};
    enter(edge.from);
    if (channels_.running != graph_.all_channels) {
        using Kind = flow::EdgeKind;
        const auto others = static_cast<Channels>(graph_.all_channels & ~channels_.running);
        if (edge.kind == Kind::pass) states_.leave_out(after, channels_.running);
        if (edge.kind == Kind::jump || edge.kind == Kind::computed || edge.kind == Kind::resume)
            states_.leave_out(after, others);
    }
    // A condition that only some channels ask does not decide for the other channels.
    if (edge.condition && channels_.running == graph_.all_channels) {
        if (!judged_) judged_ = evaluate_condition(after, *edge.condition);
        if (edge.holds ? !judged_->can_hold : !judged_->can_fail) return {};
        refine(after, *edge.condition, edge.holds);
    } else if (edge.label) {
        const auto* number = std::get_if<std::int64_t>(&graph_.labels[*edge.label].label);
        if (number == nullptr) return after; // nothing is known of texts
        const auto& jump = std::get<Jump>(program_.effects[*edge.jump].what);
        const Value target = evaluate(after, jump.target, Use::jump);
        if (!states_.table().can_be(target, static_cast<double>(*number))) return {};
    }
    return after;
}

void Transfer::apply(State& state, const Effect& effect) {
    std::visit(overloaded{
                   [&](const Assign& what) { assign(state, what); },
                   [&](const SetModal& what) { set_modal(state, what); },
                   // Such an effect changes nothing. It is evaluated only where facts are recorded, and a
                   // number gives none.
                   [&](const EvaluateWords& what) {
                       if (facts_ == nullptr) return;
                       for (const ExpressionId value : program_.values_of(what))
                           if (!std::holds_alternative<Literal>(program_.expressions[value].node))
                               (void)evaluate(state, value, Use::word);
                   },
                   [&](const Motion&) { move(state); },
                   [&](const Call& what) { call(state, what); },
                   [&](const Guarded& what) {
                       if (facts_ == nullptr) return;
                       judge(state, what.condition);
                   },
                   [&](const RegionMark& what) {
                       if (facts_ == nullptr || !what.condition) return;
                       judge(state, *what.condition);
                   },
                   [&](const Jump& what) {
                       if (facts_ == nullptr) return;
                       const Value target = evaluate(state, what.target, Use::jump);
                       if (records<ComputedJump>() && !flow::constant_target(program_, what.target))
                           facts_->add(ComputedJump{node_, effect_, target});
                   },
                   [&](const Exchange& what) {
                       if (facts_ != nullptr)
                           for (const ExpressionId out : program_.values_of(what))
                               (void)evaluate(state, out, Use::word);
                       for (const Variable in : program_.variables_of(what))
                           clobber(state, in, opaque_variable(in));
                   },
                   [&](const UnreadableBlock& what) {
                       for (const Variable variable : program_.variables_of(what))
                           clobber(state, variable, opaque_variable(variable));
                       if (what.may_call_or_return) havoc_shared(state);
                   },
                   [&](const ToolChange&) {
                       if (records<BeforeToolChange>())
                           facts_->add(BeforeToolChange{{node_, effect_, state}});
                   },
                   [&](const Stop& what) {
                       if (facts_ != nullptr && what.number) (void)evaluate(state, *what.number, Use::word);
                   },
                   [](const auto&) {},
               },
               effect.what);
}

/// Writes the condition down. It is the last effect of its node, whose edges need not ask again.
void Transfer::judge(const State& state, ExpressionId condition) {
    judged_ = evaluate_condition(state, condition);
    if (records<Condition>()) facts_->add(Condition{node_, effect_, condition, *judged_});
}

// ---- stores ----

void Transfer::assign(State& state, const Assign& assign) {
    const Value value = evaluate(state, assign.value, Use::copy);
    std::visit(overloaded{
                   [&](const Variable& variable) { store(state, variable, value, assign.value); },
                   [&](const StoreAt& target) { store_at(state, target, value, assign.value); },
                   [](const StoreMachine&) {},
               },
               assign.target);
}

void Transfer::store(State& state, Variable variable, Value value, ExpressionId expression) {
    // Channels have variables of their own, and run at the same time.
    if (channels_.running != graph_.all_channels || is_ambiguous(variable))
        return clobber(state, variable, opaque_variable(variable));
    value = states_.typed(value, variable);
    if (records<Store>())
        facts_->add(Store{node_, effect_, variable, expression, value, states_.read(state, variable),
                          step_of(state, variable, expression)});
    value.origin = here();
    states_.write(state, variable, value);
}

void Transfer::store_at(State& state, const StoreAt& target, const Value& value, ExpressionId expression) {
    const Value index = evaluate(state, target.index, Use::index);
    const VariableFamily& family = program_.control->families[target.family];
    if (const auto number = index.constant(); number && std::abs(*number) < 1e9) {
        const auto rounded = static_cast<std::int32_t>(std::lround(*number));
        const VariableRange* range = family.find(rounded);
        if (range == nullptr) return;
        if (range->on_write == OnWrite::set_modal)
            set_group(state, range->group, value);
        else if (range->meaning == Meaning::variable)
            store(state, {range->space, rounded}, value, expression);
        return;
    }
    clobber_indexed(state, target.family, target.index, index);
}

/// The variables of a family that the index can mean may have changed.
void Transfer::clobber_indexed(State& state, FamilyId of, ExpressionId index, const Value& known) {
    IndexReach reach = index_reaches_.of(of, index, known, node_);
    reach.numbers.low = std::round(reach.numbers.low); // a fraction is rounded [SINHA-INT]
    reach.numbers.high = std::round(reach.numbers.high);
    const VariableFamily& family = program_.control->families[of];
    std::vector<Variable> spared;
    if (family.custom.spares_index) spared = variables_of(program_, index).variables;
    for (const VariableRange& range : family.ranges) {
        if (range.meaning != Meaning::variable) continue;
        if (!reach.locals && program_.control->spaces[range.space].scope == Scope::frame) continue;
        if (reach.numbers.low <= range.last && range.first <= reach.numbers.high)
            clobber_numbers(state, range, reach, spared);
    }
}

void Transfer::clobber_numbers(State& state, const VariableRange& range, const IndexReach& reach,
                               std::span<const Variable> spared) {
    const double first = std::max<double>(reach.numbers.low, range.first);
    const double last = std::min<double>(reach.numbers.high, range.last);
    if (last - first > most_indexed_variables) {
        const auto here = std::ranges::find(spared, range.space, &Variable::space);
        return havoc(state, range.space, here == spared.end() ? std::nullopt : std::optional(*here));
    }
    for (auto number = static_cast<std::int32_t>(std::lround(first)); number <= std::lround(last); ++number) {
        const Variable variable{range.space, number};
        if (std::ranges::find(spared, variable) == spared.end())
            clobber(state, variable, opaque_variable(variable));
    }
}

/// Another variable has the same number.
bool Transfer::is_ambiguous(Variable variable) const {
    const VariableSpace& space = program_.control->spaces[variable.space];
    return space.named && space.scope != Scope::frame &&
           std::ranges::binary_search(states_.ambiguous_names(), variable.number);
}

/// Recognises v = v + amount, v = amount + v and v = v - amount.
std::optional<Step> Transfer::step_of(const State& state, Variable variable, ExpressionId value) {
    const auto* apply = std::get_if<Apply>(&program_.expressions[value].node);
    if (apply == nullptr || (apply->operation != Operation::add && apply->operation != Operation::subtract))
        return std::nullopt;
    const auto operands = program_.operands_of(*apply);
    const auto is_self = [&](ExpressionId id) {
        const auto* load = std::get_if<Load>(&program_.expressions[id].node);
        return load != nullptr && load->variable == variable;
    };
    std::optional<ExpressionId> amount;
    if (is_self(operands[0]))
        amount = operands[1];
    else if (apply->operation == Operation::add && is_self(operands[1]))
        amount = operands[0];
    if (!amount) return std::nullopt;
    FactLists* const facts = std::exchange(facts_, nullptr); // its reads are recorded already
    const Step step{apply->operation, *amount, evaluate(state, *amount, Use::arithmetic)};
    facts_ = facts;
    return step;
}

// ---- modal groups ----

void Transfer::set_modal(State& state, const SetModal& set) {
    Value value = evaluate(state, set.value, Use::word);
    std::optional<GroupId> group = set.group;
    if (!group) {
        group = states_.table().entry_group_of(value.symbol);
        if (group && program_.control->groups[*group].letter != set.letter) group = std::nullopt;
        if (!group)
            if (const auto code = value.constant())
                if (const auto member = program_.control->member_of(set.letter, *code)) {
                    group = member->group;
                    if (member->code != *code) value = number_value(states_.table(), member->code);
                }
    }
    if (records<ModalWrite>())
        facts_->add(ModalWrite{node_, effect_, group, set.group.has_value(), set.value, value});
    if (records<BeforeWatchedWord>() && group && program_.control->groups[*group].watched)
        facts_->add(BeforeWatchedWord{{node_, effect_, state}});
    if (group)
        set_group(state, *group, value);
    else if (!value.constant() && value.vacancy != Vacancy::vacant)
        havoc_groups(state, set.letter);
}

void Transfer::set_group(State& state, GroupId group, const Value& value) {
    if (value.vacancy == Vacancy::vacant)
        return; // a word with a vacant variable is ignored [SEED-001:187-195]
    const OriginId origin = here();
    if (value.vacancy == Vacancy::maybe) {
        for_each_channel(channels_.running, [&](std::uint8_t channel) {
            ModalValue either = states_.read(state, ChannelGroup{channel, group});
            // The same value set before, F#9 in the block above: this word has set it again, or neither has.
            const auto others = std::ranges::remove_if(
                either.parts, [&](const ModalPart& p) { return p.symbol == value.symbol; });
            either.parts.cut_off(others.begin());
            either.parts.push_back({value.symbol, origin});
            either.put_in_order();
            write_group(state, {channel, group}, std::move(either));
        });
        return perhaps_end_groups(state, group, origin);
    }
    if (value.vacancy == Vacancy::unknown) {
        const SymbolId either = states_.table().symbols(Symbol::value_if_set(value.symbol, effect_, node_));
        for_each_channel(channels_.running, [&](std::uint8_t channel) {
            write_group(state, {channel, group}, {{{either, origin}}, false});
        });
        return perhaps_end_groups(state, group, origin);
    }
    if (const auto code = value.constant()) return set_code(state, group, *code, origin);
    for_each_channel(channels_.running, [&](std::uint8_t channel) {
        write_group(state, {channel, group}, {{{value.symbol, origin}}, false});
    });
    end_groups(state, group, origin);
}

/// A code of the one group ends what others have in force: G00 a canned cycle.
void Transfer::end_groups(State& state, GroupId by, OriginId origin) {
    for (const EndedGroup& ended : ended_groups_) {
        if (ended.by != by) continue;
        const ModalValue now = states_.read(state, channels_.running, ended.group);
        const SymbolId cancelled = states_.table().constant(ended.code);
        if (now.unknown ||
            std::ranges::any_of(now.parts, [&](const ModalPart& part) { return part.symbol != cancelled; }))
            set_code(state, ended.group, ended.code, origin);
    }
}

/// The same for a word that may be ignored.
void Transfer::perhaps_end_groups(State& state, GroupId by, OriginId origin) {
    for (const EndedGroup& ended : ended_groups_) {
        if (ended.by != by) continue;
        for_each_channel(channels_.running, [&](std::uint8_t channel) {
            ModalValue either = states_.read(state, ChannelGroup{channel, ended.group});
            either.parts.push_back({states_.table().constant(ended.code), origin});
            either.put_in_order();
            write_group(state, {channel, ended.group}, std::move(either));
        });
    }
}

/// A channel that does not come here sets nothing. A channel of which that is unknown may have set the group.
ModalId Transfer::written(const State& state, ChannelGroup of, ModalId value) {
    if (graph_.channels.empty()) return value;
    const ModalId known = states_.id_of(state, of);
    ModalValue before = states_.table().modals[known];
    if (before.parts.empty() && !before.unknown) return known;
    if ((channels_.uncertain >> of.channel & 1U) == 0) return value;
    before.unknown = true;
    return states_.remember(std::move(before));
}

void Transfer::write_group(State& state, ChannelGroup of, ModalValue value) {
    states_.write(state, of, written(state, of, states_.remember(std::move(value))));
}

void Transfer::set_code(State& state, GroupId group, double code, OriginId origin) {
    for_each_channel(channels_.running, [&](std::uint8_t channel) {
        SymbolId symbol = states_.table().constant(code);
        // On a path where the caller's code is known to be this one, setting it puts the caller's code back.
        if (states_.entry_code(state, {channel, group}) == code)
            symbol = states_.table().symbols(Symbol::group_at_entry(group));
        write_group(state, {channel, group}, {{{symbol, origin}}, false});
    });
    end_groups(state, group, origin);
}

/// Without a letter: all groups.
void Transfer::havoc_groups(State& state, std::optional<char> letter) {
    const auto& groups = program_.control->groups;
    for_each_channel(channels_.running, [&](std::uint8_t channel) {
        written_groups_.assign(groups.size(), PersistentMap::absent);
        for (std::size_t i = 0; i < groups.size(); ++i) {
            const ChannelGroup of{channel, static_cast<GroupId>(i)};
            const ModalValue& before = states_.read(state, of);
            if ((letter && groups[i].letter != *letter) || before.unknown) continue;
            ModalValue value = before;
            value.unknown = true;
            written_groups_[i] = written(state, of, states_.remember(std::move(value)));
        }
        states_.write_groups(state, channel, written_groups_);
    });
}

// ---- calls ----

void Transfer::call(State& state, const Call& call) {
    if (facts_ != nullptr) {
        for (const Argument& argument : program_.arguments_of(call))
            (void)evaluate(state, argument.value, Use::argument);
        if (call.repeat) (void)evaluate(state, *call.repeat, Use::word);
        if (const auto* number = std::get_if<ExpressionId>(&call.program))
            (void)evaluate(state, *number, Use::word);
    }
    const CallKind& kind = program_.control->calls[call.kind];
    if (kind.trigger == CallTrigger::once) {
        const State before = state;
        run_program(state, effect_, call);
        if (!flow::surely_runs(program_, call)) state = states_.join(before, state, node_);
        return;
    }
    if (const auto group = modal_call_group_) set_code(state, *group, kind.modal_code, here());
}

void Transfer::run_unknown_program(State& state, bool shared_frame) {
    havoc_shared(state);
    for (std::size_t i = 0; i < program_.control->spaces.size(); ++i)
        if (shared_frame && program_.control->spaces[i].scope == Scope::frame)
            havoc(state, static_cast<SpaceId>(i));
    change_handed_down(state, {});
    havoc_groups(state, std::nullopt);
}

void Transfer::run_word(State& state, const GivenWord& word) {
    if (word.changes_tool && records<BeforeToolChange>())
        facts_->add(BeforeToolChange{{node_, effect_, state}});
    for (const auto& [group, code] : word.sets) set_code(state, group, code, here());
}

void Transfer::run_program(State& state, EffectId id, const Call& call) {
    const Callee callee = callees_(id);
    const Summary& summary = callee.summary;
    // What the control or its machine brings and no program replaces comes back, and changes nothing of the
    // program's.
    const bool is_brought =
        !summary.known && (callee.word != nullptr || program_.control->calls[call.kind].brought_by_control);
    if (records<CallMade>() && !is_brought)
        facts_->add(CallMade{node_, id, summary.known, !summary.known || summary.may_stop});
    if (records<CallBegun>() && (summary.alarm_end.always || !summary.asked_at_calls.empty()))
        record_begin(state, id, call, summary.asked_at_calls);
    const bool shared_frame = program_.control->calls[call.kind].frame == Frame::shared;
    if (!comes_back(state, callee, call) && is_made_to_stop(summary)) {
        state.reached = false;
        return;
    }
    if (!summary.known) {
        if (callee.word != nullptr) return run_word(state, *callee.word);
        if (is_brought) return;
        clobber_passed(state, call);
        return run_unknown_program(state, shared_frame);
    }
    const auto visible = [&](SpaceId space) {
        return shared_frame || program_.control->spaces[space].scope != Scope::frame;
    };
    for (const SpaceId space : summary.havoc)
        if (visible(space)) havoc(state, space);
    const auto change_variable = [&](Variable variable, const VariableChange& change) {
        Value value;
        value.symbol = opaque_variable(variable).symbol;
        value.vacancy = change.vacancy;
        value.vacancy_origin =
            change.vacancy == Vacancy::maybe || change.vacancy == Vacancy::vacant ? here() : 0;
        value.low = change.low;
        value.high = change.high;
        value.integer = change.integer;
        value.exactness = change.exactness == Exactness::rounded ? Exactness::unknown : change.exactness;
        value.origin = here();
        clobber(state, variable, value);
    };
    for (const VariableChange& change : summary.variables) {
        for (const PassedReference& passed : callee.references) {
            if (passed.formal != change.variable) continue;
            if (const auto* load = std::get_if<Load>(&program_.expressions[passed.value].node))
                change_variable(load->variable, change);
            else
                clobber_referenced(state, passed.value);
        }
        if (visible(change.variable.space)) change_variable(change.variable, change);
    }
    change_handed_down(state, summary);
    if (summary.alarm_end.always) return havoc_groups(state, std::nullopt);
    change_groups(state, summary);
}

/// Once without numbers: whether variables are set at all tells where most calls lead.
void Transfer::record_begin(const State& state, EffectId id, const Call& call,
                            std::span<const Variable> deciding) {
    KnownStart start = known_at(state, call, deciding);
    if (start.arguments)
        std::ranges::sort(*start.arguments, {}, [](const auto& passed) { return key_of(passed.first); });
    KnownStart with_numbers = start;
    if (std::erase_if(start.known, [](const KnownVariable& known) { return known.number.has_value(); }) == 0)
        with_numbers = {};
    facts_->add(CallBegun{node_, id, std::move(start), std::move(with_numbers)});
}

/// Whether the program is called here in order to stop. Any other call is taken for one that comes back, so
/// that what stands behind it counts.
bool Transfer::is_made_to_stop(const Summary& called) const {
    return called.alarm_end.is_for_stopping() && !graph_.expects_return(node_);
}

/// An unknown program may store in variables that are, or may be, passed by reference.
void Transfer::clobber_passed(State& state, const Call& call) {
    for (const Argument& argument : program_.arguments_of(call)) {
        if (argument.passing == Passing::by_value) continue;
        clobber_referenced(state, argument.value);
    }
}

void Transfer::clobber_referenced(State& state, ExpressionId passed) {
    const auto& node = program_.expressions[passed].node;
    if (const auto* load = std::get_if<Load>(&node))
        clobber(state, load->variable, opaque_variable(load->variable));
    else if (const auto* indexed = std::get_if<LoadAt>(&node))
        clobber_indexed(state, indexed->family, indexed->index, evaluate(state, indexed->index, Use::index));
}

/// Called programs may change what this program hands down to them, and what was handed down to this program.
void Transfer::change_handed_down(State& state, const Summary& summary) {
    const auto& written = summary.written_for_callers;
    const auto may_be_written = [&](Variable variable) {
        return !program_.control->spaces[variable.space].written_once &&
               (!written || std::ranges::binary_search(*written, program_.spell(variable)));
    };
    for (const Variable variable : program_.handed_down) {
        if (!may_be_written(variable)) continue;
        const Variable meant = program_.meant_by(variable);
        clobber(state, meant, opaque_variable(meant));
    }
    for (const Variable variable : states_.handed_down()) {
        if (!std::ranges::binary_search(own_handed_down_, key_of(variable)) && may_be_written(variable))
            clobber(state, variable, opaque_variable(variable));
    }
}

void Transfer::change_groups(State& state, const Summary& summary) {
    const OriginId origin = here();
    for_each_channel(channels_.running, [&](std::uint8_t channel) {
        written_groups_.assign(program_.control->groups.size(), PersistentMap::absent);
        for (const GroupChange& change : summary.groups) {
            const bool surely_here = (change.channels >> channel & 1U) != 0;
            if (!surely_here && channel != 0) continue;
            const ChannelGroup of{channel, change.group};
            // Where the caller names no channel, the group may change in several channels of the callee.
            ModalId& now = written_groups_[change.group];
            if (now == PersistentMap::absent) now = states_.id_of(state, of);
            ModalValue value;
            if (change.may_keep || !surely_here) value = states_.table().modals[now];
            for (const double code : change.codes)
                value.parts.push_back({states_.table().constant(code), origin});
            value.unknown |= change.other || !surely_here;
            if (change.other) {
                const SymbolId left = states_.table().symbols(
                    Symbol::opaque(side_by_side(effect_, node_), 10U << 8U, change.group));
                value.parts.push_back({left, origin});
            }
            value.put_in_order();
            now = written(state, of, states_.remember(std::move(value)));
        }
        states_.write_groups(state, channel, written_groups_);
    });
}

void Transfer::havoc_shared(State& state) {
    for (std::size_t i = 0; i < program_.control->spaces.size(); ++i)
        if (program_.control->spaces[i].scope != Scope::frame) havoc(state, static_cast<SpaceId>(i));
}

/// Everything in the space may have changed here.
void Transfer::havoc(State& state, SpaceId space, std::optional<Variable> spared) {
    if (records<Clobber>()) facts_->add(Clobber{node_, effect_, space, {}, spared});
    std::optional<Value> kept;
    if (spared) kept = states_.read(state, *spared);
    states_.havoc(state, space, {Origin::Kind::effect, effect_, node_});
    if (spared) states_.write(state, *spared, *kept);
}

/// The variable may have changed here, by something that is no assignment.
void Transfer::clobber(State& state, Variable variable, const Value& value) {
    if (records<Clobber>()) facts_->add(Clobber{node_, effect_, variable.space, variable});
    states_.write(state, variable, value);
}

/// A value of which nothing is known, the one that the effect leaves in the variable.
Value Transfer::opaque_variable(Variable variable) {
    constexpr std::uint32_t left = 1U << 8U;
    Value value;
    value.symbol = states_.table().symbols(Symbol::opaque(side_by_side(effect_, node_), left | variable.space,
                                                          static_cast<std::uint32_t>(variable.number)));
    return value;
}

/// Whether the part is the code of a modal call. An unknown program is not assumed to leave one in force:
/// otherwise every move after it could do anything.
bool Transfer::is_modal_call(const ModalPart& part) const {
    const auto code = states_.table().number_of(part.symbol);
    return code && std::ranges::any_of(program_.control->calls, [&](const CallKind& kind) {
               return kind.trigger != CallTrigger::once && kind.modal_code == *code;
           });
}

void Transfer::move(State& state) {
    const auto group = modal_call_group_;
    if (!group) return;
    // Moving while a modal call is active runs its program [SEED-001:466].
    const auto parts = states_.read(state, channels_.running, *group).parts;
    for (const ModalPart& part : parts) {
        const Origin& origin = states_.table().origins[part.origin];
        if (origin.kind != Origin::Kind::effect) continue;
        const auto* call = std::get_if<Call>(&program_.effects[origin.id].what);
        if (call == nullptr) continue;
        const bool made_here = program_.control->calls[call->kind].trigger != CallTrigger::once;
        if (!made_here && !is_modal_call(part)) continue;
        State moved = state;
        effect_ = origin.id; // a plain run has no effect of its own
        if (made_here) {
            run_program(moved, effect_, *call);
        } else { // a program called before has left a modal call of its own in force
            if (records<CallMade>()) facts_->add(CallMade{node_, effect_, false, true});
            run_unknown_program(moved, false);
        }
        for_each_channel(channels_.running, [&](std::uint8_t channel) {
            states_.write(moved, ChannelGroup{channel, *group},
                          states_.read(state, ChannelGroup{channel, *group}));
        });
        state = states_.join(state, moved, node_);
    }
}

void Transfer::run_of_plain_blocks(State& state, flow::NodeId node) {
    const flow::Node& n = graph_.nodes[node];
    for_each_last_setting(program_, n.stretch(), [&](const ModalSetting& setting) {
        set_code(state, setting.group, setting.value,
                 states_.table().origins({Origin::Kind::run, setting.group, node_}));
    });
    // A program called after each move runs between these settings and after them.
    if (moves(program_, n.stretch())) move(state);
}

} // namespace maclint::dataflow
