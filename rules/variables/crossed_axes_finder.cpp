//! Holds the expressions of two assignments against each other.
#include "rules/variables/crossed_axes_finder.hpp"

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"

#include <algorithm>
#include <cstdint>
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

/// Which axis the number of a family belongs to, from 1 on; 0: it does not go by axes.
std::int32_t axis_of(const Program& program, FamilyId family, std::int32_t number) {
    const VariableRange* range = program.control->families[family].find(number);
    return range == nullptr ? 0 : range->axis(number);
}

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
            if (machine->family != other.family || (apart != 0 && apart != 1)) return false;
            if (apart == 0 && axis_of(program_, machine->family, machine->number) != 0)
                of_one_axis_.push_back({first, second, place_of(*machine), place_of(*machine)});
            return true;
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
    /// Where both take the same number of those that go by axes.
    [[nodiscard]] const std::vector<Operands>& of_one_axis() const { return of_one_axis_; }

  private:
    [[nodiscard]] Variable place_of(const LoadMachine& machine) const {
        return {program_.control->families[machine.family].find(machine.number)->space, machine.number};
    }

    const Program& program_;
    std::vector<Operands> operands_, of_one_axis_;
    bool axes_ = false;
};

struct Statement {
    EffectId effect;
    const Assign* assign;
    Variable target;
    std::int32_t axis; ///< of the offset that it sets; 0: it sets none
};

bool is_next(Variable variable, Variable next) {
    return variable.space == next.space && next.number == variable.number + 1;
}

bool goes_on(const Operands& operands) { return is_next(operands.of_first, operands.of_second); }

/// Whether each variable of the first stands in the second, too, or the next one does.
bool stay_or_go_on(const Pair& pair) {
    return std::ranges::all_of(pair.operands(), [](const Operands& operands) {
        return operands.of_first == operands.of_second || goes_on(operands);
    });
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

/// Both take the place of one axis where they set offsets of two, or take other places of two.
std::optional<CrossedStatements> crossed_places(const Program& program, const Pair& pair,
                                                const Statement& one, const Statement& two) {
    const bool for_axes = one.axis != 0 && two.axis == one.axis + 1;
    if (!stay_or_go_on(pair) || !for_axes || pair.of_one_axis().size() != 1) return std::nullopt;
    const Operands& place = pair.of_one_axis().front();
    const auto* load = std::get_if<LoadMachine>(&program.expressions[place.first].node);
    const std::int32_t axis = axis_of(program, load->family, load->number);
    Variable meant = place.of_first;
    if (axis == one.axis) {
        ++meant.number;
        return CrossedStatements{two.effect, one.effect, place.second, meant, place.of_first};
    }
    --meant.number;
    if (axis == two.axis)
        return CrossedStatements{one.effect, two.effect, place.first, meant, place.of_first};
    return std::nullopt;
}

bool sets_offset_of(const Program& program, std::int32_t axis) {
    return std::ranges::any_of(program.effects, [&](const Effect& effect) {
        const auto* assign = std::get_if<Assign>(&effect.what);
        const auto* offset = assign == nullptr ? nullptr : std::get_if<StoreMachine>(&assign->target);
        return offset != nullptr && axis_of(program, offset->family, offset->number) == axis;
    });
}

bool is_read(const Program& program, FamilyId family, std::int32_t number) {
    return std::ranges::any_of(program.expressions, [&](const Expression& expression) {
        const auto* load = std::get_if<LoadMachine>(&expression.node);
        return load != nullptr && load->family == family && load->number == number;
    });
}

/// Both take the place of one axis, and the next of something else; the program sets offsets of the next
/// axis, and reads its place nowhere.
std::optional<CrossedStatements> one_place_for_two(const Program& program, const Pair& pair,
                                                   const Statement& one, const Statement& two) {
    if (one.axis != 0 || pair.of_one_axis().size() != 1) return std::nullopt;
    if (!stay_or_go_on(pair) || std::ranges::none_of(pair.operands(), goes_on)) return std::nullopt;
    const Operands& place = pair.of_one_axis().front();
    const auto* load = std::get_if<LoadMachine>(&program.expressions[place.first].node);
    const std::int32_t next = axis_of(program, load->family, load->number) + 1;
    if (axis_of(program, load->family, load->number + 1) != next || !sets_offset_of(program, next) ||
        is_read(program, load->family, load->number + 1))
        return std::nullopt;
    return CrossedStatements{
        two.effect, one.effect, place.second, {place.of_first.space, load->number + 1}, place.of_first};
}

std::optional<CrossedStatements> crossed(const Program& program, const Statement& one, const Statement& two) {
    Pair pair(program);
    if (!is_next(one.target, two.target) || !pair.alike(one.assign->value, two.assign->value))
        return std::nullopt;
    if (auto places = crossed_places(program, pair, one, two)) return places;
    if (auto places = one_place_for_two(program, pair, one, two)) return places;
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
    if (assign == nullptr) return std::nullopt;
    if (const auto* target = std::get_if<Variable>(&assign->target))
        return Statement{block->effects.first, assign, *target, 0};
    const auto* offset = std::get_if<StoreMachine>(&assign->target);
    const VariableRange* range =
        offset == nullptr ? nullptr : program.control->families[offset->family].find(offset->number);
    if (range == nullptr) return std::nullopt;
    return Statement{block->effects.first,
                     assign,
                     {range->space, offset->number},
                     axis_of(program, offset->family, offset->number)};
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
