//! Follows values back to positions, and the flow back to moves.
#include "analyzer/queries/machine/unfinished_moves.hpp"

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/flow/walk.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/source/budget.hpp"

#include <algorithm>

namespace maclint::queries {
namespace {

using dataflow::Symbol;
using dataflow::SymbolId;

constexpr int most_operations = 12; ///< that are followed, one in the other

/// Nodes before a read that are looked at for a move: no control reads ahead further.
constexpr std::size_t most_nodes_before = 2000;

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
    Gather(const ProgramAnalysis& analysis, EffectId effect, Positions which)
        : analysis_(analysis)
        , program_(analysis.program())
        , effect_(effect)
        , which_(which) {}

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
            return which_ == Positions::compared || !exemptions::distance_along_an_axis.is_on() ||
                   std::ranges::none_of(found_, [&](const PositionRead& other) {
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
        if (range == nullptr) return false;
        const bool is_kept = which_ != Positions::while_moving && range->is_skip_position;
        if (range->positions_of.empty() && !is_kept) return false;
        const std::int32_t axis = machine->number - range->first;
        found_.push_back({id, node, axis, addresses_of(range->positions_of, axis), subtracted, is_kept});
        return true;
    }

    void symbol(SymbolId id, bool subtracted, int depth) {
        const Symbol& symbol = analysis_.data().table().symbols[id];
        const auto expression = symbol.expression();
        if (expression && *expression < program_.expressions.size())
            add(static_cast<ExpressionId>(*expression), symbol.evaluated_at(), subtracted);
        if (symbol.kind() != Symbol::Kind::result || depth == 0) return;
        const Operation operation = symbol.operation();
        this->symbol(symbol.first(), subtracted != changes_sign(operation, 0), depth - 1);
        if (symbol.second() != 0)
            this->symbol(symbol.second(), subtracted != changes_sign(operation, 1), depth - 1);
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    EffectId effect_;
    Positions which_;
    std::vector<PositionRead> found_;
};

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

/// Whether one of the addresses stands among the words; empty: any would do.
bool names_one_of(std::span<const Word> words, std::string_view addresses) {
    return addresses.empty() || std::ranges::any_of(words, [&](const Word& word) {
               return word.address.size() == 1 &&
                      addresses.find(word.address.front()) != std::string_view::npos;
           });
}

/// Whether it switches a function of the machine that may stop look-ahead.
bool may_stop(const MachineFunctions& functions, const Word& word) {
    if (word.address != functions.address) return false;
    const auto* number = std::get_if<Literal>(&word.value);
    return number == nullptr || functions.may_stop_look_ahead(number->value);
}

/// Of moves only those count that one of the addresses stands beside.
Passed passed_at(const ProgramAnalysis& analysis, flow::NodeId id, std::string_view addresses) {
    const Program& program = analysis.program();
    const flow::Node& node = analysis.graph().nodes[id];
    const auto effects = program.effects_in(node.effects);
    const auto motion = std::ranges::find_if(
        effects, [](const Effect& effect) { return std::holds_alternative<Motion>(effect.what); });
    Passed passed;
    for_each_block_with_words(program, node.stretch(),
                              [&](const BlockView& block, std::span<const Word> words) {
                                  (void)Budget::allows(); // a long run is walked through as one node
                                  const bool moves = block.moves || motion != effects.end();
                                  if (moves && names_one_of(words, addresses))
                                      passed = {false, block.moves ? block.span : motion->span};
                                  passed.ends_moves |= std::ranges::any_of(words, [&](const Word& word) {
                                      return may_stop(analysis.control().functions, word);
                                  });
                              });
    passed.ends_moves |= std::ranges::any_of(effects, ends_moves);
    return passed;
}

} // namespace

bool limits_look_ahead(const Program& program) {
    return std::ranges::any_of(program.effects, [](const Effect& effect) {
        const auto* stop = std::get_if<Synchronise>(&effect.what);
        return stop != nullptr && stop->from_here_on;
    });
}

std::vector<PositionRead> positions_in(const ProgramAnalysis& analysis, EffectId effect,
                                       ExpressionId expression, Positions which) {
    const auto node = analysis.graph().node_of(effect);
    if (!node) return {};
    Gather gather(analysis, effect, which);
    gather.expression(expression, *node, false);
    return gather.found();
}

std::optional<UnfinishedMove> unfinished_move_before(const ProgramAnalysis& analysis, flow::NodeId node,
                                                     std::string_view addresses) {
    std::optional<UnfinishedMove> found;
    std::size_t looked_at = 0;
    flow::walk<flow::Direction::backward>(
        analysis.graph(), {node}, [&](flow::EdgeId edge, flow::NodeId from) {
            if (found || looked_at == most_nodes_before || !analysis.data().passable(edge) ||
                !analysis.data().reached(from))
                return flow::Step::refuse;
            ++looked_at;
            const Passed passed = passed_at(analysis, from, addresses);
            if (passed.ends_moves) return flow::Step::end;
            if (passed.move) found = UnfinishedMove{from, *passed.move};
            return passed.move ? flow::Step::end : flow::Step::go_on;
        });
    return found;
}

} // namespace maclint::queries
