//! What the effects of one node do to a state.
#pragma once

#include "analyzer/dataflow/domain/known_start.hpp"
#include "analyzer/dataflow/domain/state.hpp"
#include "analyzer/dataflow/facts/fact_lists.hpp"
#include "analyzer/dataflow/solver/index_reach.hpp"
#include "analyzer/dataflow/solver/summary.hpp"
#include "analyzer/program/modal_groups.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace maclint {
struct VariableRange;
} // namespace maclint

namespace maclint::dataflow {

/// A value that the machine owns, `number` in its family.
struct MachineValue {
    FamilyId family;
    std::int32_t number;
    friend bool operator==(const MachineValue&, const MachineValue&) = default;
};

class Transfer {
  public:
    Transfer(const Program& program, const flow::Graph& graph, States& states, const Callees& callees);

    /// From now on what is read, compared and set is written down there, as far as it is recorded; nullptr
    /// ends it.
    void record_in(FactLists* facts) { facts_ = facts; }

    /// For those who follow one path. From now on a value of the machine keeps its symbol until it is stored.
    /// A value that changes by itself keeps it only until the machine does something. An input counts as
    /// changing by itself only when it is one of `awaited`.
    void follow_one_path(std::vector<MachineValue> awaited) {
        follows_one_path_ = true;
        awaited_ = std::move(awaited);
    }
    /// The last node of the path that moved the machine, called a program or waited (`acted`), and the last
    /// one that stored in a value of the machine (`stored`).
    struct MachineTime {
        flow::NodeId acted = 0, stored = 0;
        friend bool operator==(const MachineTime&, const MachineTime&) = default;
    };
    void set_machine_time(MachineTime time) { machine_time_ = time; }

    /// What the expression is in the state after the node that was run last.
    [[nodiscard]] Value value_in(const State& after, ExpressionId id) {
        return evaluate(after, id, Use::copy);
    }

    /// The number of expressions evaluated so far.
    [[nodiscard]] std::size_t evaluated() const { return evaluated_; }

    /// Calls come back whatever they are given.
    void follow_no_calls() { follows_calls_ = false; }

    /// The state after the node.
    [[nodiscard]] State run(flow::NodeId node, State state);
    /// The next edge belongs to another node or another state than the ones that were run last.
    void turn_back() {
        judged_.reset();
        compared_.reset();
    }
    /// The state on an edge of the node that was run last, given the state after it; not reached when the
    /// edge cannot be taken.
    [[nodiscard]] State along(const flow::Edge& edge, State after);

  private:
    template<class Fact>
    [[nodiscard]] bool records() const {
        return facts_ != nullptr && facts_->records<Fact>();
    }
    [[nodiscard]] Value evaluate(const State& state, ExpressionId id, Use use);
    [[nodiscard]] Value load_at(const State& state, FamilyId family, const Value& index, ExpressionId id,
                                Use use);
    [[nodiscard]] bool rests_on_vacant(const State& state, ExpressionId index);
    [[nodiscard]] Value load_modal(const State& state, GroupId group, ExpressionId id);
    [[nodiscard]] Value opaque(ExpressionId id);
    [[nodiscard]] Value machine_value(FamilyId family, std::int32_t number, ExpressionId id);
    [[nodiscard]] Value indexed_value(FamilyId family, const Value& index, ExpressionId id);
    [[nodiscard]] Value opaque_variable(Variable variable);
    [[nodiscard]] Truth evaluate_condition(const State& state, ExpressionId id);
    [[nodiscard]] Truth evaluate_chain(const State& state, std::span<const ExpressionId> operands, bool all);
    void refine(State& state, ExpressionId id, bool holds);
    void refine_side(State& state, ExpressionId side, const Value& value, Operation operation, Value other);
    void refine_factors(State& state, ExpressionId factor, const Value& zero);
    struct NumbersNamed {
        std::optional<Variable> variable;
        std::vector<double> numbers;
    };
    static constexpr std::size_t most_numbers_named = 8;
    [[nodiscard]] bool names_numbers(ExpressionId id, bool holds, NumbersNamed& named) const;
    void refine_to_one_of(State& state, ExpressionId id, bool holds);
    [[nodiscard]] bool keep_choices(Value& value, Operation operation, const Value& other);
    void refine_variable(State& state, Variable variable, Operation operation, const Value& other);
    void know_entry_code(State& state, ChannelGroup of, double code);
    void refine_entry_code(State& state, const Value& value, Operation operation, const Value& other);
    [[nodiscard]] Value record_read(const State& state, Variable variable, ExpressionId id, Use use);

