//! Looks between each move that a signal ends and the next move.
#include "rules/timing/skip_not_checked_twins_finder.hpp"

#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/machine/skip_moves.hpp"
#include "analyzer/queries/values/positions.hpp"
#include "analyzer/queries/values/stored_positions.hpp"

#include <algorithm>
#include <set>
#include <variant>

namespace maclint::rules {
namespace {

using queries::StoredPosition;

class Touches {
  public:
    explicit Touches(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , program_(analysis.program())
        , positions_(analysis) {
        for (const flow::Edge& edge : analysis.graph().edges)
            if (edge.condition) look_at(edge);
    }

    [[nodiscard]] std::vector<UncheckedTwin> find() const {
        std::vector<UncheckedTwin> found;
        for (ExpressionId id = 0; id < program_.expressions.size(); ++id) {
            const auto* both = std::get_if<Apply>(&program_.expressions[id].node);
            if (both == nullptr || program_.operands_of(*both).size() != 2) continue;
            const auto operands = program_.operands_of(*both);
            const StoredPosition* a = touch(operands[0]);
            const StoredPosition* b = touch(operands[1]);
            if (a == nullptr || b == nullptr || a->axis != b->axis || is_checked(*a) == is_checked(*b))
                continue;
            const StoredPosition& unchecked = is_checked(*a) ? *b : *a;
            const bool is_told =
                std::ranges::find(found, unchecked.effect, &UncheckedTwin::store) != found.end();
            const auto span = queries::block_with_code(analysis_, *unchecked.ended_by_signal,
                                                       analysis_.control().machine_words->skips);
            if (!is_told && span && !asked_.contains(unchecked.effect))
                found.push_back({*unchecked.ended_by_signal, *span, unchecked.effect,
                                 (is_checked(*a) ? *a : *b).effect, id});
        }
        return found;
    }

  private:
    [[nodiscard]] const StoredPosition* touch(ExpressionId id) const {
        const StoredPosition* position = positions_.in(id);
        return position != nullptr && position->range->is_skip_position && position->ended_by_signal
                   ? position
                   : nullptr;
    }

    [[nodiscard]] bool is_checked(const StoredPosition& touch) const {
        return checked_.contains(*touch.ended_by_signal);
    }

    /// Notes the touch behind which the condition asks for a position, and those that it asks for by name.
    void look_at(const flow::Edge& edge) {
        bool asks = false;
        visit(*edge.condition, [&](ExpressionId id) {
            asks |= queries::position_read(program_, id) != nullptr;
            if (const StoredPosition* position = positions_.in(id)) {
                asked_.insert(position->effect);
                asks = true;
            }
        });
        if (!asks) return;
        for (flow::NodeId node = edge.from + 1; node-- > 0;) {
            if (!queries::has_move(analysis_, node)) continue;
            if (queries::block_with_code(analysis_, node, analysis_.control().machine_words->skips))
                checked_.insert(node);
            return;
        }
    }

    template<class Visit>
    void visit(ExpressionId id, const Visit& see) const {
        see(id);
        if (const auto* apply = std::get_if<Apply>(&program_.expressions[id].node))
            for (const ExpressionId operand : program_.operands_of(*apply)) visit(operand, see);
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    queries::StoredPositions positions_;
    std::set<flow::NodeId> checked_; ///< moves
    std::set<EffectId> asked_;       ///< stores
};

} // namespace

std::vector<UncheckedTwin> find_unchecked_twins(const ProgramAnalysis& analysis) {
    if (analysis.control().machine_words == nullptr || !queries::reads_positions(analysis.program()))
        return {};
    return Touches(analysis).find();
}

} // namespace maclint::rules
