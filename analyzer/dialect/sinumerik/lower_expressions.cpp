//! Lowering of expressions, conditions and variables.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/dialect/sinumerik/functions.hpp"
#include "analyzer/dialect/sinumerik/lowering.hpp"
#include "analyzer/dialect/sinumerik/tables.hpp"
#include "analyzer/program/whole_number.hpp"
#include "analyzer/source/text_hash.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace maclint::sinumerik {
namespace {

struct OperationRow {
    std::string_view name;
    Operation operation;
};

// What is not here has no row of semantics: bits.
// clang-format off
constexpr OperationRow operators[] = {
    {"+", Operation::add},      {"-", Operation::subtract},   {"*", Operation::multiply}, {"/", Operation::divide},
    {"AND", Operation::all_of}, {"OR", Operation::any_of},    {"XOR", Operation::one_of},
    {"==", Operation::equal},   {"=", Operation::equal},      {"<>", Operation::not_equal},
    {"<", Operation::less},     {"<=", Operation::less_equal}, {">", Operation::greater}, {">=", Operation::greater_equal},
    // of other languages
    {"EQ", Operation::equal},   {"NE", Operation::not_equal}, {"!=", Operation::not_equal}, {"><", Operation::not_equal},
    {"LT", Operation::less},    {"LE", Operation::less_equal}, {"=<", Operation::less_equal},
    {"GT", Operation::greater}, {"GE", Operation::greater_equal}, {"=>", Operation::greater_equal},
};
// clang-format on

Operation find(std::span<const OperationRow> rows, std::string_view name) {
    const auto row = std::ranges::find(rows, name, &OperationRow::name);
    return row == rows.end() ? Operation::unknown : row->operation;
}

/// `'H1F'`, `'B101'`, `'D10'`.
std::optional<double> based_number(std::string_view written) {
    constexpr int hexadecimal = 16, binary = 2, decimal = 10;
    if (written.size() < 4) return std::nullopt;
    const char letter = to_capital(written[1]);
    const int base = letter == 'H' ? hexadecimal : letter == 'B' ? binary : decimal;
    const std::string_view digits = written.substr(2, written.size() - 3);
    std::uint32_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
    if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
    return value;
}

} // namespace

ExpressionId BlockLowering::lower_expression(const Node& node) {
    if (depth_ >= deepest) return unreadable(span(node));
    ++depth_;
    const ExpressionId id = lower_below(node);
    --depth_;
    return id;
}

ExpressionId BlockLowering::lower_below(const Node& node) {
    const Span here = span(node);
    switch (kind_of(node)) {
    case Kind::number: return lower_number(text(node), here);
    case Kind::based_number: {
        const auto value = based_number(text(node));
        return value ? literal(*value, here) : unreadable(here);
    }
    case Kind::string: {
        Span inside = here;
        ++inside.begin;
        --inside.end;
        return add({Text{inside}, here});
    }
    case Kind::name:
    case Kind::axis_name: return lower_name(node);
    case Kind::r_parameter: {
        const auto variable = variable_of(node);
        return variable ? add({Load{*variable}, here}) : unreadable(here);
    }
    case Kind::indexed_name:
    case Kind::indexed_address: return lower_indexed(node);
    case Kind::system_variable: return lower_system_variable(node);
    case Kind::parenthesis: {
        const Node* inner = only_child(node); // with a macro behind it there are two
        return inner == nullptr ? nobody_knows(here) : widen(lower_expression(*inner), here);
    }
    case Kind::square_parenthesis: {
        const Node* inner = only_child(node);
        return inner == nullptr ? unreadable(here) : widen(lower_expression(*inner), here);
    }
    case Kind::function_call: return lower_function(node);
    case Kind::unary: return lower_unary(node);
    case Kind::binary:
    case Kind::comparison:
    case Kind::logical:
    case Kind::concatenation:
    case Kind::frame_chain: return lower_binary(node);
    default: return unreadable(here);
    }
}

/// `1.5EX-3`: the exponent has two letters.
ExpressionId BlockLowering::lower_number(std::string_view written, Span here) {
    const auto exponent =
        std::ranges::find_if(written, [](char c) { return c == 'E' || c == 'e'; }) - written.begin();
    const Number number = read_number(written.substr(0, static_cast<std::size_t>(exponent)));
    if (static_cast<std::size_t>(exponent) == written.size())
        return add({Literal{number.value, number.decimal_point}, here});
    const Number power = read_number(written.substr(static_cast<std::size_t>(exponent) + 2));
    constexpr double ten = 10;
    return add({Literal{number.value * std::pow(ten, power.value), true}, here});
}

/// A name that this program does not define is a variable of the machine, an axis or a macro: nobody knows
/// its value.
ExpressionId BlockLowering::lower_name(const Node& node) {
    const std::string name = upper_text(node);
    const Span here = span(node);
    if (const Variable* variable = variable_named(name)) return add({Load{*variable}, here});
    if (name == "TRUE") return literal(1, here);
    if (name == "FALSE") return literal(0, here);
    if (open_->arrays.contains(name)) return nobody_knows(here);
    note_unknown(node, true);
    return changing(name, here);
}

/// An element of an array. Those of arrays are not followed: each may have been written by a calculated
/// index.
ExpressionId BlockLowering::lower_indexed(const Node& node) {
    const Node* index = child(node, Field::index);
    const Node* address = child(node, Field::address);
    if (index == nullptr) return unreadable(span(node));
    if (address != nullptr && upper_text(*address) == "R") return lower_r(*index, span(node));
    lower_index(node, span(node));
    return changing(without_blanks(text(node)), span(node));
}

