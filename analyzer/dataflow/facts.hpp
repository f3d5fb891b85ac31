//! What data flow found out, effect by effect: the material that rules are made of.
#pragma once

#include "analyzer/dataflow/arithmetic.hpp"
#include "analyzer/dataflow/state.hpp"
#include "analyzer/flow/graph.hpp"

#include <vector>

namespace maclint::dataflow {

/// A comparison or vacancy test that can be reached.
struct Comparison {
    flow::NodeId node;
    EffectId effect;
    ExpressionId expression;
    Operation operation;
    ExpressionId left_expression;
    ExpressionId right_expression; ///< vacancy tests: the same as left
    Value left;
    Value right; ///< vacancy tests: the same as left
    Truth truth;
};

/// A whole condition of IF or WHILE that can be reached.
struct Condition {
    flow::NodeId node;
    EffectId effect; ///< Guarded or RegionMark
    ExpressionId expression;
    Truth truth;
};

/// What a variable is read for.
enum class Use : std::uint8_t { copy, arithmetic, comparison, vacancy_test, word, argument, index, jump };

struct Read {
    flow::NodeId node;
    EffectId effect;
    ExpressionId expression;
    Variable variable;
    Value value;
    Use use;
};

/// A read of a modal group by its variable, and what the group can be there.
struct ModalRead {
    flow::NodeId node;
    ExpressionId expression;
    GroupId group;
    ModalValue value;
};

/// How a store changes the variable's own value: v = v + amount, v = v - amount.
struct Step {
    Operation operation;     ///< add or subtract
    ExpressionId expression; ///< of the amount
    Value amount;
};

struct Store {
    flow::NodeId node;
    EffectId effect;
    Variable variable;
    ExpressionId expression;
    Value value;
    Value old; ///< what the variable held before
    std::optional<Step> step;
};

/// Something other than an assignment may have changed variables: a call, an unreadable block, a store
/// through an index that can be many.
struct Clobber {
    flow::NodeId node;
    EffectId effect;
    SpaceId space;
    std::optional<Variable> variable; ///< empty: any variable of the space
};

/// A call that runs a program here.
struct CallMade {
    flow::NodeId node;
    EffectId effect;
    bool known;    ///< false: it is unknown what it does
    bool may_stop; ///< it may end in an alarm, a pause or the program's end; true when unknown
};

/// A modal group set by a block that is not plain.
struct ModalWrite {
    flow::NodeId node;
    EffectId effect;
    std::optional<GroupId> group; ///< as written, or as the value decides; empty: unknown
    bool stated;                  ///< the word names the group (F#4); otherwise the value decides (G#3)
    ExpressionId expression;
    Value value;
};

/// A jump whose target is computed.
struct ComputedJump {
    flow::NodeId node;
    EffectId effect;
    Value target;
};

/// The state with which the program is left.
struct ExitState {
    flow::Exit exit;
    State state;
};

/// The state in front of an effect that a rule wants to know of.
struct PointState {
    flow::NodeId node;
    EffectId effect;
    State state;
};

struct Facts {
    std::vector<Comparison> comparisons;
    std::vector<Condition> conditions;
    std::vector<Read> reads;
    std::vector<ModalRead> modal_reads;
    std::vector<Store> stores;
    std::vector<Clobber> clobbers;
    std::vector<CallMade> calls;
    std::vector<ModalWrite> modal_writes;
    std::vector<ComputedJump> computed_jumps;
    std::vector<PointState> tool_changes;
    std::vector<PointState> watched; ///< in front of words that set a watched group
    std::vector<ExitState> exits;    ///< reached ones

    /// Moves all facts to `to`, which gets no more memory than they need; the memory here stays for others,
    /// unless it is much.
    void hand_over(Facts& to);
};

} // namespace maclint::dataflow
