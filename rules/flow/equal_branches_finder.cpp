//! Follows both sides to where they meet, and compares their text.
#include "rules/flow/equal_branches_finder.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/program/block_view.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace maclint::rules {
namespace {

constexpr int most_nodes = 64; ///< of a branch

/// One side of a decision.
struct Branch {
    std::string text;         ///< of its blocks, without blanks, numbers and what only leads on
    std::string messages;     ///< behind its alarms
    std::string remarks;      ///< in front of its blocks and behind them
    bool only_numbers = true; ///< nothing else is stored or done: somebody edits them
    Span span = {};
    bool acts = false;                   ///< it does more than to leave the program
    std::optional<flow::NodeId> ends_at; ///< the first node that other paths reach; nothing: it leaves
};

bool leads_on(const Effect& effect) {
    return std::holds_alternative<Jump>(effect.what) || std::holds_alternative<RegionMark>(effect.what);
}

bool acts(const Effect& effect) {
    return !leads_on(effect) && !std::holds_alternative<Return>(effect.what) &&
           !std::holds_alternative<Stop>(effect.what);
}

class EqualBranchesIn {
  public:
    explicit EqualBranchesIn(const ProgramAnalysis& analysis)
        : program_(analysis.program())
        , graph_(analysis.graph()) {}

    [[nodiscard]] std::optional<EqualBranches> at(flow::NodeId node) const {
        const auto effect = decision_in(node);
        const auto out = graph_.out[node];
        if (!effect || out.size() != 2) return std::nullopt;
        const flow::Edge& one = graph_.edges[out[0]];
        const flow::Edge& two = graph_.edges[out[1]];
        if (!one.condition || one.condition != two.condition) return std::nullopt;
        const auto if_true = follow(one.holds ? one : two);
        if (!if_true) return std::nullopt;
        const flow::Edge& other = one.holds ? two : one;
        const bool to_next = if_true->ends_at == other.to && if_true->text.empty() &&
                             is_mistaken_jump(*effect, node, other.to);
        if (!if_true->acts && !to_next) return std::nullopt; // as behind most jumps
        const auto if_false = follow(other);
        if (!if_false || if_true->text != if_false->text || if_true->ends_at != if_false->ends_at ||
            if_true->messages != if_false->messages ||
            (if_true->only_numbers && if_true->remarks != if_false->remarks))
            return std::nullopt;
        return EqualBranches{*effect, *one.condition, if_true->span, if_false->span};
    }

  private:
    /// The IF that the node is; nothing for loops and selections.
    [[nodiscard]] std::optional<EffectId> decision_in(flow::NodeId node) const {
        const Slice effects = graph_.nodes[node].effects;
        if (effects.count == 0) return std::nullopt;
        const EffectId last = effects.first + effects.count - 1;
        const auto& what = program_.effects[last].what;
        const auto* mark = std::get_if<RegionMark>(&what);
        const bool decides =
            mark != nullptr ? mark->region_kind == RegionKind::choice : std::holds_alternative<Guarded>(what);
        return decides ? std::optional(last) : std::nullopt;
    }

    /// Whether it jumps to the only block of that number or name.
    [[nodiscard]] bool jumps(EffectId effect) const {
        const auto* guarded = std::get_if<Guarded>(&program_.effects[effect].what);
        const auto* jump = guarded == nullptr || guarded->effects.count != 1
                               ? nullptr
                               : std::get_if<Jump>(&program_.effects[guarded->effects.first].what);
        const auto label = jump == nullptr ? std::nullopt : flow::constant_target(program_, jump->target);
        return label && graph_.with_label(*label).size() == 1;
    }

    /// What stands on the left of a comparison.
    [[nodiscard]] std::string subject_of(ExpressionId condition) const {
        const auto* apply = std::get_if<Apply>(&program_.expressions[condition].node);
        const ExpressionId left = apply == nullptr ? condition : program_.operands_of(*apply).front();
        return without_blanks(program_.slice(program_.expressions[left].span));
    }

