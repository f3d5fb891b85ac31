//! Turns the parse tree of one block into the program model.
#pragma once

#include "analyzer/dialect/fanuc/codes.hpp"
#include "analyzer/dialect/fanuc/kinds.hpp"
#include "analyzer/program/model.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::fanuc {

/// Lowers one block of a program. The tree must be free of errors; see diagnose.hpp for the others.
class BlockLowering {
  public:
    /// `block` is where the tree's text stands in the file; `codes` are those of the program's control.
    BlockLowering(const syntax::Tree& tree, Span block, const CodeTable& codes, Program& program,
                  std::vector<Irregularity>& irregularities);

    /// Appends the block to the program's items; a block without nodes (comments only) is left out.
    void lower();

  private:
    using Node = syntax::Node;
    using Nodes = std::vector<const Node*>;
    using Effects = std::vector<Effect>;

    // ---- the block and its statements (lower.cpp)
    void take_head(Block& block, Nodes& items) const;
    void lower_items(std::span<const Node* const> items, Effects& effects);
    void lower_statement(const Node& node, Effects& effects);
    void lower_assignment(const Node& node, Effects& effects);
    void lower_goto(const Node& node, Effects& effects);
    void lower_if(const Node& node, Effects& effects);
    void lower_while(const Node& node, Effects& effects);
    void lower_loop_mark(const Node& node, Structure::Part part, Effects& effects);
    void lower_output(const Node& node, Effects& effects);
    void store(const Node& target, ExpressionId value, Span span, Effects& effects);
    void store_numbered(std::int64_t number, Span target, ExpressionId value, Span span, Effects& effects);
    [[nodiscard]] Effect guarded(ExpressionId condition, Effects inner, Span span);

    // ---- NC words (lower_words.cpp)
    /// A word on its way to its effects.
    struct NcWord {
        char letter; ///< upper case; 0 for a program name
        bool comma;
        Id word; ///< in Program::words, or none for a program name
        const Node* node;
        std::optional<ExpressionId> value;
        std::optional<double> literal;
    };
    void lower_words(std::span<const Node* const> nodes, Effects& effects);
    [[nodiscard]] NcWord record_word(const Node& node);
    void lower_macro_call(std::span<const NcWord> words, Span span, Effects& effects);
    void lower_usual_words(std::span<const NcWord> words, Span span, Effects& effects);
    void lower_machine_function(const NcWord& word, std::span<const NcWord> words, Span span,
                                Effects& effects);
    void lower_subprogram_call(CallKindId kind, const NcWord& code, std::span<const NcWord> words, Span span,
                               Effects& effects);
    void lower_local_call(ExpressionId label, Span span, Effects& effects);
    [[nodiscard]] bool holds_repeats(const NcWord& program) const;
    [[nodiscard]] Slice arguments_from(std::span<const NcWord> words);
    void set_local_offset(std::span<const NcWord> words, Span span, Effects& effects);

    // ---- expressions (lower_expressions.cpp)
    ExpressionId lower_expression(const Node& node);
    ExpressionId lower_condition(const Node& node);
    ExpressionId lower_binary(const Node& node);
    ExpressionId lower_comparison(const Node& node);
    ExpressionId lower_unary(const Node& node);
    ExpressionId lower_function(const Node& node);
    ExpressionId lower_named(const Node& node);
    ExpressionId load_numbered(std::int64_t number, Span span);
    ExpressionId apply(Operation operation, std::span<const ExpressionId> operands, Span span);
    ExpressionId literal(double value, Span span);
    ExpressionId add(Expression expression);
    ExpressionId unreadable(Span span);
    [[nodiscard]] bool is_logical(ExpressionId id) const;
    [[nodiscard]] Place named_place(const Node& node);

    // ---- the tree
    [[nodiscard]] const Node* child(const Node& node, Field field) const;
    /// Named children; comments are left out.
    template<class Visit>
    void for_each_child(const Node& node, const Visit& visit) const {
        for (syntax::NodeIndex i = node.first_child; i != syntax::no_node; i = tree_.nodes[i].next_sibling)
            if (tree_.nodes[i].named && kind_of(tree_.nodes[i]) != Kind::comment) visit(tree_.nodes[i]);
    }
    [[nodiscard]] Nodes children(const Node& node) const;
    /// The child of a node that has no other.
    [[nodiscard]] const Node* only_child(const Node& node) const;
    [[nodiscard]] std::string_view text(const Node& node) const;
    [[nodiscard]] std::string upper_text(const Node& node) const;
    [[nodiscard]] Span span(const Node& node) const;

    // ---- what is wrong with it
    void report(Irregular kind, Span span, std::string cure);
    void check_tokens();
    void check_words();
    void check_depth(const Node& node, int depth);
    void check_parenthesis_for_value();

    const syntax::Tree& tree_;
    Span block_;
    Program& program_;
    const CodeTable& codes_;
    std::vector<Irregularity>& irregularities_;
    int depth_ = 0; ///< of the expression being lowered
    bool depth_reported_ = false;
};

} // namespace maclint::fanuc
