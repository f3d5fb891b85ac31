//! Looks at what makes offsets, for the positions in it, and from there back to the move.
#include "rules/timing/skip_not_checked_finder.hpp"

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/machine/changing_values.hpp"
#include "analyzer/queries/machine/skip_moves.hpp"
#include "analyzer/queries/machine/unfinished_moves.hpp"
#include "analyzer/queries/values/offsets.hpp"

#include <algorithm>
#include <map>
#include <optional>

namespace maclint::rules {
namespace {

using queries::Positions;
using queries::positions_in;

class TouchesOfProgram {
  public:
    explicit TouchesOfProgram(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , program_(analysis.program())
        , graph_(analysis.graph())
        , letters_(*analysis.control().machine_words) {}

    [[nodiscard]] std::vector<UncheckedTouch> find() {
        for (EffectId id = 0; id < program_.effects.size(); ++id) {
            const Effect& effect = program_.effects[id];
            const auto* assign = std::get_if<Assign>(&effect.what);
            if (assign != nullptr && queries::makes_offset(analysis_, *assign)) look_at(id, assign->value);
            const auto* words = std::get_if<EvaluateWords>(&effect.what);
            if (words == nullptr) continue;
            const auto node = graph_.node_of(id);
            if (!node || !queries::block_with_code(analysis_, *node, letters_.settings)) continue;
            for (const ExpressionId value : program_.values_of(*words)) look_at(id, value);
        }
        std::vector<UncheckedTouch> found;
        if (found_.empty() || compares_what_changes()) return found;
        for (const auto& [move, touch] : found_) found.push_back(touch);
        return found;
    }

  private:
    /// Whether what stands in the node may have asked for the signal, or is not known. Conditions do not: see
    /// compares_what_changes.
    [[nodiscard]] bool may_ask(flow::NodeId node) const {
        if (std::ranges::any_of(program_.effects_in(graph_.nodes[node].effects), [](const Effect& effect) {
                return std::holds_alternative<Call>(effect.what) ||
                       std::holds_alternative<UnreadableBlock>(effect.what) ||
                       std::holds_alternative<Stop>(effect.what);
            }))
            return true;
        bool switches = false;
        for_each_block_with_words(program_, graph_.nodes[node].stretch(),
                                  [&](const BlockView&, std::span<const Word> words) {
                                      switches |= std::ranges::any_of(words, [&](const Word& word) {
                                          return word.address == analysis_.control().functions.address;
                                      });
                                  });
        return switches;
    }

    /// The nearest move that a signal ends, where the node stands behind one on every path and nothing
    /// between asks, or moves where that matters.
    [[nodiscard]] std::optional<flow::NodeId> touch_before(flow::NodeId node, bool may_move) const {
        std::optional<flow::NodeId> found;
        bool open = node == 0;
        flow::walk<flow::Direction::backward>(graph_, {node}, [&](flow::EdgeId edge, flow::NodeId from) {
            if (open || !analysis_.data().passable(edge) || !analysis_.data().reached(from))
                return flow::Step::refuse;
            if (queries::block_with_code(analysis_, from, letters_.skips)) {
                if (!found) found = from;
                return flow::Step::end;
            }
            open |= from == 0 || may_ask(from) || (!may_move && queries::has_move(analysis_, from));
            return open ? flow::Step::end : flow::Step::go_on;
        });
        return open ? std::nullopt : found;
    }

    void look_at(EffectId use, ExpressionId value) {
        const auto node = graph_.node_of(use);
        if (!node) return;
        for (const queries::PositionRead& read :
             positions_in(analysis_, use, value, Positions::when_touched)) {
            const auto move = touch_before(*node, true);
            if (!move || touch_before(read.node, read.is_kept) != move) continue;
            const auto span = queries::block_with_code(analysis_, *move, letters_.skips);
            found_.try_emplace(
                *move, UncheckedTouch{*move, *span, use, *node, program_.expressions[read.expression].span});
        }
    }

    /// Whether a comparison depends on a position, an input or the like.
    [[nodiscard]] bool compares_what_changes() const {
        const auto& comparisons = analysis_.facts().all<dataflow::Comparison>();
        return std::ranges::any_of(comparisons, [&](const dataflow::Comparison& comparison) {
            return queries::reads_what_changes(analysis_, comparison.expression) ||
                   !positions_in(analysis_, comparison.effect, comparison.expression, Positions::compared)
                        .empty();
        });
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    const flow::Graph& graph_;
    const MachineWords& letters_;
    std::map<flow::NodeId, UncheckedTouch> found_;
};

} // namespace

std::vector<UncheckedTouch> find_unchecked_touches(const ProgramAnalysis& analysis) {
    if (analysis.control().machine_words == nullptr) return {};
    return TouchesOfProgram(analysis).find();
}

} // namespace maclint::rules
