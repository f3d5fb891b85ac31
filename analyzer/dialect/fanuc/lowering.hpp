//! Turns the parse tree of one block into the program model.
#pragma once

#include "analyzer/dialect/fanuc/codes.hpp"
#include "analyzer/dialect/fanuc/kinds.hpp"
#include "analyzer/dialect/fanuc/tables_lacking.hpp"
#include "analyzer/dialect/tree_lowering.hpp"
#include "analyzer/program/model.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::fanuc {

/// G65, G66, G66.1 as a word: a macro call.
[[nodiscard]] bool calls_macro(std::string_view word);

/// The number of `#101`; nothing for one with decimals, which names no variable that a program can set.
[[nodiscard]] std::optional<std::int64_t> number_of_variable(std::string_view written);

/// Lowers blocks of programs whose control has the codes.
class BlockLowering : private TreeLowering {
  public:
    BlockLowering(const CodeTable& codes, std::vector<SyntaxError>& syntax_errors)
        : TreeLowering(syntax_errors, is_remark)
        , codes_(codes) {}

    /// Adds the block to the program; one without nodes (comments only) is left out. `block` is
    /// where the tree's text stands in the file. The tree must be free of errors; see diagnose.hpp for the
    /// others.
    void lower(const syntax::Tree& tree, Span block, ProgramBuilder& builder);

    /// After the last block of a program.
    void end_program();

  private:
    // ---- the block and its statements (lower.cpp)
    [[nodiscard]] std::span<const Node* const> take_head(Block& block,
                                                         std::span<const Node* const> items) const;
    [[nodiscard]] bool is_skip_level(const Node& node) const;
    [[nodiscard]] bool goes_on_with(std::span<const Node* const> words, const Node& next) const;
    void lower_items(std::span<const Node* const> items);
    void lower_statement(const Node& node);
    void lower_assignment(const Node& node);
    void lower_goto(const Node& node);
    void lower_if(const Node& node);
    void lower_while(const Node& node, const Node* jump_for_do);
    [[nodiscard]] bool is_jump_for_do(const Node& first, const Node& second) const;
    void lower_loop_mark(const Node& node, RegionMark::Part part);
    [[nodiscard]] std::optional<std::int64_t> loop_number(const Node& mark) const;
    void open_block_if(const Node& node, ExpressionId test);
    void divide_block_if(const Node& keyword);
    [[nodiscard]] bool is_of_block_if(const Node& keyword) const;
    [[nodiscard]] bool is_word_of_block_if(const Node& keyword) const;
    void check_word_of_block_if(const Node& keyword);
    void report_stray_condition(const Node& condition);
    void lower_block_condition(const Node& node, std::span<const Node* const> rest);
    void store(const Node& target, ExpressionId value, Span span);
    void store_numbered(std::int64_t number, Span target, ExpressionId value, Span span);

    // ---- NC words (lower_words.cpp)
    /// A word on its way to its effects.
    struct NcWord {
        char letter; ///< upper case; 0 for a program name
        bool comma;
        const Node* node;
        std::optional<ExpressionId> value;
        std::optional<double> literal;
    };
    void lower_words(std::span<const Node* const> nodes);
    [[nodiscard]] NcWord record_word(const Node& node);
    void lower_macro_call(std::span<const NcWord> words, Span span);
    void lower_usual_words(std::span<const NcWord> words, Span span);
    void lower_possible_call(std::span<const NcWord> words, Span span);
    // ---- codes of the machine's own that call programs (lower_own_codes.cpp)
    /// Those of the control, or those without own calls in a program that is one of the called.
    [[nodiscard]] const CodeTable& codes();
    [[nodiscard]] bool lower_own_macro(std::span<const NcWord> words, Span span);
    void lower_own_subprogram(const NcWord& code, Span span);
    [[nodiscard]] const OwnCode* own_call(const NcWord& word);
    // ---- NC words again
    void lower_machine_function(const NcWord& word, std::span<const NcWord> words, Span span);
    void lower_subprogram_call(CallKindId kind, const NcWord& code, std::span<const NcWord> words, Span span);
    void report_missing_program(const NcWord& code, std::span<const NcWord> words);
    void lower_return(std::optional<ExpressionId> label, Span span);
    void lower_local_call(ExpressionId label, Span span);
    [[nodiscard]] bool holds_repeats(const NcWord& program) const;
    [[nodiscard]] Slice arguments_from(std::span<const NcWord> words);
    void set_local_offset(std::span<const NcWord> words, Span span);

