//! The switches in front of every node of a program, and what the program leaves.
#pragma once

#include "analyzer/flow/graph.hpp"
#include "analyzer/machine/switched.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/lines_with.hpp"
#include "analyzer/program/tables.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint::machine {

/// Runs blocks over the switches of a control.
class SwitchStepper {
  public:
    /// Of sections alone, or of the machine and its channels.
    SwitchStepper(const ControlModel& control, bool of_sections);

    void run(const BlockView& block, std::span<const Word> words, SwitchState& state) const;
    /// The codes that switch anything.
    [[nodiscard]] std::span<const LetterCodes> letters() const { return letters_; }

  private:
    /// What a code does to one switch.
    struct Action {
        std::int64_t code;    ///< a letter and a number, or any number
        std::string_view but; ///< numbers that are not meant
        std::string_view when;
        std::size_t of;
        std::uint8_t makes; ///< Switched::on, off or unknown
    };

    void add(std::size_t of, std::string_view codes, std::uint8_t makes);

    std::vector<Action> actions_; ///< by code
    std::vector<LetterCodes> letters_;
};

/// How a called program leaves the switches of a channel; nullptr: nobody has it.
using SwitchesLeftByCall = std::function<const SwitchState*(EffectId call, std::uint8_t channel)>;

/// Switches of one channel of a program.
class SwitchesOfChannel {
  public:
    SwitchesOfChannel(const Program& program, const flow::Graph& graph, const SwitchStepper& stepper,
                      std::uint8_t channel, SwitchesLeftByCall left_by_call);

    /// When the program returns; not reached: it never does.
    [[nodiscard]] const SwitchState& left() const { return left_; }
    [[nodiscard]] const SwitchState& before(flow::NodeId node) const { return before_[node]; }
    /// The blocks of the node that begin in the part, calls left out.
    void run_part(flow::NodeId id, Span part, SwitchState& state) const;
    /// All of the node, its calls included.
    void run(flow::NodeId id, SwitchState& state) const;

  private:
    void run_calls(const flow::Node& node, SwitchState& state) const;

    const Program* program_;
    const flow::Graph* graph_;
    const SwitchStepper* stepper_;
    std::uint8_t channel_;
    SwitchesLeftByCall left_by_call_;
    std::vector<SwitchState> before_;
    SwitchState left_;
};

/// Switches of all channels of a program.
class SwitchStates {
  public:
    /// Nothing is known where the control has no switches, or the program is too large.
    SwitchStates(const Program& program, const flow::Graph& graph, const SwitchesLeftByCall& left_by_call);
    SwitchStates(const SwitchStates&) = delete;
    SwitchStates& operator=(const SwitchStates&) = delete;

    /// Those of a channel; nullptr: nothing is known.
    [[nodiscard]] const SwitchesOfChannel* of(std::uint8_t channel) const;

  private:
    SwitchStepper stepper_;
    std::vector<std::pair<std::uint8_t, SwitchesOfChannel>> channels_;
};

} // namespace maclint::machine
