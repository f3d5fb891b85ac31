//! What a value holds, as far as the text tells: a number, a text.
#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/dinplus/lowering.hpp"
#include "analyzer/dialect/dinplus/value_tables.hpp"
#include "analyzer/dialect/numbers.hpp"

#include <algorithm>

namespace maclint::dinplus {

/// The letter of a variable and its number, as they are written.
std::optional<BlockLowering::Written> BlockLowering::written(const Node& place) const {
    switch (kind_of(place)) {
    case Kind::selected_variable: {
        const Node* variable = child(place, Field::variable);
        return variable == nullptr ? std::nullopt : written(*variable);
    }
    case Kind::indirect_variable: {
        const Node* kind = child(place, Field::kind);
        if (kind == nullptr || text(*kind).empty()) return std::nullopt;
        return Written{in_small_letters(text(*kind)).back(), std::nullopt};
    }
    case Kind::variable: {
        const std::string_view name = text(place);
        const std::size_t letter = name.find_first_not_of("# \t");
        if (letter == std::string_view::npos) return std::nullopt;
        return Written{in_small_letters(name)[letter], read_integer(name.substr(letter + 1))};
    }
    default: return std::nullopt;
    }
}

Holds BlockLowering::holds(const Node& value) const {
    switch (kind_of(value)) {
    case Kind::number:
    case Kind::literal_word:
    case Kind::unary: return Holds::number;
    case Kind::string:
    case Kind::unclosed_string:
    case Kind::typographic_string: return Holds::text;
    case Kind::variable:
    case Kind::selected_variable:
    case Kind::indirect_variable: return variable_holds(value);
    case Kind::named_variable:
    case Kind::constant: return name_holds(value);
    case Kind::transfer_variable: {
        const std::string name = in_small_letters(text(value));
        const bool is_text = name.ends_with("__id") || name.ends_with("__at") || name.ends_with("__id1") ||
                             name.ends_with("__at1"); // l.19940, l.8544
        return is_text ? Holds::text : Holds::number;
    }
    case Kind::parenthesis: {
        const Node* inner = only_child(value);
        return inner == nullptr ? Holds::either : holds(*inner);
    }
    case Kind::function_call: {
        const Node* name = child(value, Field::function);
        const FunctionRow* row = name == nullptr ? nullptr : find_function(upper_text(*name));
        return row == nullptr ? Holds::either : row->gives;
    }
    case Kind::binary: return sum_holds(value);
    default: return Holds::either;
    }
}

Holds BlockLowering::variable_holds(const Node& place) const {
    const auto named = written(place);
    if (!named) return Holds::either;
    if (!named->number) return named->letter == 'x' ? Holds::text : Holds::either;
    const VariableRow* row = find_variable(named->letter, *named->number);
    const Node* list = child(place, Field::selectors);
    const Node* selector = list == nullptr ? nullptr : first_child(*list);
    if (named->letter == 'w' && selector != nullptr && upper_text(*selector) == "ID") return Holds::text;
    if (row == nullptr) return named->letter == 'x' ? Holds::text : Holds::either;
    return row->holds;
}

/// VAR says which variable a name stands for; what a constant is, its definition tells, which is gone.
Holds BlockLowering::name_holds(const Node& name) const {
    const Variable* alias = open_->alias_of(name_of(name));
    if (text(name) == "_pi") return Holds::number;
    if (alias == nullptr || alias->space == spaces::named || alias->space == spaces::constant)
        return Holds::either;
    return alias->space == spaces::local_text ? Holds::text : Holds::number;
}

Holds BlockLowering::sum_holds(const Node& binary) const {
    const Node* left = child(binary, Field::left);
    const Node* right = child(binary, Field::right);
    if (left == nullptr || right == nullptr) return Holds::either;
    const Holds a = holds(*left), b = holds(*right);
    if (a == Holds::either || b == Holds::either || contradict(a, b)) return Holds::either;
    return a == Holds::text ? Holds::text : Holds::number;
}

/// A name without its `#`.
std::string_view BlockLowering::name_of(const Node& name) const {
    std::string_view written = text(name);
    written.remove_prefix(std::min(written.find_first_not_of("# \t"), written.size()));
    return written;
}

std::optional<double> BlockLowering::plain_number(const Node& value) const {
    if (kind_of(value) == Kind::number) return read_number(text(value)).value;
    if (kind_of(value) != Kind::unary) return std::nullopt;
    const Node* operand = child(value, Field::operand);
    const Node* sign = child(value, Field::operation);
    if (operand == nullptr || sign == nullptr || kind_of(*operand) != Kind::number) return std::nullopt;
    const double number = read_number(text(*operand)).value;
    return text(*sign) == "-" ? -number : number;
}

} // namespace maclint::dinplus
