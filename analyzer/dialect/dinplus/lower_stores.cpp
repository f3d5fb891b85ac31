//! Lowering of assignments, and of the names that VAR and CONST declare.
#include "analyzer/dialect/dinplus/lowering.hpp"
#include "analyzer/program/overloaded.hpp"

#include <algorithm>

namespace maclint::dinplus {

void BlockLowering::lower_assignment(const Node& node) {
    const Node* left = child(node, Field::left);
    const Node* right = child(node, Field::right);
    if (left == nullptr || right == nullptr) return;
    if (open_->declares && declare_alias(*left, *right)) return;
    const ExpressionId value = lower_expression(*right);
    store(*left, value, span(node));
}

/// VAR and CONST: `#_depth=#l1` is another name for `#l1`, `#_depth=#l1(5)` stores 5 in it, too; anything
/// else is a value of the name's own. All are known in the programs called from here [l.19484-19491].
bool BlockLowering::declare_alias(const Node& name, const Node& value) {
    const Kind kind = kind_of(name);
    if (kind != Kind::named_variable && kind != Kind::constant) return false;
    std::string_view written = text(name);
    written.remove_prefix(std::min(written.find_first_not_of("# \t"), written.size()));
    const bool writable = kind == Kind::named_variable;
    const Variable own = named_variable(name, writable ? spaces::named : spaces::constant);
    builder_->hand_down(own);
    std::optional<Variable> variable;
    if (writable && kind_of(value) == Kind::variable) {
        if (const auto found = numbered(value)) variable = found->variable;
    } else if (writable && kind_of(value) == Kind::selected_variable) {
        if (const Node* inner = child(value, Field::variable))
            if (const auto found = numbered(*inner)) variable = found->variable;
        if (variable) initialise(value, span(value));
    }
    if (variable) {
        check_alias(name, *variable);
        builder_->add_alias(own, *variable);
    }
    if (open_->alias_of(written) == nullptr) open_->aliases.emplace(written, variable.value_or(own));
    return variable.has_value();
}

/// A name alone in VAR or CONST: it is known from here on.
void BlockLowering::declare(const Node& name) {
    const Kind kind = kind_of(name);
    if (!open_->declares || (kind != Kind::named_variable && kind != Kind::constant)) return;
    const SpaceId space = kind == Kind::named_variable ? spaces::named : spaces::constant;
    open_->aliases.emplace(name_of(name), named_variable(name, space));
}

/// Two names for one variable: who stores by the one changes the other.
void BlockLowering::check_alias(const Node& name, Variable variable) {
    const auto [first, is_new] = open_->first_names.emplace(variable, name_of(name));
    if (!is_new && first->second != name_of(name))
        report(SyntaxErrorKind::doubled_alias, span(name), '#' + std::string(first->second));
}

/// `#l1(200)` stores 200 in a local variable, which the programs called from here see, too [l.18947,
/// l.18979].
void BlockLowering::initialise(const Node& variable, Span span) {
    if (kind_of(variable) != Kind::selected_variable) return;
    const Node* name = child(variable, Field::variable);
    const Node* list = child(variable, Field::selectors);
    const std::optional<Numbered> found = name == nullptr ? std::nullopt : numbered(*name);
    if (!found || !found->variable || list == nullptr) return;
    const Node* value = only_child(*list);
    if (value == nullptr) return;
    effect({Assign{*found->variable, lower_expression(*value)}, span});
    builder_->hand_down(*found->variable);
}

void BlockLowering::store(const Node& target, ExpressionId value, Span span) {
    if (const std::optional<Variable> variable = variable_of(target))
        effect({Assign{*variable, value}, span});
    else
        store_elsewhere(target, value, span);
}

/// Stores where no single variable is named: in `#g(#c2)`, in a value of the control.
void BlockLowering::store_elsewhere(const Node& target, ExpressionId value, Span span) {
    switch (kind_of(target)) {
    case Kind::variable:
    case Kind::selected_variable:
    case Kind::indirect_variable: {
        const Expression read = expression(lower_expression(target));
        std::visit(overloaded{
                       [&](const Load& load) {
                           effect({Assign{load.variable, value}, span});
                       },
                       [&](const LoadAt& at) {
                           effect({Assign{StoreAt{at.family, at.index}, value}, span});
                       },
                       [&](const LoadMachine& owned) {
                           effect({Assign{StoreMachine{owned.family, owned.number}, value}, span});
                       },
                       [&](const auto&) { evaluate(value, span); },
                   },
                   read.node);
        return;
    }
    case Kind::double_sharp:
        if (const Node* variable = child(target, Field::variable)) store(*variable, value, span);
        return;
    default: evaluate(value, span); return;
    }
}

/// The variable of the model that the node names, if it names just one.
std::optional<Variable> BlockLowering::variable_of(const Node& node) {
    switch (kind_of(node)) {
    case Kind::variable: {
        const auto found = numbered(node);
        return found ? found->variable : std::nullopt;
    }
    case Kind::named_variable: return named_variable(node, spaces::named);
    case Kind::constant: return named_variable(node, spaces::constant);
    case Kind::transfer_variable:
    case Kind::internal_constant: {
        const ExpressionId id = lower_transfer(node);
        const auto* load = std::get_if<Load>(&expression(id).node);
        return load == nullptr ? std::nullopt : std::optional(load->variable);
    }
    default: return std::nullopt;
    }
}

} // namespace maclint::dinplus
