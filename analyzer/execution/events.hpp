//! What the stepper reports of a run.
#pragma once

#include "analyzer/program/model.hpp"
#include "analyzer/semantics/concrete.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <functional>
#include <optional>
#include <variant>

namespace maclint::execution {

using semantics::Content;

// Every event is one of the program that runs at the time; see Stepper::program().

struct ProgramBegins {};
/// A block that is not skipped.
struct BlockBegins {
    Span span;
    bool has_effects; ///< which follow, each with an event of its own
};
struct EffectBegins {
    EffectId effect;
};
struct VariableRead {
    ExpressionId expression;
    Variable variable;
    Content content;
};
struct GroupRead {
    ExpressionId expression;
    GroupId group;
    double code;
};
/// An operator or function of one or two operands, before it is computed; one operand: it is on both sides.
struct Applied {
    ExpressionId expression;
    Content left, right;
};
/// Comparisons and vacancy tests; those have the same content on both sides.
struct Compared {
    ExpressionId expression;
    Content left, right;
    bool truth;
};
/// The value of a word, an argument, an assignment, an alarm's number or what is printed; of an assignment
/// through an index also the index.
struct ValueTaken {
    ExpressionId expression;
    Content content;
};
/// A whole condition.
struct Decided {
    ExpressionId condition;
    bool truth;
};
struct Stored {
    Variable variable;
    Content old, content;
};
/// A group set by a block that is not plain.
struct GroupSet {
    GroupId group;
    double code;
};
struct JumpComputed {
    double target;
};
/// A program is called; `target` is empty where the workspace does not have it.
struct CallBegins {
    EffectId call;
    std::optional<ProgramIndex> target;
    bool shares_locals; ///< the called program has no local variables of its own
};
/// Back in the caller, after the call or at a label.
struct CallEnds {
    EffectId call;
    std::optional<ProgramIndex> target;
    std::optional<std::int64_t> label;
};

/// How a program is left.
enum class Leaving : std::uint8_t {
    returns,
    runs_off,   ///< past its last block
    ends,       ///< M30
    restarts,   ///< it ends and begins again
    alarm,      ///< that the program raises itself
    fault,      ///< an alarm of the control: a division by 0, a label that is not there
    unreadable, ///< a block that could not be read
    cut_off,    ///< the bounds of the run are met
};
/// The program is left; everything still stands as it has left it.
struct ProgramLeft {
    Leaving how;
    std::optional<EffectId> effect; ///< the return or stop
    std::optional<double> label;    ///< of a return to a sequence number of the caller
};

using Event =
    std::variant<ProgramBegins, BlockBegins, EffectBegins, VariableRead, GroupRead, Applied, Compared,
                 ValueTaken, Decided, Stored, GroupSet, JumpComputed, CallBegins, CallEnds, ProgramLeft>;

class Stepper;
using Observer = std::function<void(Stepper&, const Event&)>;

} // namespace maclint::execution
