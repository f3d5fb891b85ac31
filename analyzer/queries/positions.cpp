//! Follows values back to positions, and the flow back to moves.
#include "analyzer/queries/positions.hpp"

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/program/block_view.hpp"

#include <algorithm>

namespace maclint::queries {
namespace {

using dataflow::Symbol;
using dataflow::SymbolId;

constexpr int most_operations = 12; ///< that are followed, one in the other

/// The addresses that move the axis; empty: any may.
std::string_view addresses_of(std::string_view axes, std::int32_t axis) {
    for (; axis > 0; --axis) {
        const std::size_t blank = axes.find(' ');
        if (blank == std::string_view::npos) return {};
        axes.remove_prefix(blank + 1);
    }
    return axes.substr(0, axes.find(' '));
}

/// Gathers the positions in expressions and in what was calculated before.
class Gather {
  public:
    Gather(const ProgramAnalysis& analysis, EffectId effect)
        : analysis_(analysis)
        , program_(analysis.program())
        , effect_(effect) {}

    void expression(ExpressionId id, flow::NodeId node, bool subtracted) {
        const auto& at = program_.expressions[id].node;
        if (add(id, node, subtracted)) return;
        if (std::holds_alternative<Load>(at)) {
            for (const dataflow::Read& read : analysis_.facts().at<dataflow::Read>(effect_))
                if (read.expression == id) return symbol(read.value.symbol, subtracted, most_operations);
        } else if (const auto* apply = std::get_if<Apply>(&at)) {
            const auto operands = program_.operands_of(*apply);
            for (std::size_t i = 0; i < operands.size(); ++i)
                expression(operands[i], node, subtracted != changes_sign(apply->operation, i));
        }
    }

    /// What is left when differences of one axis are taken out.
    [[nodiscard]] std::vector<PositionRead> found() const {
        std::vector<PositionRead> left;
        std::ranges::copy_if(found_, std::back_inserter(left), [&](const PositionRead& one) {
            return std::ranges::none_of(found_, [&](const PositionRead& other) {
                return other.axis == one.axis && other.subtracted != one.subtracted;
            });
        });
        return left;
    }

  private:
    static bool changes_sign(Operation operation, std::size_t operand) {
        return operation == Operation::negate || (operation == Operation::subtract && operand == 1);
    }

    bool add(ExpressionId id, flow::NodeId node, bool subtracted) {
        const auto* machine = std::get_if<LoadMachine>(&program_.expressions[id].node);
        if (machine == nullptr) return false;
        const VariableRange* range = analysis_.control().families[machine->family].find(machine->number);
        if (range == nullptr || range->positions_of.empty()) return false;
        const std::int32_t axis = machine->number - range->first;
        found_.push_back({id, node, axis, addresses_of(range->positions_of, axis), subtracted});
        return true;
    }

