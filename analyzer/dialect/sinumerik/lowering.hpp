//! Turns the parse tree of one block into the program model.
#pragma once

#include "analyzer/dialect/sinumerik/functions.hpp"
#include "analyzer/dialect/sinumerik/kinds.hpp"
#include "analyzer/dialect/sinumerik/open_program.hpp"
#include "analyzer/dialect/tree_lowering.hpp"
#include "analyzer/program/model.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::sinumerik {

/// Lowers blocks of programs. What it does not know may do anything: it is a call of an unknown program, or a
/// value of which nothing is known.
class BlockLowering : private TreeLowering {
  public:
    explicit BlockLowering(std::vector<SyntaxError>& syntax_errors)
        : TreeLowering(syntax_errors, is_remark) {}

    /// Adds the block to the program. `block` is where the tree's text stands in the file. The tree must be
    /// free of errors; see diagnose.hpp for the others.
    void lower(const syntax::Tree& tree, Span block, OpenProgram& program);
    /// Adds a block whose text has errors, of which `head` tells what stands at its head.
    void add_unreadable(const Block& head, OpenProgram& program);

  private:
    // ---- the block and its statements (lower.cpp)
    [[nodiscard]] std::span<const Node* const> take_head(Block& block, std::span<const Node* const> items);
    void take_label(Block& block, const Node& node);
    [[nodiscard]] bool ends_foreign_language(Span block) const;
    void lower_foreign();
    void lower_item(const Node& node);
    void lower_statement(const Node& node);
    void mark(const Node& node, RegionKind region_kind, RegionMark::Part part,
              std::optional<ExpressionId> condition);
    void note_first_code(std::span<const Node* const> items);

    // ---- frames and synchronised actions (lower_frames.cpp)
    void lower_frame(std::string_view name, Span here);
    void forget_frames(Span here);
    void watch_frames(std::span<const Node* const> items);
    [[nodiscard]] bool leaves_frame(const Node& item) const;
    void lower_action(const Node& node);
    void check_action_target(const Node& target);
    void watch_distance(std::span<const Node* const> items, const Block& head);
    [[nodiscard]] const Node* without_number(const Node& value) const;
    void check_distance(const Node& word, const Node& value);
    /// `ID=1` in front of an action.
    struct ActionNumber {
        const Node* word;
        double number;
        bool ends_with_program; ///< ID: with the main program; IDS runs on
    };
    /// Nothing where there is none, or its number is calculated.
    [[nodiscard]] std::optional<ActionNumber> action_number(std::span<const Node* const> items) const;
    void check_action_number(const ActionNumber& action);
    [[nodiscard]] bool may_cancel(const Node& item) const;
    void note_actions_left();
    void watch_actions(std::span<const Node* const> items, const Block& head);

    // ---- loops and jumps (lower_flow.cpp)
    void lower_if(const Node& node);
    void lower_for(const Node& node);
    void end_for(const Node& node);
    void lower_case(const Node& node);
    void check_arm(const Node& arm, const Node& value);
    void lower_jump(const Node& node);
    void lower_guarded_jump(ExpressionId condition, const Node& jump, Span whole);
    void restart_on_request(const Node& node);
    void lower_repetition(const Node& node);
    void repeat_part(const Node& node, bool is_one_block);
    [[nodiscard]] ExpressionId jump_target(const Node& node);
    [[nodiscard]] ExpressionId label_named(std::string_view name, Span here);
    [[nodiscard]] ExpressionId nobody_knows(Span here);

    // ---- programs and calls (lower_calls.cpp)
    void lower_program_definition(const Node& node);
    void lower_parameter(const Node& node);
    void save_modes(Span here);
    void go_back(std::optional<ExpressionId> label, Span here);
    void lower_definition(const Node& node);
    void lower_declarator(const Node& node, const Node& type);
    void lower_external(const Node& node);
    void lower_macro_definition(const Node& node);
    bool lower_macro(std::string_view capitals, Span here);
    void give_name(std::string capitals);
    void define_array(const Node& name, const Node& size, std::string_view type);
    void forget_settings_of(std::string_view cycle, Span here);
    void lower_named(const Node& name, const Node* arguments, const Node& whole);
    void lower_procedure(std::string_view name, const Node* arguments, Span whole);
    void call_program(Span name, const Node* arguments, CallKindId kind, Span whole);
    void call_anything(Span whole);
    void lower_modal_call(const Node& node);
    void lower_other_call(const Node& node);
    [[nodiscard]] std::vector<Argument> arguments_of(const Node* list);
    [[nodiscard]] std::vector<ExpressionId> values_of(const Node* list);
    [[nodiscard]] std::string_view type_name(const Node& type) const;

    // ---- misspelt words of the language (lower_slips.cpp)
    bool report_letter_o_in_number(const Node& letter);
    bool report_letter_o(std::string_view capitals, Span here);
    bool report_value_behind_address(std::string_view capitals, bool has_arguments, Span here);
    [[nodiscard]] std::size_t address_without_equals(std::string_view capitals, bool has_arguments) const;
    bool report_slip(std::string_view capitals, Span here);
    void note_misspelt_word(std::string_view capitals, Span here, bool has_arguments);
    void note_misspelt_function(const Node& name);
    bool lower_misspelt_declaration(std::span<const Node* const> items);
    void pass_over_names(Span block, bool of_the_program);
    [[nodiscard]] std::size_t words_in_block() const;

