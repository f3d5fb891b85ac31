//! Holds the expressions of two assignments against each other.
#include "rules/variables/crossed_axes_finder.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"

#include <optional>
#include <string_view>
#include <utility>

namespace maclint::rules {
namespace {

/// A variable of each statement, in the same place.
struct Operands {
    ExpressionId first, second;
    Variable of_first, of_second;
};

/// The two expressions, side by side.
class Pair {
  public:
    explicit Pair(const Program& program)
        : program_(program) {}

    /// Whether they are alike but for their variables, of which those of the second may have the next number.
    bool alike(ExpressionId first, ExpressionId second) {
        const auto& a = program_.expressions[first].node;
        const auto& b = program_.expressions[second].node;
        if (a.index() != b.index()) return false;
        if (const auto* load = std::get_if<Load>(&a)) {
            const Variable other = std::get<Load>(b).variable;
            if (load->variable.space != other.space) return false;
            operands_.push_back({first, second, load->variable, other});
            return true;
        }
        if (const auto* machine = std::get_if<LoadMachine>(&a)) {
            const auto& other = std::get<LoadMachine>(b);
            const auto apart = other.number - machine->number;
            axes_ |= apart == 1;
            return machine->family == other.family && (apart == 0 || apart == 1);
        }
        if (const auto* literal = std::get_if<Literal>(&a))
            return literal->value == std::get<Literal>(b).value;
        const auto* apply = std::get_if<Apply>(&a);
        if (apply == nullptr || apply->operation != std::get<Apply>(b).operation) return false;
        const auto left = program_.operands_of(*apply);
        const auto right = program_.operands_of(std::get<Apply>(b));
        bool same = left.size() == right.size();
        for (std::size_t i = 0; same && i < left.size(); ++i) same = alike(left[i], right[i]);
        return same;
    }

    [[nodiscard]] bool has_places_of_axes() const { return axes_; }
    [[nodiscard]] const std::vector<Operands>& operands() const { return operands_; }

  private:
    const Program& program_;
    std::vector<Operands> operands_;
    bool axes_ = false;
};

struct Statement {
    EffectId effect;
    const Assign* assign;
    Variable target;
};

bool is_next(Variable variable, Variable next) {
    return variable.space == next.space && next.number == variable.number + 1;
}

/// Whether the letters of two axes set them.
bool are_axes(const Program& program, Variable first, Variable second) {
    const auto a = program.control->letter_of(first);
    const auto b = program.control->letter_of(second);
    const auto is_axis = [](char letter) {
        return letters_of_lengths.find(letter) != std::string_view::npos;
    };
    return a && b && is_axis(*a) && is_axis(*b);
}

std::optional<CrossedStatements> crossed(const Program& program, const Statement& one, const Statement& two) {
    Pair pair(program);
    if (!is_next(one.target, two.target) || !pair.alike(one.assign->value, two.assign->value))
        return std::nullopt;
    std::optional<CrossedStatements> found;
    bool others_follow = pair.has_places_of_axes();
    for (const Operands& operands : pair.operands()) {
        if (is_next(operands.of_first, operands.of_second)) {
            others_follow = true;
        } else if (!(operands.of_first == operands.of_second)) {
            return std::nullopt;
        } else if (operands.of_first == one.target || operands.of_first == two.target) {
            if (found) return std::nullopt;
            found = operands.of_first == one.target
                        ? CrossedStatements{two.effect, one.effect, operands.second, two.target, one.target}
                        : CrossedStatements{one.effect, two.effect, operands.first, one.target, two.target};
        }
    }
    const bool for_axes = pair.has_places_of_axes() || are_axes(program, one.target, two.target);
    return others_follow && for_axes ? found : std::nullopt;
}

/// The assignment that a block is, and nothing else.
std::optional<Statement> statement_of(const Program& program, ItemId item) {
    const auto block = stored_block(program, item);
    if (!block || block->effects.count != 1) return std::nullopt;
    const auto* assign = std::get_if<Assign>(&program.effects[block->effects.first].what);
    const auto* target = assign == nullptr ? nullptr : std::get_if<Variable>(&assign->target);
    if (target == nullptr) return std::nullopt;
    return Statement{block->effects.first, assign, *target};
}

} // namespace

std::vector<CrossedStatements> find_crossed_statements(const Program& program) {
    std::vector<CrossedStatements> found;
    std::optional<Statement> before;
    for (ItemId item = 0; item < program.items.size(); ++item) {
        const auto now = statement_of(program, item);
        if (before && now)
            if (const auto pair = crossed(program, *before, *now)) found.push_back(*pair);
        before = now;
    }
    return found;
}

} // namespace maclint::rules
