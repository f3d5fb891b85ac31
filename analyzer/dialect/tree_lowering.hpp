//! What the lowering of a block has in common in all dialects: its tree, its expressions, its effects.
#pragma once

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

/// Base of a dialect's lowering. One object lowers block after block: its lists keep their memory.
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

    /// From now on `tree` is lowered, whose text is `block` of the file, into `program`. All must stay until
    /// end_block().
    void begin_block(const syntax::Tree& tree, Span block, Program& program);
    /// Hands effects and words since begin_block() over to the program.
    void end_block(Block block);

    // ---- expressions
    ExpressionId add(Expression expression);
    ExpressionId literal(double value, Span span);
    /// The number that the text is.
    ExpressionId number(std::string_view text, Span span);
    ExpressionId unreadable(Span span);
    ExpressionId apply(Operation operation, std::span<const ExpressionId> operands, Span span);
    /// A sign in front of a value: `-5` is a number; `span` is that of both.
    ExpressionId with_sign(bool minus, ExpressionId value, bool is_number, Span span);
    /// The number that the expression is; empty when it has to be calculated.
    [[nodiscard]] std::optional<double> value_of_literal(ExpressionId id) const;
    /// Gives an expression the span of what stands around it.
    ExpressionId widen(ExpressionId id, Span span);

    // ---- effects
    void effect(Effect effect) { effects_.push_back(std::move(effect)); }
    /// Puts the effects from place `first` on under a condition.
    void guard(ExpressionId condition, std::size_t first, Span span);

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
    Program* program_ = nullptr;
    std::vector<SyntaxError>& syntax_errors_;
    std::vector<Effect> effects_; ///< of the block, so far
    int depth_ = 0;               ///< of the expression being lowered

  private:
    bool (*is_remark_)(const Node&);
    Id first_word_ = 0;
};

} // namespace maclint
