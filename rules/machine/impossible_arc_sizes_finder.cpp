//! Tries numbers for the variables of an arc's words, and asks whether its ends lie on one circle.
#include "rules/machine/impossible_arc_sizes_finder.hpp"

#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/program/machine_words.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "analyzer/semantics/concrete.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <variant>
#include <vector>

namespace maclint::rules {
namespace {

constexpr std::size_t most_variables = 4; ///< that are tried at once
constexpr int most_assignments = 8;       ///< one made of another, from a word back to what was given

/// A variable whose value is not known.
struct Unknown {
    dataflow::SymbolId symbol;
    ExpressionId read;
};

class Sizes {
  public:
    Sizes(const ProgramAnalysis& analysis, EffectId words)
        : analysis_(analysis)
        , words_(words) {}

    /// Numbers for the unknowns, in the order in which they are met.
    void choose(const std::vector<double>& numbers) { numbers_ = numbers; }
    [[nodiscard]] const std::vector<Unknown>& unknowns() const { return unknowns_; }

    /// The value of a word; nothing where it cannot be calculated.
    std::optional<double> value(const Word* word) {
        if (word == nullptr) return 0;
        if (const auto* literal = std::get_if<Literal>(&word->value))
            return literal->decimal_point || literal->value == 0 ? std::optional(literal->value)
                                                                 : std::nullopt;
        const auto* id = std::get_if<ExpressionId>(&word->value);
        return id == nullptr ? std::nullopt : value(*id, words_, most_assignments);
    }

  private:
    std::optional<double> value(ExpressionId id, EffectId effect, int depth) {
        const auto& node = analysis_.program().expressions[id].node;
        if (const auto* literal = std::get_if<Literal>(&node)) return literal->value;
        if (const auto* apply = std::get_if<Apply>(&node)) {
            std::vector<double> operands;
            for (const ExpressionId operand : analysis_.program().operands_of(*apply)) {
                const auto number = value(operand, effect, depth);
                if (!number) return std::nullopt;
                operands.push_back(*number);
            }
            const auto result = semantics::compute(apply->operation, operands);
            const auto* number = std::get_if<double>(&result);
            return number == nullptr ? std::nullopt : std::optional(*number);
        }
        return std::holds_alternative<Load>(node) ? value_of_read(id, effect, depth) : std::nullopt;
    }

    std::optional<double> value_of_read(ExpressionId id, EffectId effect, int depth) {
        const auto reads = analysis_.facts().at<dataflow::Read>(effect);
        const auto read = std::ranges::find(reads, id, &dataflow::Read::expression);
        if (read == reads.end()) return std::nullopt;
        if (const auto number = read->value.constant()) return number;
        if (const dataflow::Store* store = queries::store_of(analysis_, read->value))
            return depth == 0 ? std::nullopt : value(store->expression, store->effect, depth - 1);
        if (read->value.symbol == 0) return std::nullopt;
        auto unknown = std::ranges::find(unknowns_, read->value.symbol, &Unknown::symbol);
        if (unknown == unknowns_.end()) {
            if (unknowns_.size() == most_variables) return std::nullopt;
            unknown = unknowns_.insert(unknown, {read->value.symbol, id});
        }
        const auto place = static_cast<std::size_t>(unknown - unknowns_.begin());
        return numbers_[place];
    }

    const ProgramAnalysis& analysis_;
    EffectId words_;
    std::vector<Unknown> unknowns_;
    std::vector<double> numbers_ = std::vector<double>(most_variables, 1);
};

/// The words of a circle in X and Y by its centre, counted from where the tool is.
struct Circle {
    std::array<const Word*, 2> way, centre;

