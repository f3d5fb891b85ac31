//! Names of CONST and VAR, internal constants, and the tests that ask whether they have a value.
#include "analyzer/dialect/characters.hpp"
#include "analyzer/dialect/dinplus/keywords.hpp"
#include "analyzer/dialect/dinplus/lowering.hpp"
#include "analyzer/dialect/dinplus/value_tables.hpp"

#include <algorithm>

namespace maclint::dinplus {

bool BlockLowering::is_defined_here(const Node& name) const {
    const Node* above = parent_of(name);
    if (!open_->declares || above == nullptr) return false;
    const Field field = field_of(name);
    return (kind_of(*above) == Kind::assignment && field == Field::left) ||
           kind_of(*above) == Kind::declaration;
}

bool BlockLowering::is_undeclared(const Node& name) const {
    return open_->knows_all_names && !open_->declares && !open_->declares_something_unreadable &&
           text(name) != "_pi" && open_->alias_of(name_of(name)) == nullptr &&
           !open_->main_declares(name_of(name));
}

/// A definition reads a constant that none before it defines: callers have no names to give.
bool BlockLowering::is_too_early(const Node& name) const {
    return open_->declares && kind_of(name) == Kind::constant && text(name) != "_pi" &&
           open_->alias_of(name_of(name)) == nullptr &&
           open_->builder.program().started != Program::Started::by_call;
}

/// `_depth`, `#_depth`: how it is spelled where it is defined [l.2957, l.19448-19450], and whether it is.
void BlockLowering::check_name(const Node& node) {
    if (is_defined_here(node)) return check_spelling(node);
    const Node* above = parent_of(node);
    if (above == nullptr || kind_of(*above) == Kind::vacancy_test || kind_of(*above) == Kind::double_sharp)
        return;
    if (is_undeclared(node)) return report(SyntaxErrorKind::undeclared_name, span(node), "");
    if (is_too_early(node)) report(SyntaxErrorKind::constant_too_early, span(node), "");
}

void BlockLowering::check_spelling(const Node& node) {
    const std::string_view name = name_of(node).substr(1);
    if (name.size() > limits::name)
        report(SyntaxErrorKind::malformed_name, span(node),
               "it is longer than " + std::to_string(limits::name) + " characters");
    else if (std::ranges::any_of(name, is_capital))
        report(SyntaxErrorKind::malformed_name, span(node), "it holds capitals");
}

void BlockLowering::check_internal_constant(const Node& node) {
    const std::string name = in_small_letters(name_of(node));
    const std::string_view bare =
        std::string_view(name).substr(std::min(name.find_first_not_of('_'), name.size()));
    if (is_internal_constant(bare) && !is_listed_constant(bare))
        report(SyntaxErrorKind::unknown_internal_constant, span(node), "");
}

/// DVDEF asks for internal constants, DEF and NDEF for all others [l.19734-19738].
void BlockLowering::check_vacancy_test(const Node& node) {
    const Node* function = child(node, Field::function);
    const Node* argument = child(node, Field::argument);
    if (function == nullptr || argument == nullptr) return;
    const Kind kind = kind_of(*argument);
    if (kind == Kind::constant) return; // CONST may have given an internal constant a name
    const std::string name = in_small_letters(name_of(*argument));
    const bool internal =
        (kind == Kind::internal_constant || kind == Kind::transfer_variable) &&
        is_internal_constant(std::string_view(name).substr(std::min<std::size_t>(2, name.size())));
    const bool asks_for_internal = upper_text(*function) == "DVDEF";
    if (internal != asks_for_internal)
        report(SyntaxErrorKind::other_vacancy_test, span(node),
               (internal ? "DVDEF(" : "DEF(") + std::string(name_of(*argument)) + ')');
}

} // namespace maclint::dinplus
