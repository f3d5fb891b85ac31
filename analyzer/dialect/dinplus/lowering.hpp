//! Turns the parse tree of one block into the program model.
#pragma once

#include "analyzer/dialect/dinplus/kinds.hpp"
#include "analyzer/dialect/dinplus/tables.hpp"
#include "analyzer/program/model.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint::dinplus {

/// What the blocks before tell about a block of the same program.
struct Surroundings {
    Context context = Context::machining;
    bool effects = true;   ///< the section does something: it is no list for the operator
    bool declares = false; ///< the section is VAR or CONST
    std::vector<std::pair<std::string, Place>> aliases; ///< VAR: `#_depth=#l1`
    std::vector<ExpressionId> selections;               ///< values of the open SWITCHes
    std::optional<Span> waiting_if;                     ///< an IF whose THEN has not come
};

/// Lowers one block of a program. The tree must be free of errors; see diagnose.hpp for the others.
class BlockLowering {
  public:
    /// `block` is where the tree's text stands in the file.
    BlockLowering(const syntax::Tree& tree, Span block, Program& program, Surroundings& surroundings,
                  std::vector<Irregularity>& irregularities);

    /// Appends the block to the program's items.
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
    bool declare_alias(const Node& name, const Node& value, Effects& effects);
    void initialise(const Node& variable, Span span, Effects& effects);
    void store(const Node& target, ExpressionId value, Span span, Effects& effects);
    void lower_structure(const Node& node, Construct construct, Structure::Part part,
                         std::optional<ExpressionId> condition, Effects& effects);
    void lower_case(const Node& node, Effects& effects);
    void lower_call(const Node& node, Effects& effects);
    void lower_output(const Node& node, Effects& effects);
    void lower_unknown(const Node& node, Effects& effects);
    void evaluate(ExpressionId value, Span span, Effects& effects);
    void check_alone(std::span<const Node* const> items);
    void check_then(std::span<const Node* const> items);
    void check_tokens();
    void check_depth();

    // ---- words (lower_words.cpp)
    /// A word on its way to its effects.
    struct NcWord {
        std::string_view address;
        const Node* node;
        std::optional<ExpressionId> value;
        std::optional<double> literal;
    };
    [[nodiscard]] NcWord record_word(const Node& node);
    [[nodiscard]] std::string_view address_of(const Node& node) const;
    void lower_words(std::span<const Node* const> nodes, Effects& effects);
    void lower_commands(std::span<const NcWord> words, Span span, Effects& effects);
    void lower_code(const NcWord& code, std::span<const NcWord> words, Effects& effects);
    void set_by_word(GroupId group, const CodeFact& fact, const NcWord& code, std::span<const NcWord> words,
                     Effects& effects);
    void lower_machine_function(std::uint16_t traits, const NcWord& code, std::span<const NcWord> words,
                                Effects& effects);

    // ---- expressions (lower_expressions.cpp)
    ExpressionId lower_expression(const Node& node);
    ExpressionId lower_below(const Node& node);
    ExpressionId lower_variable(const Node& variable, const Node& whole);
    ExpressionId lower_indirect(const Node& node);
    ExpressionId lower_transfer(const Node& node);
    ExpressionId lower_internal(std::string_view name, Span span);
    ExpressionId lower_constant(const Node& node);
    ExpressionId lower_text(const Node& node);
    ExpressionId lower_unary(const Node& node);
    ExpressionId lower_binary(const Node& node);
    ExpressionId lower_comparison(const Node& node);
    ExpressionId lower_function(const Node& node);
    ExpressionId lower_vacancy_test(const Node& node);
    ExpressionId apply(Operation operation, std::span<const ExpressionId> operands, Span span);
    ExpressionId literal(double value, Span span);
    ExpressionId add(Expression expression);
    ExpressionId unreadable(Span span);

    /// What `#l1` names: a place, or the row and number that the control owns.
    struct Numbered {
        FamilyId family;
        std::int32_t number;
        std::optional<Place> place;
    };
    [[nodiscard]] std::optional<Numbered> numbered(const Node& variable) const;
    [[nodiscard]] Place named_place(const Node& node, SpaceId space);
    [[nodiscard]] const Place* alias_of(std::string_view name) const;
    [[nodiscard]] std::optional<Place> place_of(const Node& node);

    // ---- the tree
    [[nodiscard]] const Node* child(const Node& node, Field field) const;
    [[nodiscard]] Nodes children(const Node& node) const;
    [[nodiscard]] Nodes named_children(const Node& node) const;
    [[nodiscard]] std::string_view text(const Node& node) const;
    [[nodiscard]] std::string upper_text(const Node& node) const;
    [[nodiscard]] Span span(const Node& node) const;
    [[nodiscard]] Span characters(const Node& text) const;

    void report(Irregular kind, Span span, std::string cure);

    const syntax::Tree& tree_;
    Span block_;
    Program& program_;
    Surroundings& around_;
    std::vector<Irregularity>& irregularities_;
    int depth_ = 0; ///< of the expression being lowered
};

} // namespace maclint::dinplus
