//! Whether variables and functions exist, and hold and take what is stored and passed.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/dinplus/lowering.hpp"
#include "analyzer/dialect/dinplus/value_tables.hpp"
#include "analyzer/dialect/numbers.hpp"

#include <algorithm>
#include <cmath>

namespace maclint::dinplus {
namespace {

bool is_calculation(Kind kind) {
    return kind == Kind::parenthesis || kind == Kind::binary || kind == Kind::unary ||
           kind == Kind::function_call;
}

} // namespace

void BlockLowering::check_value(const Node& node) {
    check_blanks(node);
    switch (kind_of(node)) {
    case Kind::number: check_figures(node); break;
    case Kind::variable: check_variable(node); break;
    case Kind::selected_variable: check_selector(node); break;
    case Kind::indirect_variable: check_index(node); break;
    case Kind::named_variable:
    case Kind::constant: check_name(node); break;
    case Kind::transfer_variable:
    case Kind::internal_constant: check_internal_constant(node); break;
    case Kind::vacancy_test: check_vacancy_test(node); break;
    case Kind::function_call: check_function(node); break;
    case Kind::binary:
    case Kind::comparison: check_mixture(node); break;
    case Kind::assignment: check_assignment(node); break;
    default: break;
    }
}

/// Variables are written without blanks [l.18890]; around = and + the manual itself has them.
void BlockLowering::check_blanks(const Node& node) {
    switch (kind_of(node)) {
    case Kind::variable:
    case Kind::variable_kind:
    case Kind::named_variable:
    case Kind::transfer_variable: break;
    default: return;
    }
    std::string without(text(node));
    std::erase_if(without, [](char c) { return c == ' ' || c == '\t'; });
    if (without.size() != text(node).size())
        report(SyntaxErrorKind::blank_in_variable, span(node), std::move(without));
}

/// Numbers have at most ten figures before the point and seven behind it [l.18889].
void BlockLowering::check_figures(const Node& number) {
    const std::string_view written = text(number);
    const std::size_t point = std::min(written.find('.'), written.size());
    const std::string_view whole = written.substr(0, point);
    const std::size_t zeros = std::min(whole.find_first_not_of('0'), whole.size());
    const std::size_t decimals = written.size() - std::min(point + 1, written.size());
    if (whole.size() - zeros > limits::whole_figures)
        report(SyntaxErrorKind::number_too_long, span(number),
               std::to_string(limits::whole_figures) + " figures before the point");
    else if (decimals > limits::decimals)
        report(SyntaxErrorKind::number_too_long, span(number),
               std::to_string(limits::decimals) + " figures behind the point");
}

void BlockLowering::check_variable(const Node& node) {
    const auto named = written(node);
    if (!named || !named->number) return;
    if (find_variable(named->letter, *named->number) != nullptr) return;
    std::string known = numbers_of(named->letter);
    if (known.empty()) return report(SyntaxErrorKind::unknown_variable, span(node), "");
    report(SyntaxErrorKind::unknown_variable, span(node), std::move(known));
    if (!knows_all_numbers(named->letter)) syntax_errors_.back().answer = Answer::unknown;
}

/// `#n0(Q)`: no such state. Selectors that are calculated say nothing.
void BlockLowering::check_selector(const Node& node) {
    const auto named = written(node);
    const Node* list = child(node, Field::selectors);
    const Node* selector = list == nullptr ? nullptr : first_child(*list);
    if (!named || !named->number || selector == nullptr) return;
    const bool initial = std::string_view("lcgx").find(named->letter) != std::string_view::npos;
    if (!initial && is_calculation(kind_of(*selector)))
        return report(SyntaxErrorKind::calculated_index, span(node), std::string(text(*selector)));
    if (kind_of(*selector) != Kind::selector && kind_of(*selector) != Kind::number) return;
    constexpr std::string_view placeholder = "SELECT"; // of the manual [l.19105]
    const std::string word = upper_text(*selector);
    const SelectorRow* row = selectors_of(named->letter, *named->number);
    if (row == nullptr || word == placeholder || holds_word(row->selectors, word)) return;
    report(SyntaxErrorKind::unknown_selector, span(node), std::string(row->selectors));
}

/// The number of a variable is a number or another variable, no calculation [l.18891].
void BlockLowering::check_index(const Node& node) {
    const Node* list = child(node, Field::number);
    const Node* index = list == nullptr ? nullptr : only_child(*list);
    if (index == nullptr || !is_calculation(kind_of(*index))) return;
    report(SyntaxErrorKind::calculated_index, span(node), std::string(text(*index)));
}

void BlockLowering::check_function(const Node& node) {
    const Node* name = child(node, Field::function);
    const Node* list = child(node, Field::arguments);
    const FunctionRow* row = name == nullptr ? nullptr : find_function(upper_text(*name));
    if (row == nullptr || list == nullptr) return;
    Nodes arguments;
    for_each_child(*list, [&](const Node& argument) { arguments.push_back(&argument); });
    if (arguments.size() < row->least || arguments.size() > row->most)
        return report(SyntaxErrorKind::argument_count, span(node), arguments_of(*row));
    for (const Node* argument : arguments)
        if (contradict(row->takes, holds(*argument)))
            return report(SyntaxErrorKind::text_in_calculation, span(node), "");
    if (row->name == "BITSET") check_bits(*arguments[0], *arguments[1]);
}

void BlockLowering::check_bits(const Node& bit, const Node& value) {
    const auto lies_in = [&](const Node& node, double last) {
        const auto number = plain_number(node);
        return !number || (*number >= limits::least_bit && *number <= last && *number == std::floor(*number));
    };
    if (!lies_in(bit, limits::last_bit))
        report(SyntaxErrorKind::bit_out_of_range, span(bit), "a bit from 0 to 15");
    else if (!lies_in(value, limits::last_bit_value))
        report(SyntaxErrorKind::bit_out_of_range, span(value), "a number from 0 to 65535");
}

/// Texts are joined by +, and compared with texts; no other operator takes them [l.19020-19027, l.19606].
void BlockLowering::check_mixture(const Node& node) {
    const Node* left = child(node, Field::left);
    const Node* right = child(node, Field::right);
    const Node* sign = child(node, Field::operation);
    if (left == nullptr || right == nullptr || sign == nullptr) return;
    const Holds a = holds(*left), b = holds(*right);
    const bool numbers_only =
        kind_of(node) == Kind::binary && text(*sign) != "+" && (a == Holds::text || b == Holds::text);
    if (numbers_only || contradict(a, b)) report(SyntaxErrorKind::text_in_calculation, span(node), "");
}

void BlockLowering::check_assignment(const Node& node) {
    const Node* left = child(node, Field::left);
    const Node* right = child(node, Field::right);
    if (left == nullptr || right == nullptr || is_defined_here(*left)) return;
    if (kind_of(*left) == Kind::constant) return report(SyntaxErrorKind::constant_stored, span(*left), "");
    check_target(*left);
    const Holds target = holds(*left);
    if (contradict(target, holds(*right))) {
        const auto is_plc = [&](const Node& value) {
            const auto named = written(value);
            return named && named->letter == 'e';
        };
        const bool text_given = target != Holds::text;
        if (is_plc(*left) || is_plc(*right))
            report(SyntaxErrorKind::other_plc_type, span(node), text_given ? "a text" : "a number");
        else
            report(text_given ? SyntaxErrorKind::text_for_number : SyntaxErrorKind::number_for_text,
                   span(node), std::string(text(*left)));
    }
    if (target == Holds::whole) check_whole(*left, *right);
}

/// What something is stored in, by an assignment or by INPUT.
void BlockLowering::check_target(const Node& target) {
    const auto named = written(target);
    if (!named) return;
    const VariableRow* row = find_variable(named->letter, named->number.value_or(1));
    if (row == nullptr) return;
    if (row->access == Access::read_only)
        report(SyntaxErrorKind::read_only_variable, span(target), std::string(row->what));
    if (row->access == Access::reserved)
        report(SyntaxErrorKind::reserved_variable, span(target), std::string(row->what));
}

/// #g200 to #g299 hold whole numbers [l.18958, l.18888].
void BlockLowering::check_whole(const Node& target, const Node& value) {
    const auto number = plain_number(value);
    if (!number) return;
    if (*number != std::floor(*number))
        report(SyntaxErrorKind::fraction_for_integer, span(value), std::string(text(target)));
    else if (*number < limits::least_integer || *number > limits::last_integer)
        report(SyntaxErrorKind::integer_overflow, span(value), std::string(text(target)));
}

} // namespace maclint::dinplus
