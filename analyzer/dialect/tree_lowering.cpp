//! The part of lowering that knows no dialect.
#include "analyzer/dialect/tree_lowering.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/numbers.hpp"

#include <array>

namespace maclint {

void TreeLowering::begin_block(const syntax::Tree& tree, Span block, ProgramBuilder& builder) {
    tree_ = &tree;
    block_ = block;
    builder_ = &builder;
    program_ = &builder.program();
    depth_ = 0;
    builder.begin_block();
}

void TreeLowering::end_block(Block block) {
    block.span = block_;
    builder_->end_block(block);
}

ExpressionId TreeLowering::number(std::string_view text, Span span) {
    const Number number = read_number(text);
    return add({Literal{number.value, number.decimal_point}, span});
}

ExpressionId TreeLowering::with_sign(bool minus, ExpressionId value, bool is_number, Span span) {
    if (!minus) return widen(value, span);
    if (is_number && literal_value(value)) return builder_->negate_literal(value, span);
    const std::array operands{value};
    return apply(Operation::negate, operands, span);
}

decltype(Word::value) TreeLowering::written_value(std::optional<ExpressionId> id) const {
    if (!id) return std::monostate{};
    if (const auto* literal = std::get_if<Literal>(&expression(*id).node)) return *literal;
    return *id;
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
