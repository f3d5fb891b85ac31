//! Gathers rows of tests, and looks at how the blocks before each label end.
#include "rules/flow/branch_falls_through_finder.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/queries/conditions/conditions.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string>

namespace maclint::rules {
namespace {

constexpr int most_nodes = 500;             ///< of the last branch of a table, and of one of twins
constexpr flow::NodeId nodes_of_a_test = 2; ///< the test and its jump

/// A test of a table: where it jumps, and what it asks.
struct Test {
    flow::NodeId node;
    flow::NodeId target;
    EffectId jump;
    ExpressionId asked; ///< what is compared with a number
};

/// How a branch ends: by a jump to a node, or with the program.
struct Leaving {
    std::optional<flow::NodeId> to; ///< nothing: the program ends or returns
    Span by;
    [[nodiscard]] bool leads_where(const Leaving& other) const { return to == other.to; }
};

/// The text without what stands in ( ).
std::string without_remarks(std::string_view text) {
    std::string rest;
    int depth = 0;
    for (const char c : text) {
        if (c == '(') ++depth;
        if (depth == 0) rest += c;
        if (c == ')' && depth > 0) --depth;
    }
    return rest;
}

class Tables {
  public:
    explicit Tables(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , program_(analysis.program())
        , graph_(analysis.graph()) {}

    [[nodiscard]] std::vector<FallingBranch> find() const {
        std::vector<FallingBranch> found;
        std::vector<Test> table;
        for (flow::NodeId node = 0; node < graph_.nodes_in_text; ++node) {
            if (!table.empty() && node < table.back().node + nodes_of_a_test) continue; // its jump
            const auto test = test_at(node);
            const bool goes_on = test && !table.empty() && table.back().node + nodes_of_a_test == node &&
                                 queries::same_expression(program_, test->asked, table.back().asked);
            if (!goes_on) {
                if (const auto falling = falling_branch(table)) found.push_back(*falling);
                table.clear();
            }
            if (test) table.push_back(*test);
        }
        if (const auto falling = falling_branch(table)) found.push_back(*falling);
        find_by_number(found);
        find_twins(found);
        return found;
    }

  private:
    /// What the condition compares with a number by EQ, and is none.
    [[nodiscard]] std::optional<ExpressionId> asked_in(ExpressionId condition) const {
        const auto* apply = std::get_if<Apply>(&program_.expressions[condition].node);
        if (apply == nullptr || apply->operation != Operation::equal) return std::nullopt;
        const auto operands = program_.operands_of(*apply);
        const auto is_number = [&](ExpressionId id) {
            return std::holds_alternative<Literal>(program_.expressions[id].node);
        };
        if (is_number(operands.front()) == is_number(operands.back())) return std::nullopt;
        return is_number(operands.front()) ? operands.back() : operands.front();
    }

    [[nodiscard]] std::optional<Test> test_at(flow::NodeId node) const {
        for (const flow::EdgeId id : graph_.out[node]) {
            const flow::Edge& edge = graph_.edges[id];
            if (!edge.condition || !edge.holds) continue;
            const auto asked = asked_in(*edge.condition);
            const flow::Edge* jump = only_jump_at(edge.to);
            if (asked && jump != nullptr) return Test{node, jump->to, *jump->jump, *asked};
        }
        return std::nullopt;
    }

    /// The jump that is all that leads on from the node; nullptr where it is not.
    [[nodiscard]] const flow::Edge* only_jump_at(flow::NodeId node) const {
        const auto out = graph_.out[node];
        if (out.size() != 1) return nullptr;
        const flow::Edge& edge = graph_.edges[out.front()];
        return edge.kind == flow::EdgeKind::jump && edge.jump ? &edge : nullptr;
    }

    /// How the program leaves at the node, whatever is true there; nothing where it goes on.
    [[nodiscard]] std::optional<Leaving> leaving_at(flow::NodeId node) const {
        for (const flow::Exit& exit : graph_.exits_at(node))
            if (exit.kind != flow::ExitKind::alarm && exit.effect && graph_.out[node].empty())
                return Leaving{std::nullopt, program_.effects[*exit.effect].span};
        const flow::Edge* jump = only_jump_at(node);
        if (jump == nullptr) return std::nullopt;
        return Leaving{jump->to, program_.effects[*jump->jump].span};
    }

    /// Whether one of the blocks from `begin` on goes on to the node, which stands behind them.
    [[nodiscard]] bool is_run_into(flow::NodeId node, flow::NodeId begin) const {
        return std::ranges::any_of(graph_.in[node], [&](flow::EdgeId id) {
            const flow::Edge& edge = graph_.edges[id];
            return begin <= edge.from && edge.from < node && edge.kind != flow::EdgeKind::jump &&
                   edge.kind != flow::EdgeKind::computed && graph_.order[edge.from] != flow::Graph::no_order;
        });
    }

    [[nodiscard]] std::optional<FallingBranch> falling_branch(std::span<const Test> table) const {
        constexpr std::size_t fewest = 3;
        if (table.size() < fewest) return std::nullopt;
        std::vector<Test> branches(table.begin(), table.end());
        std::ranges::sort(branches, {}, &Test::target);
        const auto same = std::ranges::adjacent_find(branches, {}, &Test::target);
        if (same != branches.end() || branches.front().target <= table.back().node) return std::nullopt;
        std::optional<std::size_t> falling;
        std::vector<Leaving> leaving;
        for (std::size_t i = 0; i < branches.size(); ++i) {
            const bool last = i + 1 == branches.size();
            if (!last && is_empty(branches[i].target, branches[i + 1].target))
                continue; // one branch for both
            if (!last && is_run_into(branches[i + 1].target, branches[i].target)) {
                if (falling) return std::nullopt; // it is how this table works
                falling = i;
            } else if (const auto how = last ? leaving_from(branches[i].target, leaving)
                                             : leaving_at(branches[i + 1].target - 1)) {
                leaving.push_back(*how);
            }
        }
        if (!falling) return std::nullopt;
        const auto twice = std::ranges::find_if(leaving, [&](const Leaving& one) {
            return std::ranges::count_if(leaving, [&](const Leaving& o) { return o.leads_where(one); }) > 1;
        });
        if (twice == leaving.end()) return std::nullopt;
        return FallingBranch{branches[*falling].jump, graph_.nodes[branches[*falling].target].part,
                             graph_.nodes[branches[*falling + 1].target].part, twice->by};
    }

    /// GOTO[#1*100]: the blocks that it may lead to, but for those to which others jump as well.
    void find_by_number(std::vector<FallingBranch>& found) const {
        for (const flow::ResolvedJump& jump : graph_.jumps) {
            if (jump.target || jump.label) continue;
            std::vector<Test> table;
            for (const flow::LabelledBlock& block : analysis_.targets_of(jump))
                if (block.node > jump.node && !is_jumped_to(block.node))
                    table.push_back({jump.node, block.node, jump.jump, {}});
            if (const auto falling = falling_branch(table)) found.push_back(*falling);
        }
    }

    [[nodiscard]] bool is_jumped_to(flow::NodeId node) const {
        return std::ranges::any_of(
            graph_.in[node], [&](flow::EdgeId id) { return graph_.edges[id].kind == flow::EdgeKind::jump; });
    }

    /// A test of whatever, and its jump.
    [[nodiscard]] std::optional<Test> any_test_at(flow::NodeId node) const {
        if (node >= graph_.nodes_in_text) return std::nullopt;
        for (const flow::EdgeId id : graph_.out[node]) {
            const flow::Edge& edge = graph_.edges[id];
            const flow::Edge* jump = edge.condition && edge.holds ? only_jump_at(edge.to) : nullptr;
            if (jump != nullptr) return Test{node, jump->to, *jump->jump, *edge.condition};
        }
        return std::nullopt;
    }

    /// What stands there, with its numbers and blanks left out: "N#=#+GOTO".
    [[nodiscard]] std::string shape_between(flow::NodeId begin, flow::NodeId end) const {
        std::string shape = without_blanks(
            without_remarks(program_.slice({graph_.nodes[begin].part.begin, graph_.nodes[end].part.begin})));
        std::erase_if(shape, [](char c) { return is_digit(c) || c == '.' || c == '-' || c == '\n'; });
        return shape;
    }

    /// Two tests alone in a row whose branches are one block after the other alike, and only the second
    /// leaves.
    void find_twins(std::vector<FallingBranch>& found) const {
        for (flow::NodeId node = 0; node < graph_.nodes_in_text; ++node) {
            const auto first = any_test_at(node);
            const auto second = first ? any_test_at(node + nodes_of_a_test) : std::nullopt;
            if (!second) continue;
            const bool alone = !any_test_at(node + 2 * nodes_of_a_test) &&
                               (node < nodes_of_a_test || !any_test_at(node - nodes_of_a_test));
            if (const auto twin = alone ? falling_twin(*first, *second) : std::nullopt)
                found.push_back(*twin);
        }
    }

    /// Whether both ask one variable for numbers, and any other number is an alarm.
    [[nodiscard]] bool are_all_cases(const Test& first, const Test& second) const {
        const auto a = asked_in(first.asked), b = asked_in(second.asked);
        if (!a || !b || !queries::same_expression(program_, *a, *b)) return false;
        flow::NodeId other = second.node + nodes_of_a_test;
        if (const flow::Edge* jump = only_jump_at(other)) other = jump->to;
        return std::ranges::any_of(graph_.exits_at(other),
                                   [](const flow::Exit& exit) { return exit.kind == flow::ExitKind::alarm; });
    }

    [[nodiscard]] std::optional<FallingBranch> falling_twin(const Test& first, const Test& second) const {
        if (first.target <= second.node || second.target <= first.target ||
            second.target - first.target > most_nodes || !is_run_into(second.target, first.target))
            return std::nullopt;
        const flow::NodeId end = std::min<flow::NodeId>(graph_.nodes_in_text, second.target + most_nodes);
        for (flow::NodeId node = second.target; node < end; ++node) {
            const bool is_of_a_test = node > second.target && any_test_at(node - 1);
            const auto how = is_of_a_test ? std::nullopt : leaving_at(node);
            if (!how) continue;
            const std::string shape = shape_between(first.target, second.target);
            const bool does_something = shape.find('=') != std::string::npos || are_all_cases(first, second);
            if (!does_something || shape != shape_between(second.target, node)) return std::nullopt;
            return FallingBranch{first.jump, graph_.nodes[first.target].part,
                                 graph_.nodes[second.target].part, how->by};
        }
        return std::nullopt;
    }

    /// Whether nothing but labels stands there.
    [[nodiscard]] bool is_empty(flow::NodeId begin, flow::NodeId end) const {
        bool empty = true;
        for (flow::NodeId node = begin; node < end; ++node) {
            empty &= graph_.nodes[node].effects.count == 0;
            for_each_block_with_words(
                program_, graph_.nodes[node].stretch(),
                [&](const BlockView&, std::span<const Word> words) { empty &= words.empty(); });
        }
        return empty;
    }

    /// How the last branch leaves: the way that another one does, or by running into its end.
    [[nodiscard]] std::optional<Leaving> leaving_from(flow::NodeId begin,
                                                      std::span<const Leaving> others) const {
        for (const Leaving& other : others)
            if (other.to && *other.to > begin && is_run_into(*other.to, begin)) return other;
        const flow::NodeId end = std::min<flow::NodeId>(graph_.nodes_in_text, begin + most_nodes);
        for (flow::NodeId node = begin; node < end; ++node)
            if (const auto how = leaving_at(node);
                how && std::ranges::any_of(others, [&](const Leaving& o) { return o.leads_where(*how); }))
                return how;
        return std::nullopt;
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    const flow::Graph& graph_;
};

} // namespace

std::vector<FallingBranch> find_falling_branches(const ProgramAnalysis& analysis) {
    return Tables(analysis).find();
}

} // namespace maclint::rules