    void symbol(SymbolId id, bool subtracted, int depth) {
        const Symbol& symbol = analysis_.data().table().symbols[id];
        if (symbol.kind == Symbol::Kind::opaque && symbol.b == 0 && symbol.a < program_.expressions.size())
            add(static_cast<ExpressionId>(symbol.a), symbol.c, subtracted);
        if (symbol.kind != Symbol::Kind::result || depth == 0) return;
        const auto operation = static_cast<Operation>(symbol.a);
        this->symbol(symbol.b, subtracted != changes_sign(operation, 0), depth - 1);
        if (symbol.c != 0) this->symbol(symbol.c, subtracted != changes_sign(operation, 1), depth - 1);
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    EffectId effect_;
    std::vector<PositionRead> found_;
};

bool limits_look_ahead(const Program& program) {
    return std::ranges::any_of(program.effects, [](const Effect& effect) {
        const auto* stop = std::get_if<Synchronise>(&effect.what);
        return stop != nullptr && stop->from_here_on;
    });
}

bool ends_moves(const Effect& effect) {
    return std::holds_alternative<Synchronise>(effect.what) || std::holds_alternative<Call>(effect.what) ||
           std::holds_alternative<Stop>(effect.what) ||
           std::holds_alternative<UnreadableBlock>(effect.what) ||
           std::holds_alternative<ToolChange>(effect.what);
}

/// What a node that the control has passed means for a later one.
struct Passed {
    bool ends_moves = false;
    std::optional<Span> move = {}; ///< the last one
};

/// Whether one of the addresses stands in the blocks of the item.
bool names_one_of(const Program& program, const Item& item, std::string_view addresses) {
    const auto is_one = [&](std::string_view name) {
        return name.size() == 1 && addresses.find(name.front()) != std::string_view::npos;
    };
    if (addresses.empty()) return true;
    if (const auto* run = std::get_if<PlainRun>(&item)) {
        const auto& names = program.plain_tables[run->tables]->names;
        for (std::size_t id = 0; id < names.size(); ++id)
            if (is_one(names[id]) && run->words.addresses.contains(static_cast<syntax::AddressId>(id)))
                return true;
        return false;
    }
    const auto* block = std::get_if<Block>(&item);
    return block == nullptr ||
           std::ranges::any_of(std::span(program.words).subspan(block->words.first, block->words.count),
                               [&](const Word& word) { return is_one(word.address); });
}

/// Of moves only those count that one of the addresses stands beside.
Passed passed_at(const ProgramAnalysis& analysis, flow::NodeId id, std::string_view addresses) {
    const Program& program = analysis.program();
    const flow::Node& node = analysis.graph().nodes[id];
    Passed passed;
    const auto machine_function = [](const Word& word) { return word.address == "M"; };
    const bool moves_axis = names_one_of(program, program.items[node.item], addresses);
    for_each_block(program, node.stretch(), [&](const BlockView& block) {
        if (block.moves && moves_axis) passed = {false, block.span};
    });
    if (const auto* run = std::get_if<PlainRun>(&program.items[node.item])) {
        const auto& names = program.plain_tables[run->tables]->names;
        for (std::size_t id = 0; id < names.size(); ++id)
            if (names[id] == "M")
                passed.ends_moves = run->words.addresses.contains(static_cast<syntax::AddressId>(id));
        return passed;
    }
    for (const Effect& effect : program.effects_in(node.effects))
        if (std::holds_alternative<Motion>(effect.what) && moves_axis) passed.move = effect.span;
    const auto effects = program.effects_in(node.effects);
    passed.ends_moves = std::ranges::any_of(effects, ends_moves);
    if (const auto* block = std::get_if<Block>(&program.items[node.item]))
        passed.ends_moves |= std::ranges::any_of(
            std::span(program.words).subspan(block->words.first, block->words.count), machine_function);
    return passed;
}

} // namespace

std::vector<PositionRead> positions_in(const ProgramAnalysis& analysis, EffectId effect,
                                       ExpressionId expression) {
    const auto node = analysis.graph().node_of(effect);
    if (!node) return {};
    Gather gather(analysis, effect);
    gather.expression(expression, *node, false);
    return gather.found();
}

std::optional<UnfinishedMove> unfinished_move_before(const ProgramAnalysis& analysis,
                                                     const PositionRead& read) {
    std::optional<UnfinishedMove> found;
    if (limits_look_ahead(analysis.program())) return found;
    flow::walk<flow::Direction::backward>(
        analysis.graph(), {read.node}, [&](flow::EdgeId edge, flow::NodeId from) {
            if (found || !analysis.data().passable(edge) || !analysis.data().reached(from))
                return flow::Step::refuse;
            const Passed passed = passed_at(analysis, from, read.addresses);
            if (passed.ends_moves) return flow::Step::end;
            if (passed.move) found = UnfinishedMove{from, *passed.move};
            return passed.move ? flow::Step::end : flow::Step::go_on;
        });
    return found;
}

} // namespace maclint::queries
