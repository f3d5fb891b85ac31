//! Goes back from each statement with a number of a work offset to the test that leads there.
#include "rules/variables/crossed_axes_cases_finder.hpp"

#include "analyzer/program/tables.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <variant>

namespace maclint::rules {
namespace {

/// A number of a work offset.
struct OffsetNumber {
    ExpressionId operand;
    const VariableRange* range;
    std::int32_t number;

    [[nodiscard]] double code() const { return range->code(number); }
    [[nodiscard]] Variable of_code(double other) const {
        const auto sets = static_cast<std::int32_t>(std::lround(other - code()));
        return {range->space, number + sets * range->numbers_of_a_set};
    }
};

/// A statement that takes numbers of one work offset in a case for one.
struct Use {
    flow::NodeId node;
    EffectId effect;
    OffsetNumber offset;
    double asked;

    [[nodiscard]] bool is_own() const { return offset.code() == asked; }
};

class Cases {
  public:
    explicit Cases(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , program_(analysis.program())
        , group_(analysis.control().group_with(ModalRole::work_offset)) {}

    [[nodiscard]] std::vector<Use> uses() const {
        std::vector<Use> found;
        if (!group_ || !reads_an_offset()) return found;
        const flow::Graph& graph = analysis_.graph();
        for (const flow::NodeId node : graph.with_effects) {
            const Slice effects = graph.nodes[node].effects;
            for (EffectId id = effects.first; id < effects.first + effects.count; ++id) {
                const auto offset = offset_in(id);
                if (!offset || !Budget::allows()) continue;
                const auto asked = asked_before(node);
                if (asked) found.push_back({node, id, *offset, *asked});
            }
        }
        return found;
    }

  private:
    [[nodiscard]] bool reads_an_offset() const {
        return std::ranges::any_of(program_.expressions, [&](const Expression& expression) {
            const auto* load = std::get_if<LoadMachine>(&expression.node);
            return load != nullptr && offset(0, load->family, load->number);
        });
    }

    [[nodiscard]] std::optional<OffsetNumber> offset(ExpressionId operand, FamilyId family,
                                                     std::int32_t number) const {
        const VariableRange* range = analysis_.control().families[family].find(number);
        if (range == nullptr || !range->first_code) return std::nullopt;
        return OffsetNumber{operand, range, number};
    }

    void add_offsets(ExpressionId id, std::vector<OffsetNumber>& found) const {
        const auto& node = program_.expressions[id].node;
        if (const auto* load = std::get_if<LoadMachine>(&node)) {
            if (const auto number = offset(id, load->family, load->number)) found.push_back(*number);
        } else if (const auto* apply = std::get_if<Apply>(&node)) {
            for (const ExpressionId operand : program_.operands_of(*apply)) add_offsets(operand, found);
        }
    }

    /// The only offset of which the statement takes numbers, or sets any.
    [[nodiscard]] std::optional<OffsetNumber> offset_in(EffectId id) const {
        std::vector<OffsetNumber> found;
        std::optional<double> set;
        if (const auto* assign = std::get_if<Assign>(&program_.effects[id].what)) {
            add_offsets(assign->value, found);
            const auto* target = std::get_if<StoreMachine>(&assign->target);
            const auto number = target == nullptr ? std::nullopt : offset(0, target->family, target->number);
            if (number) set = number->code();
        } else if (const auto* values = std::get_if<EvaluateWords>(&program_.effects[id].what)) {
            for (const ExpressionId value : program_.values_of(*values)) add_offsets(value, found);
        }
        const bool is_one = !found.empty() && std::ranges::all_of(found, [&](const OffsetNumber& offset) {
            return offset.code() == found.front().code() && (!set || offset.code() == *set);
        });
        return is_one ? std::optional(found.front()) : std::nullopt;
    }

    /// Of a number whose group is not known the code tells that it is that of work offsets.
    [[nodiscard]] bool is_read_of_group(const decltype(Expression::node)& node) const {
        if (const auto* modal = std::get_if<LoadModal>(&node)) return modal->group == *group_;
        const auto* machine = std::get_if<LoadMachine>(&node);
        const VariableRange* range =
            machine == nullptr ? nullptr
                               : analysis_.control().families[machine->family].find(machine->number);
        return range != nullptr && range->is_code;
    }

    [[nodiscard]] bool is_code_in_force(ExpressionId id) const {
        const auto& node = program_.expressions[id].node;
        if (is_read_of_group(node)) return true;
        const auto* load = std::get_if<Load>(&node);
        if (load == nullptr) return false;
        bool is_copied = false;
        for (const Effect& effect : program_.effects) {
            const auto* assign = std::get_if<Assign>(&effect.what);
            const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
            if (target == nullptr || *target != load->variable) continue;
            if (!is_read_of_group(program_.expressions[assign->value].node)) return false;
            is_copied = true;
        }
        return is_copied;
    }

    /// The code that is in force where the condition turns out so.
    [[nodiscard]] std::optional<double> asked_by(ExpressionId condition, bool holds) const {
        const auto* apply = std::get_if<Apply>(&program_.expressions[condition].node);
        if (apply == nullptr || apply->operation != (holds ? Operation::equal : Operation::not_equal))
            return std::nullopt;
        const auto operands = program_.operands_of(*apply);
        const auto* literal = std::get_if<Literal>(&program_.expressions[operands[1]].node);
        return literal != nullptr && is_code_in_force(operands[0]) ? std::optional(literal->value)
                                                                   : std::nullopt;
    }

    /// What the nearest test asks for that every path to the node comes from.
    [[nodiscard]] std::optional<double> asked_before(flow::NodeId node) const {
        constexpr int most_nodes = 64;
        const flow::Graph& graph = analysis_.graph();
        for (int i = 0; i < most_nodes && graph.in[node].size() == 1; ++i) {
            const flow::Edge& edge = graph.edges[graph.in[node].front()];
            if (const auto asked = edge.condition ? asked_by(*edge.condition, edge.holds) : std::nullopt)
                return asked;
            node = edge.from;
        }
        return std::nullopt;
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    std::optional<GroupId> group_;
};

} // namespace

std::vector<OffsetOfAnotherCase> find_offsets_of_other_cases(const ProgramAnalysis& analysis) {
    const std::vector<Use> uses = Cases(analysis).uses();
    std::vector<OffsetOfAnotherCase> found;
    const auto own = std::ranges::find_if(uses, &Use::is_own);
    const auto all_own = static_cast<std::size_t>(std::ranges::count_if(uses, &Use::is_own));
    if (own == uses.end() || uses.size() - all_own >= all_own) return found;
    for (const Use& use : uses)
        if (!use.is_own())
            found.push_back({use.node, use.effect, use.offset.operand, use.offset.of_code(use.asked),
                             use.asked, use.offset.code(), own->effect});
    return found;
}

} // namespace maclint::rules