    // ---- expressions (lower_expressions.cpp)
    ExpressionId lower_expression(const Node& node);
    /// `fault`: that of the statement, where its condition is wrong.
    ExpressionId lower_condition(const Node& node, std::string_view fault);
    /// Of a calculation or a comparison.
    struct Sides {
        const Node* left;
        const Node* sign;
        const Node* right;
    };
    [[nodiscard]] Sides sides_of(const Node& node) const;
    ExpressionId lower_binary(const Node& node);
    ExpressionId lower_comparison(const Node& node);
    ExpressionId lower_unary(const Node& node);
    ExpressionId lower_function(const Node& node);
    ExpressionId lower_named(const Node& node);
    ExpressionId load_numbered(std::int64_t number, Span span);
    [[nodiscard]] bool is_logical(ExpressionId id) const;
    [[nodiscard]] Variable named_variable(const Node& node);

    // ---- output and names (lower_outputs.cpp)
    void lower_output(const Node& node);
    void check_format(const Node& printed, bool decimal);
    void check_names(const Node& naming);
    void check_name(const Node& variable);
    void check_digits(const Node& number);
    void check_count(const Node& function, Operation operation);
    void refuse_form(Span span, std::string expected, std::string_view fault);

    // ---- the tree
    [[nodiscard]] const Node* child(const Node& node, Field field) const;

    // ---- what is wrong with single nodes (lower_checks.cpp)
    void check_tokens();
    void report_unreadable(Span span, std::string expected, std::string_view fault);
    void check_words();
    void check_number_of(const Node& variable);
    void check_depth(const Node& node, int depth);
    void check_empty_word(const Node& word);
    void check_letter_o(const Node& word);
    [[nodiscard]] bool holds_if() const;
    [[nodiscard]] std::optional<Span> find_jump_misspelt(Span word) const;
    [[nodiscard]] Span with_rest_of_number(const Node& word) const;
    [[nodiscard]] bool may_be_jump(Span word) const;
    void check_double_sharp(const Node& variable);

    // ---- ways of writing that not every control takes (lower_forms.cpp)
    void refuse(SyntaxErrorKind form, Span span, std::string cure, Remedy remedy = {},
                std::string_view fault = {});
    void check_numbers(std::span<const syntax::Node* const> items);
    void check_block_numbers(std::span<const syntax::Node* const> items);
    void check_row(std::span<const Node* const> items);
    void refuse_number_for_jump(const Node& number);
    void check_consequences(const Node& if_statement, std::span<const Node* const> consequences);
    void check_condition(const Node& condition, std::string_view fault);
    void check_label(const Node& label);
    void check_argument(const Node& function, const Node& argument);
    void check_sign(const Node& operand);
    void check_comparison(const Node& comparison);
    void check_increment(Span address);
    [[nodiscard]] std::optional<Extra> macro_a_of(std::span<const NcWord> words) const;
    void check_lacking(Extra extra, Span span, std::string_view subject);
    void check_function(std::string_view name, std::size_t operands, bool has_divisor, Span span);

    const CodeTable& codes_;
    const CodeTable* codes_in_program_ = nullptr; ///< nullptr: not looked for yet
    /// An IF that has opened blocks and waits for ENDIF.
    struct BlockIf {
        std::optional<std::size_t> refusal; ///< the syntax error that it is on the assumed control
        bool has_else = false;
    };
    std::vector<BlockIf> block_ifs_;
    Nodes items_;               ///< of the block
    std::vector<NcWord> words_; ///< that stand side by side
    std::vector<ExpressionId> computed_;
    std::vector<Argument> arguments_;
    /// Behind its number stands a blank and another one: for a control that passes blanks over they are one
    /// number [1.6, T], and what it is counts as unknown.
    const Node* goes_on_ = nullptr;
    bool depth_reported_ = false;
    bool comparison_reported_ = false;
    bool in_condition_ = false; ///< of IF or WHILE
};

} // namespace maclint::fanuc
