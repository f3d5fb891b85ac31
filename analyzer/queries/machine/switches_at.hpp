//! What is switched on or off at a block: on all paths to it, through the calls that lead there.
#pragma once

#include "analyzer/machine/switch_states.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

namespace maclint::queries {

/// The place of a switch in the control's list; nothing: it has none of that name.
[[nodiscard]] std::optional<std::size_t> find_switch(const ControlModel& control, std::string_view name);

/// Where a switch is surely still on, by the places where the blocks begin that have switched it on.
struct StillOn {
    std::set<Offset> at_end;                   ///< of the job
    std::map<Offset, EffectId> at_tool_change; ///< the first in the text
};

/// Answers for the blocks of one program. Those that are asked about in the order of the text cost one pass
/// over them together.
class SwitchesAt {
  public:
    explicit SwitchesAt(const ProgramAnalysis& analysis);

    /// All that the switch can be in front of the block, in the channels that run it, or in the section that
    /// describes something. Nothing in `can_be`: no path leads there.
    [[nodiscard]] machine::Switched before(const BlockView& block, const Section& section, std::size_t of);
    /// Whether in some block of the run the first may be surely on, and all of the others off that commas
    /// separate; an empty name asks nothing.
    [[nodiscard]] bool may_hold_in(const PlainRun& run, const Section& section, std::string_view on,
                                   std::string_view off);
    /// Of a section that describes something, what the switch is at its end.
    [[nodiscard]] machine::Switched at_end_of(const Section& section, std::size_t of);
    /// Of a switch of the machine or of a channel.
    [[nodiscard]] const StillOn& still_on(std::size_t of);

  private:
    /// The state at a place of a node, or of a section.
    struct Cursor {
        std::optional<flow::NodeId> node;
        Slice section = {};
        Offset place = 0;
        machine::SwitchState state;
    };
    /// A program's channel, and a switch.
    struct Entry {
        ProgramIndex program;
        std::uint8_t channel;
        std::size_t of;
        friend auto operator<=>(const Entry&, const Entry&) = default;
    };

    [[nodiscard]] const machine::SwitchState& state_at(std::uint8_t channel, flow::NodeId node, Offset place);
    [[nodiscard]] const machine::SwitchState& state_in(const Section& section, Offset place, Cursor& cursor);
    [[nodiscard]] machine::Switched resolved(const ProgramAnalysis& analysis, std::uint8_t channel,
                                             machine::Switched here, std::size_t of);
    [[nodiscard]] machine::Switched at_entry(const ProgramAnalysis& analysis, std::uint8_t channel,
                                             std::size_t of);
    [[nodiscard]] machine::Switched at_call(const ProgramAnalysis& calling, EffectId call,
                                            std::uint8_t channel, std::size_t of);
    [[nodiscard]] machine::Switched around_node(flow::NodeId node, std::size_t of, bool behind);
    [[nodiscard]] StillOn find_still_on(std::size_t of);

    const ProgramAnalysis& analysis_;
    std::vector<Cursor> cursors_; ///< by channel
    Cursor in_section_, end_of_section_;
    std::optional<machine::SwitchStepper> of_sections_;
    std::map<Entry, machine::Switched> entries_; ///< what callers leave, each found once
    std::map<std::size_t, StillOn> still_on_;    ///< by switch
};

} // namespace maclint::queries