    void apply(State& state, const Effect& effect);
    void judge(const State& state, ExpressionId condition);
    void assign(State& state, const Assign& assign);
    [[nodiscard]] std::optional<Step> step_of(const State& state, Variable variable, ExpressionId value);
    void store(State& state, Variable variable, Value value, ExpressionId expression);
    void store_at(State& state, const StoreAt& target, const Value& value, ExpressionId expression);
    void clobber_indexed(State& state, FamilyId of, ExpressionId index, const Value& known);
    void clobber_numbers(State& state, const VariableRange& range, const IndexReach& reach,
                         std::span<const Variable> spared);
    void clobber_passed(State& state, const Call& call);
    /// What is passed by reference may have changed: a variable, or one that an index names.
    void clobber_referenced(State& state, ExpressionId passed);
    [[nodiscard]] bool is_ambiguous(Variable variable) const;
    void set_modal(State& state, const SetModal& set);
    void set_group(State& state, GroupId group, const Value& value);
    void set_code(State& state, GroupId group, double code, OriginId origin);
    void end_groups(State& state, GroupId by, OriginId origin);
    void perhaps_end_groups(State& state, GroupId by, OriginId origin);
    [[nodiscard]] ModalId written(const State& state, ChannelGroup of, ModalId value);
    void write_group(State& state, ChannelGroup of, ModalValue value);
    void havoc_groups(State& state, std::optional<char> letter);
    void call(State& state, const Call& call);
    void run_word(State& state, const GivenWord& word);
    void run_program(State& state, EffectId id, const Call& call);
    [[nodiscard]] KnownStart known_at(const State& state, const Call& call,
                                      std::span<const Variable> deciding);
    [[nodiscard]] bool comes_back(const State& state, const Callee& callee, const Call& call);
    void record_begin(const State& state, EffectId id, const Call& call, std::span<const Variable> deciding);
    [[nodiscard]] bool is_made_to_stop(const Summary& called) const;
    void run_unknown_program(State& state, bool shared_frame);
    [[nodiscard]] bool is_modal_call(const ModalPart& part) const;
    void change_handed_down(State& state, const Summary& summary);
    void change_groups(State& state, const Summary& summary);
    void havoc(State& state, SpaceId space, std::optional<Variable> spared = {});
    void havoc_shared(State& state);
    void clobber(State& state, Variable variable, const Value& value);
    void move(State& state);
    void enter(flow::NodeId node);
    void run_of_plain_blocks(State& state, flow::NodeId node);
    [[nodiscard]] OriginId here();
    [[nodiscard]] Value number(ExpressionId id, double number);

    const Program& program_;
    const flow::Graph& graph_;
    States& states_;
    const Callees& callees_;
    IndexReaches index_reaches_;
    std::optional<GroupId> modal_call_group_;
    std::span<const EndedGroup> ended_groups_;
    FactLists* facts_ = nullptr;
    std::vector<ModalId> written_groups_; ///< of one channel, while they are collected
    std::vector<Key> own_handed_down_;    ///< variables that the program hands down, sorted
    std::vector<SymbolId> constants_;     ///< of the literals met so far; 0: not met
    std::vector<OriginId> origins_;       ///< of the effects met so far; 0: not met
    flow::NodeId node_ = 0;
    flow::NodeChannels channels_{}; ///< of the node
    EffectId effect_ = 0;
    std::optional<Truth> judged_; ///< of the node's condition, the same on all edges of a branch
    /// The comparison judged last in the state that is asked about, and its sides there.
    struct Compared {
        ExpressionId expression;
        Value left, right;
    };
    std::optional<Compared> compared_;
    bool in_chain_ = false; ///< conditions of an AND or OR are asked one after the other
    bool follows_one_path_ = false;
    std::vector<MachineValue> awaited_; ///< inputs that some loop waits for
    std::size_t evaluated_ = 0;
    MachineTime machine_time_;
    bool follows_calls_ = true;
    std::unordered_map<const Analysis*, std::vector<FollowedCall>> followed_; ///< into what they call
};

} // namespace maclint::dataflow
