//! Lowering of expressions, conditions and variables.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/dinplus/keywords.hpp"
#include "analyzer/dialect/dinplus/lowering.hpp"
#include "analyzer/dialect/numbers.hpp"

#include <algorithm>
#include <array>
#include <iterator>

namespace maclint::dinplus {
namespace {

struct OperationRow {
    std::string_view name;
    Operation operation;
};

// Functions, operators and comparisons: l.18895-18918, l.19673-19683. SQRTA, SQRTS, BITSET, STRING, PARA and
// TIME have no model.
// clang-format off
constexpr OperationRow functions[] = {
    {"SIN", Operation::sine},      {"COS", Operation::cosine},        {"TAN", Operation::tangent},
    {"ASIN", Operation::arc_sine}, {"ACOS", Operation::arc_cosine},   {"ATAN", Operation::arc_tangent},
    {"ABS", Operation::absolute},  {"ROUND", Operation::round},       {"INT", Operation::truncate},
    {"SQRT", Operation::square_root}, {"LOGN", Operation::logarithm}, {"EXP", Operation::exponential},
};

constexpr OperationRow operators[] = {
    {"+", Operation::add},       {"-", Operation::subtract},    {"*", Operation::multiply}, {"/", Operation::divide},
    {"AND", Operation::all_of},  {"OR", Operation::any_of},
    {"==", Operation::equal},    {"=", Operation::equal},       {"<>", Operation::not_equal},
    {"<", Operation::less},      {"<=", Operation::less_equal}, {">", Operation::greater},  {">=", Operation::greater_equal},
    // of other languages
    {"EQ", Operation::equal},    {"NE", Operation::not_equal},  {"!=", Operation::not_equal}, {"><", Operation::not_equal},
    {"LT", Operation::less},     {"LE", Operation::less_equal}, {"=<", Operation::less_equal},
    {"GT", Operation::greater},  {"GE", Operation::greater_equal}, {"=>", Operation::greater_equal},
};
// clang-format on

constexpr double pi = 3.1415926535989; // as the control has it, l.19529

Operation find(std::span<const OperationRow> rows, std::string_view name) {
    const auto row = std::ranges::find(rows, name, &OperationRow::name);
    return row == rows.end() ? Operation::unknown : row->operation;
}

/// The name after `#`, blanks and underscores.
std::string_view bare_name(std::string_view name) {
    const std::size_t begin = name.find_first_not_of("# \t_");
    return begin == std::string_view::npos ? std::string_view{} : name.substr(begin);
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
    switch (kind_of(node)) {
    case Kind::number: return number(text(node), span(node));
    case Kind::literal_word: { // the head of an extended word: X100+_sd
        const std::string_view written = text(node);
        const std::size_t digits = std::min(written.find_first_of("+-.0123456789"), written.size());
        const Span whole = span(node);
        return number(written.substr(digits), {whole.begin + static_cast<Offset>(digits), whole.end});
    }
    case Kind::string:
    case Kind::unclosed_string:
    case Kind::typographic_string: return add({Text{characters(node)}, span(node)});
    case Kind::variable: return lower_variable(node, node);
    case Kind::selected_variable:
        if (const Node* variable = child(node, Field::variable)) return lower_variable(*variable, node);
        return unreadable(span(node));
    case Kind::indirect_variable: return lower_indirect(node);
    case Kind::named_variable:
    case Kind::transfer_variable:
    case Kind::constant:
    case Kind::internal_constant: return lower_constant(node);
    case Kind::double_sharp:
        if (const Node* variable = child(node, Field::variable)) return lower_expression(*variable);
        return unreadable(span(node));
    case Kind::parenthesis: {
        const Node* inner = only_child(node);
        return inner == nullptr ? unreadable(span(node)) : widen(lower_expression(*inner), span(node));
    }
    case Kind::function_call: return lower_function(node);
    case Kind::vacancy_test: return lower_vacancy_test(node);
    case Kind::unary: return lower_unary(node);
    case Kind::binary:
    case Kind::comparison:
    case Kind::logical: return lower_binary(node);
    default: return unreadable(span(node));
    }
}

std::optional<BlockLowering::Numbered> BlockLowering::numbered(const Node& variable) const {
    std::string_view name = text(variable);
    name.remove_prefix(std::min(name.find_first_not_of("# \t"), name.size()));
    if (name.empty()) return std::nullopt;
    const std::optional<FamilyId> family = family_of(name.front());
    const std::optional<std::int64_t> number = read_integer(name.substr(1));
    constexpr std::int64_t most = 999'999;
    if (!family || !number || *number > most) return std::nullopt;
    const auto n = static_cast<std::int32_t>(*number);
    const VariableRange* range = program_->control->families[*family].find(n);
    if (range == nullptr) return std::nullopt;
    Numbered result{*family, n, std::nullopt};
    if (range->meaning == Meaning::variable) result.variable = Variable{range->space, n};
    return result;
}

/// `whole` is the variable with its selectors.
ExpressionId BlockLowering::lower_variable(const Node& variable, const Node& whole) {
    const std::optional<Numbered> found = numbered(variable);
    if (!found) return unreadable(span(whole));
    if (found->variable) return add({Load{*found->variable}, span(whole)});
    const Node* list = child(whole, Field::selectors);
    if (list == nullptr) return add({LoadMachine{found->family, found->number}, span(whole)});
    if (const Node* selector = first_child(*list); selector != nullptr && found->family == families::n)
        if (const auto group = group_read(found->number, upper_text(*selector)))
            return add({LoadModal{*group}, span(whole)});
    return load_selected(found->family, found->number, lower_selectors(*list), span(whole));
}

/// What the selectors of a variable compute: `#l7` of `#w0(#l7)`. Letters, numbers and texts compute nothing.
std::vector<ExpressionId> BlockLowering::lower_selectors(const Node& list) {
    std::vector<ExpressionId> computed;
    for_each_child(list, [&](const Node& selector) {
        const Kind kind = kind_of(selector);
        if (kind != Kind::selector && kind != Kind::number && kind != Kind::string)
            computed.push_back(lower_expression(selector));
    });
    return computed;
}

/// A value of the control whose number is known, or one of many that computed selectors pick.
ExpressionId BlockLowering::load_selected(FamilyId family, std::int32_t number,
                                          std::span<const ExpressionId> computed, Span span) {
    if (computed.empty()) return add({LoadMachine{family, number}, span});
    const ExpressionId index = apply(Operation::unknown, computed, span);
    return add({LoadAt{family, index}, span});
}

/// `#g(#c2)`, `#m(#l1)(Z)`; tool data by name have the same shape: `#t(3,"001")`.
ExpressionId BlockLowering::lower_indirect(const Node& node) {
    const Node* kind = child(node, Field::kind);
    const Node* number = child(node, Field::number);
    if (kind == nullptr || number == nullptr || text(*kind).empty()) return unreadable(span(node));
    const std::optional<FamilyId> family = family_of(text(*kind).back());
    if (!family || first_child(*number) == nullptr) return unreadable(span(node));
    std::vector<ExpressionId> computed;
    if (const Node* list = child(node, Field::selectors)) computed = lower_selectors(*list);
    const Node* index = only_child(*number);
    if (index != nullptr && computed.empty())
        return add({LoadAt{*family, lower_expression(*index)}, span(node)});
    std::ranges::copy(lower_selectors(*number), std::back_inserter(computed));
    return load_selected(*family, 0, computed, span(node));
}

/// A name is known by what stands after `#`, `_` included.
Variable BlockLowering::named_variable(const Node& node, SpaceId space) {
    std::string_view written = text(node);
    written.remove_prefix(std::min(written.find_first_not_of("# \t"), written.size()));
    if (const Variable* alias = open_->alias_of(written)) return *alias;
    return {space, builder_->number_of_name(space, written)};
}

/// What is written like a constant or a named variable: `_sd`, `#_depth`, `__la`, `#__la`.
ExpressionId BlockLowering::lower_constant(const Node& node) {
    switch (kind_of(node)) {
    case Kind::transfer_variable:
    case Kind::internal_constant: return lower_transfer(node);
    case Kind::constant:
        if (text(node) == "_pi") return literal(pi, span(node));
        if (is_undeclared(node) || is_too_early(node)) return unreadable(span(node)); // told already
        return add({Load{named_variable(node, spaces::constant)}, span(node)});
    default:
        if (is_undeclared(node)) return unreadable(span(node));
        return add({Load{named_variable(node, spaces::named)}, span(node)});
    }
}

ExpressionId BlockLowering::lower_transfer(const Node& node) {
    const std::string_view name = bare_name(text(node));
    if (const std::optional<Variable> variable = transfer_variable(name))
        return add({Load{*variable}, span(node)});
    if (is_internal_constant(name)) return lower_internal(name, span(node));
    report(SyntaxErrorKind::unknown_transfer_value, span(node), "");
    return unreadable(span(node));
}

/// `n40_g`: the state that `#n40(G)` reads.
ExpressionId BlockLowering::lower_internal(std::string_view name, Span span) {
    const std::size_t line = name.find('_');
    const std::optional<std::int64_t> number = read_integer(name.substr(0, line));
    if (number && *number <= INT16_MAX)
        if (const auto group =
                group_read(static_cast<std::int32_t>(*number), in_capitals(name.substr(line + 1))))
            return add({LoadModal{*group}, span});
    return unreadable(span);
}

ExpressionId BlockLowering::lower_unary(const Node& node) {
    const Node* sign = child(node, Field::operation);
    const Node* operand = child(node, Field::operand);
    if (sign == nullptr || operand == nullptr) return unreadable(span(node));
    const ExpressionId value = lower_expression(*operand);
    return with_sign(text(*sign) != "+", value, kind_of(*operand) == Kind::number, span(node));
}

ExpressionId BlockLowering::lower_binary(const Node& node) {
    const Node* left = child(node, Field::left);
    const Node* right = child(node, Field::right);
    const Node* sign = child(node, Field::operation);
    if (left == nullptr || right == nullptr || sign == nullptr) return unreadable(span(node));
    const std::array operands{lower_expression(*left), lower_expression(*right)};
    return apply(find(operators, upper_text(*sign)), operands, span(node));
}

ExpressionId BlockLowering::lower_function(const Node& node) {
    const Node* name = child(node, Field::function);
    const Node* arguments = child(node, Field::arguments);
    if (name == nullptr || arguments == nullptr) return unreadable(span(node));
    std::vector<ExpressionId> operands;
    for_each_child(*arguments, [&](const Node& operand) { operands.push_back(lower_expression(operand)); });
    const Operation operation =
        operands.size() == 1 ? find(functions, upper_text(*name)) : Operation::unknown;
    return apply(operation, operands, span(node));
}

/// `DEF(__la)`: a name stands without its `#` [l.19732]; `DEF(_depth)` asks for `#_depth` of VAR or for
/// `_depth` of CONST. A variable that has no name keeps it: `NDEF(#l1)` [l.22299].
ExpressionId BlockLowering::lower_vacancy_test(const Node& node) {
    const Node* function = child(node, Field::function);
    const Node* argument = child(node, Field::argument);
    if (function == nullptr || argument == nullptr) return unreadable(span(node));
    const std::string name = upper_text(*function);
    const Kind kind = kind_of(*argument);
    if (kind == Kind::named_variable || kind == Kind::transfer_variable) {
        std::string_view written = text(*argument);
        written.remove_prefix(std::min(written.find_first_not_of("# \t"), written.size()));
        report(SyntaxErrorKind::hash_in_vacancy_test, span(node), name + '(' + std::string(written) + ')');
    }
    const std::array operands{lower_expression(*argument)};
    Operation operation = Operation::unknown; // DVDEF asks for an internal constant
    if (name == "DEF") operation = Operation::is_set;
    if (name == "NDEF") operation = Operation::is_vacant;
    return apply(operation, operands, span(node));
}

} // namespace maclint::dinplus