    /// Of a jump to the block behind it: nothing else leads there, no table of jumps ends here, and no remark
    /// stands between that keeps the place for something.
    [[nodiscard]] bool is_mistaken_jump(EffectId effect, flow::NodeId node, flow::NodeId next) const {
        const auto before = graph_.in[node];
        const auto asked = graph_.edges[graph_.out[node].front()].condition;
        const bool ends_table = std::ranges::any_of(before, [&](flow::EdgeId id) {
            const auto& condition = graph_.edges[id].condition;
            return condition && asked && subject_of(*condition) == subject_of(*asked);
        });
        const Span between{graph_.nodes[node].part.end, graph_.nodes[next].part.begin};
        return jumps(effect) && !ends_table && graph_.in[next].size() == 2 &&
               program_.slice(between).find_first_not_of(" \t\r\n;") == std::string_view::npos;
    }

    /// Nothing where the side decides in turn, or does not end.
    [[nodiscard]] std::optional<Branch> follow(const flow::Edge& first) const {
        Branch branch;
        flow::NodeId node = first.to;
        for (int i = 0; i < most_nodes; ++i) {
            if (graph_.in[node].size() != 1) {
                branch.ends_at = node;
                return branch;
            }
            add(branch, node);
            const auto out = graph_.out[node];
            if (out.empty()) return branch;
            if (out.size() != 1) return std::nullopt;
            node = graph_.edges[out.front()].to;
        }
        return std::nullopt;
    }

    void add(Branch& branch, flow::NodeId node) const {
        const flow::Node& at = graph_.nodes[node];
        if (at.is_run) {
            branch.acts = true;
            const std::size_t before = branch.text.size();
            for_each_block(program_, at.stretch(), [&](const BlockView& block) {
                add(branch,
                    {block.number_span.empty() ? block.span.begin : block.number_span.end, block.span.end});
            });
            branch.only_numbers &= branch.text.size() == before;
            return;
        }
        add_remarks(branch, node);
        const auto block = stored_block(program_, at.item);
        const auto effects = program_.effects_in(at.effects);
        const bool has_words = block && at.effects.first == block->effects.first && !block->words.empty();
        branch.acts |= std::ranges::any_of(effects, acts) || (has_words && effects.empty());
        branch.only_numbers &= !has_words && std::ranges::all_of(effects, [&](const Effect& effect) {
            return leads_on(effect) || stores_number(effect);
        });
        if (has_words)
            for (const Word& word : block->words) add(branch, word.span);
        for (const Effect& effect : effects)
            if (!leads_on(effect)) add(branch, effect.span);
    }

    [[nodiscard]] bool stores_number(const Effect& effect) const {
        const auto* assign = std::get_if<Assign>(&effect.what);
        return assign != nullptr && std::holds_alternative<Literal>(program_.expressions[assign->value].node);
    }

    /// Two alarms of one number may say different things, and numbers to edit stand for what remarks name.
    void add_remarks(Branch& branch, flow::NodeId node) const {
        const flow::Node& at = graph_.nodes[node];
        const Span before{node == 0 ? at.part.begin : graph_.nodes[node - 1].part.end, at.part.begin};
        if (before.begin < before.end) branch.remarks += without_blanks(program_.slice(before));
        if (at.effects.count == 0) return;
        const Effect& last = program_.effects[at.effects.first + at.effects.count - 1];
        if (last.span.end >= at.part.end) return;
        const std::string behind = without_blanks(program_.slice({last.span.end, at.part.end}));
        (std::holds_alternative<Stop>(last.what) ? branch.messages : branch.remarks) += behind;
    }

    void add(Branch& branch, Span part) const {
        const std::string text = without_blanks(program_.slice(part));
        if (text.empty()) return; // of a block that is only a number
        branch.text += text + '\n';
        if (branch.span.empty()) branch.span = part;
        branch.span.end = std::max(branch.span.end, part.end);
    }

    const Program& program_;
    const flow::Graph& graph_;
};

} // namespace

std::vector<EqualBranches> find_equal_branches(const ProgramAnalysis& analysis) {
    std::vector<EqualBranches> found;
    const EqualBranchesIn search(analysis);
    for (const flow::NodeId node : analysis.graph().with_effects)
        if (analysis.data().reached(node))
            if (const auto equal = search.at(node)) found.push_back(*equal);
    return found;
}

} // namespace maclint::rules
