//! What is switched on or off at a block: on all paths to it, through the calls that lead there.
#pragma once

#include "analyzer/machine/switch_states.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace maclint::queries {

/// The place of a switch in the control's list; nothing: it has none of that name.
[[nodiscard]] std::optional<std::size_t> find_switch(const ControlModel& control, std::string_view name);

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

  private:
    /// The state at a place of a node, or of a section.
    struct Cursor {
        std::optional<flow::NodeId> node;
        Slice section = {};
        Offset place = 0;
        machine::SwitchState state;
    };

    [[nodiscard]] const machine::SwitchState& state_at(std::uint8_t channel, flow::NodeId node, Offset place);
    [[nodiscard]] const machine::SwitchState& state_in(const Section& section, Offset place);

    const ProgramAnalysis& analysis_;
    std::vector<Cursor> cursors_; ///< by channel
    Cursor in_section_;
    std::optional<machine::SwitchStepper> of_sections_;
};

/// What the switch is at the end of a section that describes something.
[[nodiscard]] machine::Switched switched_at_end(const Program& program, const Section& section,
                                                std::size_t of);

/// All that the switch can be in front of the node, in the channels that run it.
[[nodiscard]] machine::Switched switched_before(const ProgramAnalysis& analysis, flow::NodeId node,
                                                std::size_t of);

/// All that the switch can be at the end of the node, in the channels that run it.
[[nodiscard]] machine::Switched switched_after(const ProgramAnalysis& analysis, flow::NodeId node,
                                               std::size_t of);

} // namespace maclint::queries
