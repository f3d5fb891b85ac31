//! Calls whose program comes to its own alarm on every path.
#pragma once

#include "analyzer/source/exemption.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <vector>

namespace maclint::rules {

/// By which a call may come to an alarm.
namespace exemptions {
inline constexpr Exemption called_to_stop;
} // namespace exemptions

/// An alarm that a program comes to, or one that it calls.
struct AlarmReached {
    const ProgramAnalysis* program; ///< in which it stands
    EffectId stop;
    Span text; ///< from the stop to the end of its block: number and message
    /// A shortest one in that program: from the test that decides where the call leads, else from its start.
    std::vector<flow::EdgeId> path;
    bool is_one_of_several = false; ///< numbers decide which alarm it is
};

enum class AlarmReason : std::uint8_t {
    left_out,     ///< for what the call leaves out, or passes vacant
    number,       ///< for the numbers that it passes, or that are there when it is made
    out_of_order, ///< for a letter that it passes behind a later one of its kind, where it counts as another
    fallen_in,    ///< whatever the call passes: blocks run into an alarm that is there for a test
    always,       ///< whatever the call passes
};

/// A call by which a program that was called passes on what brings the alarm.
struct PassedOn {
    const ProgramAnalysis* program; ///< in which it stands
    EffectId call;
    std::vector<flow::EdgeId> path; ///< a shortest one from that program's start
};

struct AlarmedCall {
    flow::NodeId node; ///< where the program is begun: of a modal call its first move
    EffectId call;
    const ProgramAnalysis* called;
    AlarmReason reason;
    /// For the first three: what conditions on the path ask for, as far as is seen: vacant, or with a number.
    std::vector<Variable> asked;
    AlarmReached alarm;
    std::vector<PassedOn> through;  ///< in the order of calls; empty: the called program brings it itself
    std::optional<Span> shown = {}; ///< where a remark of the called program itself shows the call
};

/// In text order, each call once. What is vacant is asked first, then numbers with it. Calls that are made to
/// raise the alarm are none: another path leads around them, no work stands behind them that only they lead
/// to, and their program does nothing else.
[[nodiscard]] std::vector<AlarmedCall> find_alarmed_calls(const ProgramAnalysis& analysis);

} // namespace maclint::rules