ExpressionId BlockLowering::lower_r(const Node& index, Span here) {
    const Node* number = only_child(index);
    if (number == nullptr) return nobody_knows(here);
    const ExpressionId value = lower_expression(*number);
    constexpr double most = 32767;
    if (const auto known = literal_value(value); known && *known >= 0 && *known <= most)
        return add({Load{Variable{spaces::r, static_cast<std::int32_t>(std::lround(*known))}}, here});
    return add({LoadAt{families::r, value}, here});
}

ExpressionId BlockLowering::lower_system_variable(const Node& node) {
    const Node* name = child(node, Field::name);
    const Node* index = child(node, Field::index);
    const std::string capitals = name == nullptr ? std::string() : upper_text(*name);
    if (capitals == "$P_SUBPAR") builder_->allow_missing_arguments();
    if (capitals == "$PI") return literal(std::numbers::pi, span(node));
    if (capitals == "$P_GG" && index != nullptr) // the number of the group's member [SV]
        if (const Node* group = only_child(*index))
            if (const auto number = literal_value(lower_expression(*group)))
                if (const auto row = row_of_g_group(whole_number(*number).value_or(0)))
                    return add({LoadModal{*row}, span(node)});
    if (index != nullptr) evaluate_axes(*index, span(node));
    return changing(without_blanks(text(node)), span(node));
}

/// The name makes the number: two reads of one name may be alike.
ExpressionId BlockLowering::changing(std::string_view name, Span here) {
    constexpr std::uint32_t positive = 0x7FFFFFFF;
    const auto number = static_cast<std::int32_t>(TextHash{}(name)&positive);
    return add({LoadMachine{families::system, number}, here});
}

const Variable* BlockLowering::variable_named(std::string_view name) const {
    const auto found = open_->variables.find(name);
    return found == open_->variables.end() ? nullptr : &found->second;
}

/// The variable that the node names, if it names just one. Leading zeros are ignored: R01 is R1 [FUND04
/// p.61].
std::optional<Variable> BlockLowering::variable_of(const Node& node) const {
    const std::string name = without_blanks(text(node));
    switch (kind_of(node)) {
    case Kind::r_parameter:
    case Kind::numbered_address: {
        if (const Variable* declared = variable_named(name)) return *declared; // a parameter of one letter
        if (name.empty() || name.front() != 'R' || name.find('.') != std::string::npos) return std::nullopt;
        const auto number = read_integer(std::string_view(name).substr(1));
        constexpr std::int64_t most = 32767;
        if (!number || *number > most) return std::nullopt;
        return Variable{spaces::r, static_cast<std::int32_t>(*number)};
    }
    case Kind::name:
    case Kind::address:
    case Kind::axis_name: {
        const Variable* declared = variable_named(name);
        return declared == nullptr ? std::nullopt : std::optional(*declared);
    }
    case Kind::system_variable: { // $R[5] of synchronised actions
        const Node* system_name = child(node, Field::name);
        const Node* index = child(node, Field::index);
        if (system_name == nullptr || index == nullptr || !upper_text(*system_name).ends_with("$R"))
            return std::nullopt;
        const Node* number = only_child(*index);
        const auto value = number == nullptr ? std::nullopt : read_integer(text(*number));
        if (!value || kind_of(*number) != Kind::number) return std::nullopt;
        return Variable{spaces::r, static_cast<std::int32_t>(*value)};
    }
    default: return std::nullopt;
    }
}

ExpressionId BlockLowering::lower_all(const Node& list, Span here) {
    std::vector<ExpressionId> values;
    for_each_child(list, [&](const Node& value) { values.push_back(lower_expression(value)); });
    return apply(Operation::unknown, values, here);
}

ExpressionId BlockLowering::lower_unary(const Node& node) {
    const Node* sign = child(node, Field::operation);
    const Node* operand = child(node, Field::operand);
    if (sign == nullptr || operand == nullptr) return unreadable(span(node));
    const ExpressionId value = lower_expression(*operand);
    const std::string word = upper_text(*sign);
    if (word == "-" || word == "+")
        return with_sign(word == "-", value, kind_of(*operand) == Kind::number, span(node));
    const std::array operands{value};
    return apply(word == "NOT" ? Operation::not_of : Operation::unknown, operands, span(node));
}

ExpressionId BlockLowering::lower_binary(const Node& node) {
    const Node* left = child(node, Field::left);
    const Node* right = child(node, Field::right);
    const Node* sign = child(node, Field::operation);
    if (left == nullptr || right == nullptr || sign == nullptr) return unreadable(span(node));
    const std::array operands{lower_expression(*left), lower_expression(*right)};
    // Of DIV and MOD no more is known than that they divide.
    if (const std::string word = upper_text(*sign); word == "DIV" || word == "MOD") {
        const std::array divided{apply(Operation::divide, operands, span(node))};
        return apply(Operation::unknown, divided, span(node));
    }
    const bool frames = kind_of(node) == Kind::frame_chain || kind_of(node) == Kind::concatenation;
    return apply(frames ? Operation::unknown : find(operators, upper_text(*sign)), operands, span(node));
}

ExpressionId BlockLowering::lower_function(const Node& node) {
    const Node* name = child(node, Field::function);
    const Node* list = child(node, Field::arguments);
    if (name == nullptr || list == nullptr) return unreadable(span(node));
    const std::vector<ExpressionId> operands = values_of(list);
    const FunctionRow* row = find_function(upper_text(*name));
    if (row != nullptr)
        check_arguments(*row, span(node), *list);
    else
        note_misspelt_function(*name);
    if (row != nullptr && row->operation != Operation::unknown && operands.size() == row->least &&
        row->least == row->most)
        return apply(row->operation, operands, span(node));
    for (const ExpressionId operand : operands) evaluate(operand, span(node));
    return nobody_knows(span(node));
}

} // namespace maclint::sinumerik
