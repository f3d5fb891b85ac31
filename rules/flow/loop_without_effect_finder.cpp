//! Asks what is still read where a loop is left.
#include "rules/flow/loop_without_effect_finder.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/queries/loops/loop_exits.hpp"

#include <algorithm>
#include <span>
#include <variant>

namespace maclint::rules {
namespace {

class EffectOfLoop {
  public:
    EffectOfLoop(const ProgramAnalysis& analysis, const dataflow::Loop& loop)
        : analysis_(analysis)
        , program_(analysis.program())
        , loop_(loop) {}

    [[nodiscard]] std::optional<LoopWithoutEffect> none() {
        if (loop_.has_unknown_effects || loop_.can_stop || loop_.exit_edges.empty() || !only_stores())
            return std::nullopt;
        const auto counted = counted_variable();
        if (!counted || !asks_for_itself_only() || is_read_behind()) return std::nullopt;
        return LoopWithoutEffect{&loop_, *counted, store_behind(*counted)};
    }

  private:
    /// Whether its blocks store in plain variables and jump, and do nothing else.
    [[nodiscard]] bool only_stores() {
        const auto does_no_more = [&](const Effect& effect) {
            const auto* assign = std::get_if<Assign>(&effect.what);
            const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
            if (target != nullptr) stored_.push_back(*target);
            return target != nullptr || std::holds_alternative<Jump>(effect.what) ||
                   std::holds_alternative<Guarded>(effect.what) ||
                   std::holds_alternative<RegionMark>(effect.what);
        };
        return std::ranges::all_of(loop_.body, [&](flow::NodeId id) {
            const flow::Node& node = analysis_.graph().nodes[id];
            bool has_words = node.is_run;
            for_each_block_with_words(
                program_, node.stretch(),
                [&](const BlockView&, std::span<const Word> words) { has_words |= !words.empty(); });
            return !has_words && std::ranges::all_of(program_.effects_in(node.effects), does_no_more);
        });
    }

    /// The first of them that a condition which leads out asks for.
    [[nodiscard]] std::optional<Variable> counted_variable() const {
        for (const flow::EdgeId id : loop_.exit_edges) {
            const auto& condition = analysis_.graph().edges[id].condition;
            if (!condition) return std::nullopt;
            const auto asked = dataflow::variables_of(program_, *condition).variables;
            for (const Variable variable : stored_)
                if (std::ranges::find(asked, variable) != asked.end()) return variable;
        }
        return std::nullopt;
    }

    /// Whether nothing of the machine decides when it ends, and more than numbers do.
    [[nodiscard]] bool asks_for_itself_only() const {
        bool by_numbers = true;
        for (const flow::EdgeId id : loop_.exit_edges) {
            const auto& condition = analysis_.graph().edges[id].condition;
            const dataflow::ReadSet asked = dataflow::variables_of(program_, *condition);
            if (!asked.closed) return false;
            by_numbers &= std::ranges::all_of(asked.variables, [&](Variable variable) {
                return std::ranges::find(stored_, variable) != stored_.end();
            });
        }
        return !by_numbers || !exemptions::counts_to_a_number.is_on();
    }

    [[nodiscard]] bool is_read_behind() const {
        if (!analysis_.liveness().is_known()) return true;
        return std::ranges::any_of(loop_.exit_edges, [&](flow::EdgeId id) {
            if (!analysis_.data().passable(id)) return false;
            const auto live = analysis_.liveness().live_before(analysis_.graph().edges[id].to);
            return std::ranges::any_of(stored_, [&](Variable variable) {
                return std::ranges::find(live, program_.meant_by(variable)) != live.end();
            });
        });
    }

    [[nodiscard]] std::optional<EffectId> store_behind(Variable variable) const {
        for (const flow::EdgeId id : loop_.exit_edges) {
            const Slice effects = analysis_.graph().nodes[analysis_.graph().edges[id].to].effects;
            for (EffectId effect = effects.first; effect < effects.first + effects.count; ++effect) {
                const auto* assign = std::get_if<Assign>(&program_.effects[effect].what);
                const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
                if (target != nullptr && *target == variable) return effect;
            }
        }
        return std::nullopt;
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    const dataflow::Loop& loop_;
    std::vector<Variable> stored_;
};

} // namespace

std::vector<LoopWithoutEffect> find_loops_without_effect(const ProgramAnalysis& analysis) {
    std::vector<LoopWithoutEffect> found;
    for (const dataflow::Loop& loop : analysis.loops()) {
        if (!Budget::allows()) break;
        if (const auto none = EffectOfLoop(analysis, loop).none()) found.push_back(*none);
    }
    return found;
}

} // namespace maclint::rules
