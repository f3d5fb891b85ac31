//! Lowering of expressions and conditions.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/fanuc/functions.hpp"
#include "analyzer/dialect/fanuc/keywords.hpp"
#include "analyzer/dialect/fanuc/lowering.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/program/faults.hpp"

#include <algorithm>
#include <array>

namespace maclint::fanuc {
namespace {

// clang-format off
constexpr FunctionRow operators[] = {
    {"+", Operation::add}, {"-", Operation::subtract}, {"*", Operation::multiply}, {"/", Operation::divide},
    {"MOD", Operation::modulo}, {"AND", Operation::bit_and}, {"OR", Operation::bit_or}, {"XOR", Operation::bit_xor},
};

constexpr FunctionRow comparisons[] = {
    {"EQ", Operation::equal}, {"NE", Operation::not_equal},  {"LT", Operation::less},
    {"LE", Operation::less_equal}, {"GT", Operation::greater}, {"GE", Operation::greater_equal},
};
// clang-format on

/// The name in any case; most are written in capitals, as the rows are.
Operation find(std::span<const FunctionRow> rows, std::string_view name) {
    auto row = std::ranges::find(rows, name, &FunctionRow::name);
    if (row == rows.end()) row = std::ranges::find(rows, in_capitals(name), &FunctionRow::name);
    return row == rows.end() ? Operation::unknown : row->operation;
}

/// The operator between conditions that is written like the one between numbers.
Operation between_conditions(Operation operation) {
    switch (operation) {
    case Operation::bit_and: return Operation::all_of;
    case Operation::bit_or: return Operation::any_of;
    case Operation::bit_xor: return Operation::one_of;
    case Operation::bit_not: return Operation::not_of;
    default: return operation;
    }
}

} // namespace

bool BlockLowering::is_logical(ExpressionId id) const {
    const auto* apply = std::get_if<Apply>(&expression(id).node);
    if (apply == nullptr) return false;
    switch (apply->operation) {
    case Operation::all_of:
    case Operation::any_of:
    case Operation::one_of:
    case Operation::not_of:
    case Operation::equal:
    case Operation::not_equal:
    case Operation::less:
    case Operation::less_equal:
    case Operation::greater:
    case Operation::greater_equal:
    case Operation::is_vacant:
    case Operation::is_set: return true;
    default: return false;
    }
}

ExpressionId BlockLowering::lower_expression(const Node& node) {
    if (depth_ >= deepest) return unreadable(span(node));
    ++depth_;
    const auto lowered = [&]() -> ExpressionId {
        switch (kind_of(node)) {
        case Kind::number: check_digits(node); return number(text(node), span(node));
        case Kind::label: {
            const std::optional<std::int64_t> number = read_integer(text(node));
            return number ? literal(static_cast<double>(*number), span(node)) : unreadable(span(node));
        }
        case Kind::variable: {
            const std::optional<std::int64_t> number = number_of_variable(text(node));
            return number ? load_numbered(*number, span(node)) : unreadable(span(node));
        }
        case Kind::indirect_variable:
        case Kind::double_sharp: {
            const Node* index = child(node, Field::index);
            if (index == nullptr) return unreadable(span(node));
            const ExpressionId at = lower_expression(*index);
            return add({LoadAt{numbered, at}, span(node)});
        }
        case Kind::named_variable:
        case Kind::foreign_variable: return lower_named(node);
        case Kind::bracket:
        case Kind::condition:
        case Kind::unbracketed_condition: {
            const Node* inner = only_child(node);
            if (inner == nullptr) return unreadable(span(node));
            const ExpressionId id = lower_expression(*inner);
            return widen(id, span(node));
        }
        case Kind::call: return lower_function(node);
        case Kind::unary: return lower_unary(node);
        case Kind::binary:
        case Kind::compound_condition: return lower_binary(node);
        case Kind::comparison: return lower_comparison(node);
        default: return unreadable(span(node));
        }
    }();
    --depth_;
    return lowered;
}

/// Of IF and WHILE.
ExpressionId BlockLowering::lower_condition(const Node& node, std::string_view fault) {
    check_condition(node, fault);
    in_condition_ = true;
    const ExpressionId id = lower_expression(node);
    in_condition_ = false;
    if (!is_logical(id) && !std::holds_alternative<Unreadable>(expression(id).node))
        check_lacking(Extra::bare_condition, span(node), text(node));
    return id;
}

ExpressionId BlockLowering::load_numbered(std::int64_t number, Span span) {
    const VariableRange* range = program_->control->families[numbered].find(number);
    if (range == nullptr) return add({LoadAt{numbered, literal(static_cast<double>(number), span)}, span});
    const auto n = static_cast<std::int32_t>(number);
    switch (range->meaning) {
    case Meaning::null: return add({Vacant{}, span});
    case Meaning::variable: return add({Load{Variable{range->space, n}}, span});
    case Meaning::modal: return add({LoadModal{range->group}, span});
    case Meaning::machine:
    case Meaning::absent: break;
    }
    return add({LoadMachine{numbered, n}, span});
}

/// A named variable is known by all that is written: `#_ABSKP[1]` is another one than `#_ABSKP[2]`.
Variable BlockLowering::named_variable(const Node& node) {
    std::string name = upper_text(node);
    std::erase_if(name, [](char c) { return c == ' ' || c == '\t'; });
    return {spaces::named, builder_->number_of_name(spaces::named, name)};
}

ExpressionId BlockLowering::lower_named(const Node& node) {
    check_name(node);
    if (kind_of(node) == Kind::named_variable) check_lacking(Extra::named_variable, span(node), text(node));
    const Node* index = child(node, Field::index);
    if (index == nullptr || kind_of(*index) == Kind::number)
        return add({Load{named_variable(node)}, span(node)});
    const std::array operands{lower_expression(*index)};
    return apply(Operation::unknown, operands, span(node));
}

ExpressionId BlockLowering::lower_unary(const Node& node) {
    const Node* sign = child(node, Field::operation);
    const Node* operand = child(node, Field::operand);
    if (sign == nullptr || operand == nullptr) return unreadable(span(node));
    check_sign(*operand);
    const ExpressionId value = lower_expression(*operand);
    const std::string name = upper_text(*sign);
    if (name == "NOT") {
        const std::array operands{value};
        const Operation operation = is_logical(value) ? Operation::not_of : Operation::bit_not;
        return apply(operation, operands, span(node));
    }
    return with_sign(name != "+", value, kind_of(*operand) == Kind::number, span(node));
}

BlockLowering::Sides BlockLowering::sides_of(const Node& node) const {
    Sides sides{};
    for_each_below(node, [&](const Node& below) {
        const Field field = field_of(below);
        const Node** side = field == Field::left        ? &sides.left
                            : field == Field::operation ? &sides.sign
                            : field == Field::right     ? &sides.right
                                                        : nullptr;
        if (side != nullptr && *side == nullptr && !is_remark(below)) *side = &below;
    });
    return sides;
}

ExpressionId BlockLowering::lower_binary(const Node& node) {
    const auto [left, sign, right] = sides_of(node);
    if (left == nullptr || right == nullptr || sign == nullptr) return unreadable(span(node));
    const std::array operands{lower_expression(*left), lower_expression(*right)};
    Operation operation = find(operators, text(*sign));
    if (operation == Operation::add || operation == Operation::subtract) check_sign(*right);
    if (operation == Operation::modulo) check_lacking(Extra::remainder, span(*sign), "MOD");
    if (kind_of(node) == Kind::compound_condition || is_logical(operands[0]) || is_logical(operands[1]))
        operation = between_conditions(operation);
    return apply(operation, operands, span(node));
}

/// Comparison with the null variable asks whether the other side is vacant.
ExpressionId BlockLowering::lower_comparison(const Node& node) {
    const auto [left, sign, right] = sides_of(node);
    if (left == nullptr || right == nullptr || sign == nullptr) return unreadable(span(node));
    const std::array operands{lower_expression(*left), lower_expression(*right)};
    const std::string_view word = comparison_word(text(*sign));
    if (word.empty() && !in_condition_) check_comparison(node);
    const Operation operation = find(comparisons, word.empty() ? text(*sign) : word);
    if (operation == Operation::equal || operation == Operation::not_equal) {
        const auto is_null = [&](ExpressionId id) {
            return std::holds_alternative<Vacant>(expression(id).node);
        };
        const Operation test = operation == Operation::equal ? Operation::is_vacant : Operation::is_set;
        if (is_null(operands[1])) return apply(test, std::span(operands).first(1), span(node));
        if (is_null(operands[0])) return apply(test, std::span(operands).last(1), span(node));
    }
    return apply(operation, operands, span(node));
}

ExpressionId BlockLowering::lower_function(const Node& node) {
    const Node* name = child(node, Field::function);
    const Node* argument = child(node, Field::argument);
    if (name == nullptr || argument == nullptr) return unreadable(span(node));
    std::vector<ExpressionId> operands;
    if (kind_of(*argument) != Kind::argument_list && kind_of(*argument) != Kind::bracket)
        check_argument(*name, *argument);
    if (kind_of(*argument) == Kind::argument_list) {
        for_each_child(*argument,
                       [&](const Node& operand) { operands.push_back(lower_expression(operand)); });
    } else {
        operands.push_back(lower_expression(*argument));
    }
    const Node* divisor = child(node, Field::divisor);
    check_function(text(*name), operands.size(), divisor != nullptr, span(node));
    if (divisor != nullptr) operands.push_back(lower_expression(*divisor));
    Operation operation = find(functions(), text(*name));
    if (operation == Operation::arc_tangent && operands.size() == 2)
        operation = Operation::arc_tangent_of_two;
    const std::size_t wanted =
        operation == Operation::arc_tangent_of_two || operation == Operation::power ? 2 : 1;
    if (operands.size() != wanted) {
        check_count(node, operation);
        operation = Operation::unknown;
    }
    return apply(operation, operands, span(node));
}

} // namespace maclint::fanuc
