//! Turns the parse tree of one block into the program model.
#pragma once

#include "analyzer/dialect/dinplus/kinds.hpp"
#include "analyzer/dialect/dinplus/open_program.hpp"
#include "analyzer/dialect/dinplus/tables.hpp"
#include "analyzer/dialect/dinplus/value_tables.hpp"
#include "analyzer/dialect/tree_lowering.hpp"
#include "analyzer/program/model.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint::dinplus {

/// Lowers blocks of programs.
class BlockLowering : private TreeLowering {
  public:
    explicit BlockLowering(std::vector<SyntaxError>& syntax_errors)
        : TreeLowering(syntax_errors, is_remark) {}

    /// Adds the block to the program. `block` is where the tree's text stands in the file. The tree
    /// must be free of errors; see diagnose.hpp for the others.
    void lower(const syntax::Tree& tree, Span block, OpenProgram& program);
    /// Adds a block whose text has errors, of which `head` tells what stands at its head.
    void add_unreadable(const Block& head, OpenProgram& program);
    /// The same for one that returns to the caller, as far as it can be read.
    void add_unreadable_return(const Block& head, OpenProgram& program);

  private:
    // ---- the block and its statements (lower.cpp)
    static void add_names_in(Span block, OpenProgram& program);
    [[nodiscard]] std::span<const Node* const> take_head(Block& block,
                                                         std::span<const Node* const> items) const;
    void lower_items(std::span<const Node* const> items);
    void lower_statement(const Node& node);
    void lower_assignment(const Node& node);
    bool declare_alias(const Node& name, const Node& value);
    void declare(const Node& name);
    void check_alias(const Node& name, Variable variable);
    void initialise(const Node& variable, Span span);
    void store(const Node& target, ExpressionId value, Span span);
    void store_elsewhere(const Node& target, ExpressionId value, Span span);
    void lower_region_mark(const Node& node, RegionKind region_kind, RegionMark::Part part,
                           std::optional<ExpressionId> condition);
    void lower_case(const Node& node);
    void lower_call(const Node& node);
    void lower_output(const Node& node);
    void lower_unknown(const Node& node);
    void evaluate(ExpressionId value, Span span);
    void check_alone(std::span<const Node* const> items);
    void check_then(std::span<const Node* const> items);
    void check_tokens();
    void check_token(const Node& node);
    void check_sign(const Node& node);
    void check_number(const Node& word);
    void check_depth();

    // ---- forms that are none of the language (lower_forms.cpp)
    void check_form(const Node& node);
    void check_comparison(const Node& node);
    void check_capitals(const Node& node);

    // ---- what values hold (lower_types.cpp)
    /// A variable as it is written; without a number where another variable gives it.
    struct Written {
        char letter;
        std::optional<std::int64_t> number;
    };
    [[nodiscard]] std::optional<Written> written(const Node& place) const;
    [[nodiscard]] Holds holds(const Node& value) const;
    [[nodiscard]] Holds variable_holds(const Node& place) const;
    [[nodiscard]] Holds name_holds(const Node& name) const;
    [[nodiscard]] Holds sum_holds(const Node& binary) const;
    [[nodiscard]] std::string_view name_of(const Node& name) const;
    [[nodiscard]] std::optional<double> plain_number(const Node& value) const;

    // ---- names (lower_names.cpp)
    [[nodiscard]] bool is_defined_here(const Node& name) const;
    [[nodiscard]] bool is_undeclared(const Node& name) const;
    [[nodiscard]] bool is_too_early(const Node& name) const;
    void check_name(const Node& node);
    void check_spelling(const Node& node);
    void check_internal_constant(const Node& node);
    void check_vacancy_test(const Node& node);

    // ---- what variables and functions hold and take (lower_values.cpp)
    void check_value(const Node& node);
    void check_variable(const Node& node);
    void check_blanks(const Node& node);
    void check_figures(const Node& number);
    void check_selector(const Node& node);
    void check_index(const Node& node);
    void check_function(const Node& node);
    void check_bits(const Node& bit, const Node& value);
    void check_mixture(const Node& node);
    void check_assignment(const Node& node);
    void check_target(const Node& target);
    void check_whole(const Node& target, const Node& value);

    // ---- what statements may hold (lower_limits.cpp)
    void check_statement(const Node& node);
    void check_conditions(const Node& statement);
    void check_selection(const Node& statement);
    void check_output(const Node& statement);
    void check_input(const Node& statement, const Nodes& arguments);
    void check_window(const Node& statement, const Nodes& arguments);
    void check_call(const Node& call);
    void check_argument(const Node& word, std::string_view address);
    void check_group(const Node& node);

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
    [[nodiscard]] std::optional<double> number_of_word(const Node& node) const;
    void lower_words(std::span<const Node* const> nodes);
    void lower_commands(std::span<const NcWord> words, Span span);
    void lower_code(const NcWord& code, std::span<const NcWord> words);
    void set_by_word(GroupId group, const CodeFact& fact, const NcWord& code, std::span<const NcWord> words);
    void lower_machine_function(std::uint16_t traits, const NcWord& code, std::span<const NcWord> words);

    // ---- expressions (lower_expressions.cpp)
    ExpressionId lower_expression(const Node& node);
    ExpressionId lower_below(const Node& node);
    ExpressionId lower_variable(const Node& variable, const Node& whole);
    ExpressionId lower_indirect(const Node& node);
    [[nodiscard]] std::vector<ExpressionId> lower_selectors(const Node& list);
    ExpressionId load_selected(FamilyId family, std::int32_t number, std::span<const ExpressionId> computed,
                               Span span);
    ExpressionId lower_transfer(const Node& node);
    ExpressionId lower_internal(std::string_view name, Span span);
    ExpressionId lower_constant(const Node& node);
    ExpressionId lower_unary(const Node& node);
    ExpressionId lower_binary(const Node& node);
    ExpressionId lower_function(const Node& node);
    ExpressionId lower_vacancy_test(const Node& node);

    /// What `#l1` names: a variable, or the row and number that the control owns.
    struct Numbered {
        FamilyId family;
        std::int32_t number;
        std::optional<Variable> variable;
    };
    [[nodiscard]] std::optional<Numbered> numbered(const Node& variable) const;
    [[nodiscard]] Variable named_variable(const Node& node, SpaceId space);
    [[nodiscard]] std::optional<Variable> variable_of(const Node& node);

    // ---- the tree
    [[nodiscard]] const Node* child(const Node& node, Field field) const;
    [[nodiscard]] const Node* parent_of(const Node& node) const;
    [[nodiscard]] Span characters(const Node& text) const;

    OpenProgram* open_ = nullptr;
    Nodes parents_;             ///< of each node of the block
    Nodes items_;               ///< of the block
    std::vector<NcWord> words_; ///< that stand side by side
    std::vector<ExpressionId> computed_;
};

} // namespace maclint::dinplus
