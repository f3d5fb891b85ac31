//! Sorts the comparisons of positions by whether they have a tolerance.
#include "rules/numbers/missing_tolerance_finder.hpp"

#include "analyzer/dataflow/domain/read_set.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/semantics/concrete.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

namespace maclint::rules {
namespace {

/// A tolerance is some thousandths, in either unit: positions have three decimals in millimetres and four in
/// inches, and rounding changes the last. Hundredths of an inch are a way to go.
constexpr double below = 0.01;
constexpr int most_tests = 8; ///< between a move and a comparison

struct Compared {
    const dataflow::Comparison* comparison;
    const VariableRange* positions;
    std::optional<ExpressionId> tolerance;
};

class MissingTolerances {
  public:
    explicit MissingTolerances(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , program_(analysis.program())
        , graph_(analysis.graph()) {}

    /// Nothing unless one side is a position, the other one calculated, and both are compared after a move.
    [[nodiscard]] std::optional<Compared> look_at(const dataflow::Comparison& comparison) const {
        if (!semantics::is_order(comparison.operation)) return std::nullopt;
        const VariableRange* left = positions_of(comparison.left_expression);
        const VariableRange* right = positions_of(comparison.right_expression);
        if ((left == nullptr) == (right == nullptr)) return std::nullopt;
        const ExpressionId target =
            left != nullptr ? comparison.right_expression : comparison.left_expression;
        const auto read = dataflow::variables_of(program_, target);
        const bool number = read.closed && read.variables.empty();
        if (number || !follows_move(comparison.node)) return std::nullopt;
        return Compared{&comparison, left != nullptr ? left : right, tolerance_in(target)};
    }

  private:
    [[nodiscard]] const VariableRange* positions_of(ExpressionId id) const {
        const auto* machine = std::get_if<LoadMachine>(&program_.expressions[id].node);
        if (machine == nullptr) return nullptr;
        const VariableRange* range = analysis_.control().families[machine->family].find(machine->number);
        const bool measured = range != nullptr && range->changes_by_itself && !range->is_bit &&
                              range->on_write == OnWrite::forbidden;
        return measured ? range : nullptr;
    }

    /// The small number that is added to the rest, or taken from it.
    [[nodiscard]] std::optional<ExpressionId> tolerance_in(ExpressionId id) const {
        const auto& node = program_.expressions[id].node;
        if (const auto* literal = std::get_if<Literal>(&node)) {
            const double size = std::abs(literal->value);
            return size > 0 && size < below ? std::optional(id) : std::nullopt;
        }
        const auto* apply = std::get_if<Apply>(&node);
        if (apply == nullptr ||
            (apply->operation != Operation::add && apply->operation != Operation::subtract))
            return std::nullopt;
        for (const ExpressionId operand : program_.operands_of(*apply))
            if (const auto tolerance = tolerance_in(operand)) return tolerance;
        return std::nullopt;
    }

    /// Whether nothing but other tests stands between a block that moves and the node.
    [[nodiscard]] bool follows_move(flow::NodeId node) const {
        for (int i = 0; i < most_tests; ++i) {
            const auto in = graph_.in[node];
            if (in.size() != 1) return false;
            const flow::Edge& edge = graph_.edges[in.front()];
            if (edge.kind != flow::EdgeKind::next && !edge.condition) return false;
            node = edge.from;
            const flow::Node& before = graph_.nodes[node];
            if (before.is_run) return moves(program_, before.stretch());
            const auto effects = program_.effects_in(before.effects);
            if (std::ranges::any_of(effects, [](const Effect& effect) {
                    return std::holds_alternative<Motion>(effect.what);
                }))
                return true;
            if (!std::ranges::all_of(effects, [](const Effect& effect) {
                    return std::holds_alternative<Guarded>(effect.what);
                }))
                return false;
        }
        return false;
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    const flow::Graph& graph_;
};

} // namespace

std::vector<MissingTolerance> find_missing_tolerances(const ProgramAnalysis& analysis) {
    const MissingTolerances search(analysis);
    std::vector<Compared> all;
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>())
        if (const auto compared = search.look_at(comparison)) all.push_back(*compared);
    std::map<const VariableRange*, const Compared*> tolerant; // the first of each kind of position
    for (const Compared& compared : all)
        if (compared.tolerance) tolerant.try_emplace(compared.positions, &compared);
    std::vector<MissingTolerance> missing;
    for (const Compared& exact : all) {
        if (exact.tolerance) continue;
        if (const auto other = tolerant.find(exact.positions); other != tolerant.end())
            missing.push_back({exact.comparison, other->second->comparison, *other->second->tolerance});
    }
    return missing;
}

} // namespace maclint::rules
