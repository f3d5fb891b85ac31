//! What a call of a program does to its caller, in words that hold outside the program.
#pragma once

#include "analyzer/dataflow/domain/value.hpp"
#include "analyzer/flow/graph.hpp"
#include "analyzer/program/given.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace maclint::dataflow {

class Analysis;

struct VariableChange {
    Variable variable;
    Vacancy vacancy;
    double low, high;
    bool integer;
    Exactness exactness;
};

struct GroupChange {
    GroupId group;
    bool may_keep;             ///< on some path the caller's code is in force again
    std::vector<double> codes; ///< codes that the program may leave behind
    bool other;                ///< it may leave something else behind
    Channels channels;         ///< in which; all where it names none
};

/// What decides whether a program stops instead of returning.
struct StopReasons {
    bool anything = true; ///< the machine, an operator, a program that is called
    std::vector<Variable> variables;
};

/// How a program comes to an alarm of its own, or of a program that it calls.
struct AlarmEnd {
    bool possible = false;
    bool always = false;     ///< on every path, for all calls that are known
    bool in_text = false;    ///< on every path, whatever it is called with
    bool works = false;      ///< it, or what it calls, moves or changes a tool somewhere
    bool by_mistake = false; ///< `in_text`, after work: blocks run into an alarm that is there for a test

    /// Whether somebody may call it in order to stop.
    [[nodiscard]] bool is_for_stopping() const { return in_text ? !by_mistake : !works; }
};

struct Summary {
    bool known = false;  ///< false: the program is not there, everything may change
    bool returns = true; ///< at least one path leads back to the block after the call
    AlarmEnd alarm_end;
    bool may_stop = true;     ///< it or what it calls may stop: an alarm, a pause, the program's end
    StopReasons stop_reasons; ///< where it may stop
    /// Variables that conditions and computed jumps read, where it may end in an alarm in place of a return:
    /// with what they are at a call it may be known that it does. None where a call tells nothing.
    std::vector<Variable> decides_end;
    /// Variables that it passes to programs which may end in an alarm for it, and those that these find set.
    std::vector<Variable> decides_calls;
    /// All of these, those that decide over its ways there, and those that decide what the words of its
    /// blocks are, unless they are too many.
    std::vector<Variable> asked_at_calls;
    std::vector<VariableChange>
        variables; ///< all that it may write and the caller can see (locals for calls that share them)
    std::vector<SpaceId> havoc; ///< spaces of which anything may have changed
    std::vector<GroupChange> groups;
    std::shared_ptr<const flow::LabelList> resume_labels; ///< of its callers (M99 P); nullptr: none
    /// Variables, as they are spelled, that it writes and that may be the caller's, handed down to it;
    /// absent: any of them.
    std::optional<std::vector<std::string>> written_for_callers;
};

/// A variable of the caller, or one that an index names, that is a parameter of the callee: what is stored in
/// one is stored in the other.
struct PassedReference {
    Variable formal;
    ExpressionId value; ///< a Load or LoadAt of the caller
};

/// What a call runs.
struct Callee {
    const Summary& summary;                      ///< Summary{} of a program that is not known
    std::span<const PassedReference> references; ///< of a program that is known
    const Analysis* analysis = nullptr;          ///< of a program that is known
    const GivenWord* word = nullptr; ///< that is called, where it is no program, and what it does is known
};
using Callees = std::function<Callee(EffectId call)>;

} // namespace maclint::dataflow
