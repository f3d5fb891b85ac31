//! Reads the moves of a program in the order of its text, and the first ones of those it calls.
#include "analyzer/machine/late_lifts.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>

namespace maclint::machine {
namespace {

constexpr std::size_t z_axis = 2;
/// A longer program comes from a CAM system, which lifts its tools.
constexpr std::size_t most_blocks = 4000;

struct MoveOfStep {
    Span block;
    bool rapid, feed, to_reference;
    bool aside, in_z; ///< which axes stand in the block
    double z_before, z_after;
    bool changes_tool;
};

MoveOfStep move_of(const Step& step) {
    return {step.block.span,
            step.move == Move::rapid,
            step.move == Move::feed,
            step.to_reference,
            step.axes[0] || step.axes[1],
            step.axes[z_axis],
            step.before.position[z_axis],
            step.after.position[z_axis],
            step.changes_tool};
}

bool moves(const Step& step) { return step.move != Move::none || step.changes_tool; }

class Moves {
  public:
    Moves(const Program& program, const flow::Graph& graph, const States& states,
          const CalledStates& called) {
        for (flow::NodeId node = 0; node < graph.nodes_in_text; ++node) {
            states.for_each_step_of(node, [&](const Step& step) {
                if (moves(step)) moves_.push_back(move_of(step));
            });
            const Slice effects = graph.nodes[node].effects;
            for (EffectId id = effects.first; id < effects.first + effects.count; ++id)
                if (std::holds_alternative<Call>(program.effects[id].what))
                    add_first_of(called(id), program.effects[id].span);
        }
    }

    [[nodiscard]] std::vector<LateLift> late_lifts() const {
        std::vector<LateLift> found;
        bool is_down = false; // the tool has fed down, and was not lifted since
        for (std::size_t i = 0; i + 1 < moves_.size(); ++i) {
            const MoveOfStep& aside = moves_[i];
            const MoveOfStep& lift = moves_[i + 1];
            const bool at_depth = is_down && aside.z_before < 0 && aside.aside && !aside.in_z;
            if (aside.changes_tool || aside.in_z)
                is_down = aside.feed && aside.z_after < aside.z_before && !aside.changes_tool;
            if (!at_depth || lift.aside || !lift.in_z) continue;
            const bool home = aside.to_reference && lift.to_reference;
            const bool goes_up = aside.rapid && lift.rapid && lift.z_after >= 0;
            if (home || (goes_up && i + 2 < moves_.size() && goes_down_there(moves_[i + 2], lift)))
                found.push_back({aside.block, aside.z_before, lift.block});
        }
        return found;
    }

  private:
    static bool goes_down_there(const MoveOfStep& next, const MoveOfStep& lift) {
        return next.in_z && !next.aside && !next.to_reference && next.z_after < lift.z_after;
    }

    /// Its first two moves, as if they stood where it is called.
    void add_first_of(const States* called, Span call) {
        constexpr int wanted = 2;
        int seen = 0;
        if (called == nullptr) return;
        called->for_each_step([&](const Step& step) {
            if (!moves(step) || ++seen > wanted) return;
            moves_.push_back(move_of(step));
            moves_.back().block = call;
        });
    }

    std::vector<MoveOfStep> moves_;
};

} // namespace

std::vector<LateLift> find_late_lifts(const Program& program, const flow::Graph& graph, const States& states,
                                      const CalledStates& called) {
    const MachineWords* machine = program.control->machine_words;
    if (machine == nullptr || machine->tool_word_holds_offset || states.empty() ||
        !states.habits().is_of_interest() || count_blocks(program) > most_blocks)
        return {};
    return Moves(program, graph, states, called).late_lifts();
}

} // namespace maclint::machine