    // ---- words (lower_words.cpp)
    void lower_word(const Node& node);
    void lower_assignment(const Node& node);
    void store(const Node& target, ExpressionId value, Span whole);
    void lower_code(std::string_view name, Span here);
    void set_value(char letter, ExpressionId value, Span here);
    [[nodiscard]] bool takes_words(const Node& item) const;
    void lower_function_of_machine(double number, Span here);
    void set_rounding(std::string_view name, ExpressionId value, Span whole);
    void set_other_feed(std::string_view name, Span whole);
    void set_group_by_number(const Node& index, ExpressionId value, Span whole);
    void evaluate(ExpressionId value, Span here);
    void evaluate_axes(const Node& index, Span here);
    void add_word(std::string_view address, std::optional<ExpressionId> value, Span here);
    bool add_absolute_centre(std::string_view address, const Node& target, Span here);
    void add_motion();

    // ---- expressions (lower_expressions.cpp)
    ExpressionId lower_expression(const Node& node);
    ExpressionId lower_below(const Node& node);
    ExpressionId lower_name(const Node& node);
    ExpressionId lower_number(std::string_view written, Span here);
    ExpressionId lower_indexed(const Node& node);
    ExpressionId lower_system_variable(const Node& node);
    ExpressionId lower_r(const Node& index, Span here);
    ExpressionId lower_unary(const Node& node);
    ExpressionId lower_binary(const Node& node);
    ExpressionId lower_function(const Node& node);
    ExpressionId lower_all(const Node& list, Span here);
    /// A value of which nothing is known, and which may change by itself.
    ExpressionId changing(std::string_view name, Span here);
    [[nodiscard]] const Variable* variable_named(std::string_view name) const;
    [[nodiscard]] std::optional<Variable> variable_of(const Node& node) const;

    // ---- what is wrong with single nodes (lower_checks.cpp)
    void check_tokens();
    void check_token(const Node& node, const Node* parent);
    void words_between_comparisons(const Node& comparison, Nodes& words) const;
    void check_logic(const Node& comparison);
    void check_number(const Node& word);
    void file_wide_colon(const Node& label);
    void report_parentheses(const Node& remark);
    void check_bracketed_value(const Node& command);
    void report_radius_of_another_control(const Node& word, const Node* block);
    void report_missing_equals(const Node& word);
    void report_colon_in_jump(const Node& label);
    void report_quotes(Span here);
    [[nodiscard]] Span keyword_of(const Node& statement) const;
    void check_alone(std::span<const Node* const> items, const Block& head);
    void check_length(std::span<const Node* const> items);
    void check_functions(std::span<const Node* const> items);
    void check_arguments(const FunctionRow& function, Span call, const Node& list);
    void check_types(const FunctionRow& function, const Node& list);
    void check_alarm_number(const Node& arguments);
    void report_expected(Span here, std::string_view expected);
    [[nodiscard]] bool are_arguments(Span parentheses) const;
    void report_with(SyntaxErrorKind kind, Span here, std::string cure, Remedy remedy);

    // ---- names, types and sizes (lower_names.cpp)
    void check_name(const Node& name, std::size_t longest);
    void check_taken(const Node& name);
    void check_system_variable(const Node& node);
    void check_may_be_stored(const Node& system_variable);
    void check_program_name(const Node& name);
    void lower_index(const Node& node, Span whole);
    void check_index(const Node& node, std::span<const ExpressionId> indices);
    [[nodiscard]] const Node* values_listed(const Node& value) const;
    void check_initial_values(const Node& declarator);
    void check_stored_values(const Node& element, const Node& value);
    void check_values_fit(const Node& value, double places, std::string_view where);
    void check_text(const Node& node);
    [[nodiscard]] std::size_t length_of_text(const Node& text_node) const;
    void note_length_of_text(const std::string& variable, const Node& type);
    void check_length_of_text(std::string_view variable, const Node& value);
    void note_unknown(const Node& name, bool is_read);
    void check_operands(const Node& calculation);
    void check_stored(std::string_view type, const Node& value);
    [[nodiscard]] std::string_view type_of_value(const Node& node) const;

    // ---- the tree
    [[nodiscard]] const Node* child(const Node& node, Field field) const;
    [[nodiscard]] const Node* parent_of(const Node& node) const;

    OpenProgram* open_ = nullptr;
    Nodes parents_;                        ///< of each node of the block
    Nodes items_;                          ///< of the block
    std::vector<std::string> case_values_; ///< of the CASE being read
    bool moves_ = false, stays_ = false;   ///< words of axes; a code that takes them for something else
    std::optional<ExpressionId> passes_;   ///< P of a call
    bool names_axes_ = false;              ///< what is read stands where axes are named
};

} // namespace maclint::sinumerik
