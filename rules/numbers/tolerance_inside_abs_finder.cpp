//! Looks into the sides of comparisons, and at what remarks call a tolerance.
#include "rules/numbers/tolerance_inside_abs_finder.hpp"

#include "analyzer/dataflow/facts/comparison.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/values/copies.hpp"
#include "analyzer/semantics/concrete.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <variant>

namespace maclint::rules {
namespace {

bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }

/// What a remark calls a tolerance, as `#501` or `E`: names that a word for it follows.
class NamedTolerances {
  public:
    explicit NamedTolerances(const Program& program)
        : program_(program) {
        const std::string text = in_capitals(program.slice(program.span));
        for (std::size_t open = text.find('('); open != std::string::npos; open = text.find('(', open + 1)) {
            const std::size_t close = text.find(')', open);
            if (close == std::string::npos) return;
            read(std::string_view(text).substr(open + 1, close - open - 1));
            open = close;
        }
    }
    [[nodiscard]] bool hold(Variable variable) const {
        const auto has = [&](std::string_view name) {
            return std::ranges::find(names_, name) != names_.end();
        };
        if (has("#" + std::to_string(variable.number))) return true;
        if (!program_.is_formal(variable)) return false;
        const auto letter = program_.control->letter_of(variable);
        return letter && has(std::string_view(&*letter, 1));
    }

  private:
    /// `X Y NOMINAL, E TOLERANCE` names E; of `X Y TOLERANCE` nobody knows which is one, and `WITH A
    /// TOLERANCE` names nothing.
    void read(std::string_view remark) {
        constexpr std::array<std::string_view, 2> words = {"TOL", "MARGIN"};
        for (const std::string_view word : words)
            for (std::size_t at = remark.find(word); at != std::string_view::npos;
                 at = remark.find(word, at + 1)) {
                std::string_view rest = remark.substr(0, at);
                const std::string_view name = take_name(rest);
                if (name.starts_with('#') || (!name.empty() && !ends_with_a_word(rest)))
                    names_.emplace_back(name);
            }
    }
    static bool ends_with_a_word(std::string_view text) {
        const std::size_t last = text.find_last_not_of(' ');
        return last != std::string_view::npos && (is_letter(text[last]) || is_digit(text[last]));
    }
    /// Takes a letter that stands alone, or a variable, off the end.
    static std::string_view take_name(std::string_view& text) {
        const std::size_t last = text.find_last_not_of(" =:");
        if (last == std::string_view::npos || last + 1 == text.size()) return {}; // part of another word
        std::size_t begin = last;
        while (begin > 0 && is_digit(text[begin])) --begin;
        const bool is_name = begin == last ? is_letter(text[begin]) : text[begin] == '#';
        if (!is_name || (begin > 0 && (is_letter(text[begin - 1]) || is_digit(text[begin - 1])))) return {};
        const std::string_view name = text.substr(begin, last + 1 - begin);
        text = text.substr(0, begin);
        return name;
    }

    const Program& program_;
    std::vector<std::string> names_;
};

class ShiftedDifferences {
  public:
    explicit ShiftedDifferences(const ProgramAnalysis& analysis)
        : analysis_(analysis)
        , program_(analysis.program())
        , named_(analysis.program()) {
        for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>())
            reads_.emplace(read.expression, &read);
    }

    [[nodiscard]] std::optional<ShiftedDifference> in(EffectId effect, ExpressionId side) const {
        const ExpressionId amount = stored_in(side);
        const Apply* absolute = applied(amount, Operation::absolute);
        if (absolute == nullptr) return std::nullopt;
        const ExpressionId inside = program_.operands_of(*absolute).front();
        const ExpressionId difference = stored_in(inside);
        const auto tolerance = tolerance_in(difference);
        if (!tolerance) return std::nullopt;
        const bool is_stored = amount != side || difference != inside;
        return ShiftedDifference{effect, side, program_.expressions[difference].span,
                                 program_.expressions[*tolerance].span, is_stored};
    }

  private:
    [[nodiscard]] const Apply* applied(ExpressionId id, Operation operation) const {
        const auto* apply = std::get_if<Apply>(&program_.expressions[id].node);
        return apply != nullptr && apply->operation == operation ? apply : nullptr;
    }
    [[nodiscard]] const dataflow::Read* read_of(ExpressionId id) const {
        const auto read = reads_.find(id);
        return read == reads_.end() ? nullptr : read->second;
    }
    /// What was assigned to the variable that the expression is; else the expression itself.
    [[nodiscard]] ExpressionId stored_in(ExpressionId id) const {
        const dataflow::Read* read = read_of(id);
        const dataflow::Store* store = read == nullptr ? nullptr : queries::store_of(analysis_, read->value);
        return store == nullptr ? id : store->expression;
    }
    /// Of `a-b-t`, `a-b+t` and `a-[b+t]`.
    [[nodiscard]] std::optional<ExpressionId> tolerance_in(ExpressionId difference) const {
        const auto operands = operands_of_sum(difference);
        if (!operands) return std::nullopt;
        const auto [first, last] = *operands;
        if (applied(first, Operation::subtract) != nullptr && is_tolerance(last)) return last;
        const auto inner = operands_of_sum(last);
        const bool is_difference = applied(difference, Operation::subtract) != nullptr;
        return is_difference && inner && is_tolerance(inner->second) ? std::optional(inner->second)
                                                                     : std::nullopt;
    }
    [[nodiscard]] std::optional<std::pair<ExpressionId, ExpressionId>>
    operands_of_sum(ExpressionId id) const {
        for (const Operation operation : {Operation::subtract, Operation::add})
            if (const Apply* sum = applied(id, operation)) {
                const auto operands = program_.operands_of(*sum);
                return std::pair{operands[0], operands[1]};
            }
        return std::nullopt;
    }
    /// A hundredth of a millimetre, a thousandth of an inch, or what a remark calls so.
    [[nodiscard]] bool is_tolerance(ExpressionId id) const {
        constexpr double greatest = 0.02;
        const auto* literal = std::get_if<Literal>(&program_.expressions[id].node);
        const dataflow::Read* read = read_of(id);
        const auto number = literal != nullptr ? std::optional(literal->value)
                            : read != nullptr  ? read->value.constant()
                                               : std::nullopt;
        if (number && *number != 0 && std::abs(*number) <= greatest) return true;
        return read != nullptr && named_.hold(read->variable);
    }

    const ProgramAnalysis& analysis_;
    const Program& program_;
    NamedTolerances named_;
    std::unordered_map<ExpressionId, const dataflow::Read*> reads_;
};

/// Whether an amount is taken anywhere.
bool takes_amounts(const Program& program) {
    return std::ranges::any_of(program.expressions, [](const Expression& expression) {
        const auto* apply = std::get_if<Apply>(&expression.node);
        return apply != nullptr && apply->operation == Operation::absolute;
    });
}

} // namespace

std::vector<ShiftedDifference> find_shifted_differences(const ProgramAnalysis& analysis) {
    std::vector<ShiftedDifference> found;
    if (!takes_amounts(analysis.program())) return found;
    const ShiftedDifferences search(analysis);
    for (const dataflow::Comparison& comparison : analysis.facts().all<dataflow::Comparison>()) {
        if (!semantics::is_order(comparison.operation)) continue;
        for (const ExpressionId side : {comparison.left_expression, comparison.right_expression})
            if (const auto shifted = search.in(comparison.effect, side)) found.push_back(*shifted);
    }
    return found;
}

} // namespace maclint::rules
