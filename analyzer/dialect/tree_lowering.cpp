//! The part of lowering that knows no dialect.
#include "analyzer/dialect/tree_lowering.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/numbers.hpp"

#include <array>
#include <iterator>

namespace maclint {

void TreeLowering::begin_block(const syntax::Tree& tree, Span block, Program& program) {
    tree_ = &tree;
    block_ = block;
    program_ = &program;
    first_word_ = static_cast<Id>(program.words.size());
    effects_.clear();
    depth_ = 0;
}

void TreeLowering::end_block(Block block) {
    block.span = block_;
    block.words = {first_word_, static_cast<Id>(program_->words.size()) - first_word_};
    block.effects = {static_cast<Id>(program_->effects.size()), static_cast<Id>(effects_.size())};
    program_->effects.insert(program_->effects.end(), std::move_iterator(effects_.begin()),
                             std::move_iterator(effects_.end()));
    program_->items.emplace_back(block);
}

ExpressionId TreeLowering::add(Expression expression) {
    program_->expressions.push_back(expression);
    return static_cast<ExpressionId>(program_->expressions.size() - 1);
}

ExpressionId TreeLowering::literal(double value, Span span) { return add({Literal{value, false}, span}); }

ExpressionId TreeLowering::number(std::string_view text, Span span) {
    const Number number = read_number(text);
    return add({Literal{number.value, number.decimal_point}, span});
}

ExpressionId TreeLowering::unreadable(Span span) { return add({Unreadable{}, span}); }

ExpressionId TreeLowering::apply(Operation operation, std::span<const ExpressionId> operands, Span span) {
    const Slice slice{static_cast<Id>(program_->operands.size()), static_cast<Id>(operands.size())};
    program_->operands.insert(program_->operands.end(), operands.begin(), operands.end());
    return add({Apply{operation, slice}, span});
}

ExpressionId TreeLowering::with_sign(bool minus, ExpressionId value, bool is_number, Span span) {
    if (!minus) return widen(value, span);
    auto* number = std::get_if<Literal>(&program_->expressions[value].node);
    if (number != nullptr && is_number) {
        if (number->value != 0) number->value = -number->value;
        return widen(value, span);
    }
    const std::array operands{value};
    return apply(Operation::negate, operands, span);
}

std::optional<double> TreeLowering::value_of_literal(ExpressionId id) const {
    const auto* literal = std::get_if<Literal>(&program_->expressions[id].node);
    return literal == nullptr ? std::nullopt : std::optional(literal->value);
}

ExpressionId TreeLowering::widen(ExpressionId id, Span span) {
    program_->expressions[id].span = span;
    return id;
}

void TreeLowering::guard(ExpressionId condition, std::size_t first, Span span) {
    const auto begin = effects_.begin() + static_cast<std::ptrdiff_t>(first);
    const Slice slice{static_cast<Id>(program_->effects.size()), static_cast<Id>(effects_.end() - begin)};
    program_->effects.insert(program_->effects.end(), std::move_iterator(begin),
                             std::move_iterator(effects_.end()));
    effects_.erase(begin, effects_.end());
    effect({Guarded{condition, slice}, span});
}

const syntax::Node* TreeLowering::first_child(const Node& node) const {
    const Node* first = nullptr;
    for_each_child(node, [&](const Node& child) {
        if (first == nullptr) first = &child;
    });
    return first;
}

const syntax::Node* TreeLowering::only_child(const Node& node) const {
    const Node* only = nullptr;
    bool several = false;
    for_each_child(node, [&](const Node& child) {
        several = only != nullptr;
        only = &child;
    });
    return several ? nullptr : only;
}

std::string TreeLowering::upper_text(const Node& node) const { return in_capitals(text(node)); }

void TreeLowering::report(SyntaxErrorKind kind, Span span, std::string cure) {
    syntax_errors_.push_back({kind, span, std::string(program_->slice(span)), std::move(cure)});
}

} // namespace maclint
