//! What the lowering of a block has in common in all dialects: its tree, its expressions, its effects.
#pragma once

#include "analyzer/program/builder.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/syntax/tree.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint {

/// Base of a dialect's lowering. One object lowers block after block; what comes out of it goes to the
/// builder of the program.
class TreeLowering {
  public:
    TreeLowering(const TreeLowering&) = delete;
    TreeLowering& operator=(const TreeLowering&) = delete;

  protected:
    using Node = syntax::Node;
    using Nodes = std::vector<const Node*>;

    /// Deeper expressions than any control accepts; what lies below is not read.
    static constexpr int deepest = 200;

    /// Nodes for which `is_remark` says so are no children: comments.
    TreeLowering(std::vector<SyntaxError>& syntax_errors, bool (*is_remark)(const Node&))
        : syntax_errors_(syntax_errors)
        , is_remark_(is_remark) {}
    ~TreeLowering() = default;

    /// From now on `tree` is lowered, whose text is `block` of the file, into a program. All must stay until
    /// end_block().
    void begin_block(const syntax::Tree& tree, Span block, ProgramBuilder& builder);
    /// `block` has all but its span, words and effects.
    void end_block(Block block);

    // ---- expressions
    ExpressionId add(Expression expression) { return builder_->add(expression); }
    ExpressionId literal(double value, Span span) { return builder_->literal(value, span); }
    /// The number that the text is.
    ExpressionId number(std::string_view text, Span span);
    ExpressionId unreadable(Span span) { return builder_->unreadable(span); }
    ExpressionId apply(Operation operation, std::span<const ExpressionId> operands, Span span) {
        return builder_->apply(operation, operands, span);
    }
    /// A sign in front of a value: `-5` is a number; `span` is that of both.
    ExpressionId with_sign(bool minus, ExpressionId value, bool is_number, Span span);
    ExpressionId widen(ExpressionId id, Span span) { return builder_->widen(id, span); }
    [[nodiscard]] const Expression& expression(ExpressionId id) const { return builder_->expression(id); }
    [[nodiscard]] std::optional<double> literal_value(ExpressionId id) const {
        return builder_->literal_value(id);
    }
    /// A word's value: a literal number, or the expression.
    [[nodiscard]] decltype(Word::value) written_value(std::optional<ExpressionId> id) const;

    // ---- effects
    void effect(const Effect& effect) { builder_->add_effect(effect); }
    void guard(ExpressionId condition, std::size_t first, Span span) {
        builder_->guard(condition, first, span);
    }

    // ---- the tree
    [[nodiscard]] Span span(const Node& node) const {
        return {block_.begin + node.span.begin, block_.begin + node.span.end};
    }
    [[nodiscard]] std::string_view text(const Node& node) const { return program_->slice(span(node)); }
    [[nodiscard]] std::string upper_text(const Node& node) const;
    template<class Visit>
    void for_each_below(const Node& node, const Visit& visit) const {
        for (syntax::NodeIndex i = node.first_child; i != syntax::no_node; i = tree_->nodes[i].next_sibling)
            visit(tree_->nodes[i]);
    }

    /// Named children; remarks are left out.
    template<class Visit>
    void for_each_child(const Node& node, const Visit& visit) const {
        for_each_below(node, [&](const Node& below) {
            if (below.named && !is_remark_(below)) visit(below);
        });
    }
    [[nodiscard]] const Node* first_child(const Node& node) const;
    /// The child of a node that has no other.
    [[nodiscard]] const Node* only_child(const Node& node) const;

    void report(SyntaxErrorKind kind, Span span, std::string cure);

    const syntax::Tree* tree_ = nullptr;
    Span block_;
    ProgramBuilder* builder_ = nullptr;
    const Program* program_ = nullptr; ///< what the builder has written so far
    std::vector<SyntaxError>& syntax_errors_;
    int depth_ = 0; ///< of the expression being lowered

  private:
    bool (*is_remark_)(const Node&);
};

} // namespace maclint