    [[nodiscard]] bool is_calculated() const {
        const auto is_expression = [](const Word* word) {
            return word != nullptr && std::holds_alternative<ExpressionId>(word->value);
        };
        return std::ranges::any_of(way, is_expression) || std::ranges::any_of(centre, is_expression);
    }
};

std::optional<Circle> circle_of(const ControlModel& control, const machine::Step& step) {
    constexpr std::size_t z = 2;
    const MachineWords& letters = *control.machine_words;
    const machine::Known& distance = step.after.of(ModalRole::distance);
    const machine::Known& plane = step.after.of(ModalRole::plane);
    if (letters.x_is_diameter || !machine::moves_on_circle(step, control)) return std::nullopt;
    if (!distance.is_known() || distance.is(letters.absolute) || letters.centres[z] == 0) return std::nullopt;
    const auto planes = control.group_with(ModalRole::plane);
    const bool is_xy =
        plane.is_callers() || (planes && plane.is(control.groups[*planes].members.front().number));
    constexpr std::string_view of_other_curves = "ABCELPQ";
    const bool is_more =
        std::ranges::any_of(of_other_curves, [&](char letter) { return step.words.has(letter); });
    const machine::Words& words = step.words;
    if (!is_xy || is_more || words.has(letters.radius) || words.has(letters.centres[z])) return std::nullopt;
    const auto word = [&](char letter) { return words.word(letter); };
    return Circle{{word(letters.axes[0]), word(letters.axes[1])},
                  {word(letters.centres[0]), word(letters.centres[1])}};
}

/// Whether both ends lie on one circle; nothing where that cannot be calculated.
std::optional<bool> is_circle(const Circle& circle, Sizes& sizes) {
    constexpr double nearness = 0.01; // of the radius
    const auto x = sizes.value(circle.way[0]), y = sizes.value(circle.way[1]);
    const auto i = sizes.value(circle.centre[0]), j = sizes.value(circle.centre[1]);
    if (!x || !y || !i || !j) return std::nullopt;
    const double first = std::hypot(*i, *j), second = std::hypot(*x - *i, *y - *j);
    if (!(std::max(first, second) > 0)) return std::nullopt;
    return std::abs(first - second) <= nearness * std::max(first, second);
}

/// Numbers that nobody's circle has by chance.
constexpr std::array<std::array<double, most_variables>, 3> tried = {{
    {3.7, 11.3, 29.1, 6.1},
    {41.9, 17.3, 5.3, 83.9},
    {8.3, 61.7, 23.9, 2.9},
}};

/// Whether it is a circle with every one of the numbers, or with none; nothing where neither is so.
std::optional<bool> is_always(const Circle& circle, Sizes& sizes,
                              const std::array<std::size_t, 4>& number_of) {
    std::optional<bool> all;
    for (const auto& row : tried) {
        std::vector<double> numbers;
        for (const std::size_t number : number_of) numbers.push_back(row[number]);
        sizes.choose(numbers);
        const auto one = is_circle(circle, sizes);
        if (!one || (all && *all != *one)) return std::nullopt;
        all = one;
    }
    return all;
}

std::optional<EffectId> words_of(const Program& program, const machine::Step& step) {
    const Slice effects = step.block.effects;
    for (EffectId id = effects.first; id < effects.first + effects.count; ++id)
        if (std::holds_alternative<EvaluateWords>(program.effects[id].what)) return id;
    return std::nullopt;
}

} // namespace

std::optional<WrongSizes> wrong_sizes(const ProgramAnalysis& analysis, const machine::Step& step) {
    const auto words = words_of(analysis.program(), step);
    const auto circle = words ? circle_of(analysis.control(), step) : std::nullopt;
    if (!circle || !circle->is_calculated()) return std::nullopt;
    Sizes sizes(analysis, *words);
    std::array<std::size_t, most_variables> number_of = {0, 1, 2, 3};
    if (is_always(*circle, sizes, number_of) != false) return std::nullopt;
    const std::size_t count = sizes.unknowns().size();
    if (count == 0) return WrongSizes{{}, {}, 0};
    if (count == 1) return WrongSizes{sizes.unknowns().front().read, {}, tried.front().front()};
    for (std::size_t second = 1; second < count; ++second)
        for (std::size_t first = 0; first < second; ++first) {
            number_of = {0, 1, 2, 3};
            number_of[second] = first;
            if (is_always(*circle, sizes, number_of) == true)
                return WrongSizes{sizes.unknowns()[first].read, sizes.unknowns()[second].read, 0};
        }
    return std::nullopt;
}

} // namespace maclint::rules
