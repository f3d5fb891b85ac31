//! Text that is no program of its language.
#pragma once

#include "analyzer/source/span.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

/// What is wrong with a text before any flow is looked at. Rules of the families 0xx and 1xx report these.
enum class SyntaxErrorKind : std::uint8_t {
    oversized_block, ///< too long to be parsed
    unterminated_comment,
    parenthesis_as_bracket, ///< subject: the word before the '('
    bracket_mismatch,       ///< cure: which bracket is missing and where
    unknown_keyword,        ///< cure: the keyword that was meant, may be empty
    missing_construct,      ///< subject: a word of what the language lacks; cure: what there is instead
    symbolic_comparison,    ///< cure: the operator word
    bracket_depth,          ///< subject: the bracket that opens one level too many
    assignment_to_null,
    loop_without_do,          ///< WHILE condition without DO
    call_without_program,     ///< G65/G66/M98 without P
    not_alone,                ///< subject: the keyword that shares its block with something else
    then_missing,             ///< IF that no THEN follows; subject: the IF
    assignment_in_condition,  ///< `=` in a condition; cure: the condition with `==`
    comparison_as_assignment, ///< `==` where a value is to be stored; cure: the assignment with `=`
    hash_in_vacancy_test,     ///< DEF(#__la): a name with its `#`; cure: the test without
    unknown_transfer_value,   ///< subject: "#__lg"
    nested_comment,           ///< subject: what stands after its first end; cure: what was expected
    bare_remark,              ///< text after a sign that begins a remark elsewhere; cure: the sign in quotes
    point_in_variable_number, ///< `#504.`; cure: the variable without it
    fraction_in_variable_number, ///< `#30003.036`
    letter_o,                    ///< `GO1`: the letter for the figure 0; cure: the word with the figure
    letter_o_or_jump,            ///< `GO5` alone in its block, which may be a GOTO that lacks its TO
    missing_value,               ///< subject: the address without a number
    double_sharp,                ///< `##1`; cure: `#[#1]`
    letter_in_jump,              ///< `GOTO N5`; cure: the number alone
    words_after_jump,            ///< `GOTO5 G0`; subject: what stands after it
    condition_without_brackets,  ///< cure: the condition in [ ]
    condition_alone,             ///< an IF that nothing follows
    consequence_without_then,    ///< `IF[#1EQ2]#3=4`; cure: the consequence as it has to be
    words_after_then,            ///< subject: the words
    more_after_then,             ///< subject: what stands after the one statement
    logic_outside_brackets,      ///< `IF[#1EQ2]AND[#3EQ4]`; cure: the whole in [ ]
    words_beside_statement,      ///< `G90 #1=5`; subject: what stands second
    statement_beside_statement,  ///< `#1=5 #2=6`; subject: what stands second
    jump_beside_statement,       ///< `#1=5 GOTO6`; subject: the jump
    function_without_brackets,   ///< `SIN 30`; cure: with brackets
    comparison_as_value,         ///< `#1=#2 EQ 5`; subject: the comparison
    sign_after_sign,             ///< `#2--#3`; cure: with brackets
    condition_before_return,     ///< `[#1 LT 5] M99 P10`
    wide_sign,                   ///< subject: a character that looks like a sign; cure: the sign
    foreign_remark,              ///< `(text)`, `; text`; cure: the remark as the language has it
    small_letters,               ///< `g1`; cure: the word in capitals
    unknown_variable,            ///< `#l100`; cure: which there are
    read_only_variable,          ///< something is stored in it; cure: what it holds
    reserved_variable,           ///< something is stored in it; cure: for whom it is kept
    text_for_number,             ///< subject: the text; cure: what holds numbers
    number_for_text,             ///< subject: the number; cure: what holds texts
    text_in_calculation,         ///< `"a"*2`; cure: the operator or function that takes numbers
    other_plc_type,              ///< `#l1=#e2("Name")`; cure: what the operand holds
    fraction_for_integer,        ///< subject: the value; cure: the variable that holds whole numbers
    integer_overflow,            ///< subject: the value; cure: the variable that holds whole numbers
    malformed_name,              ///< of a constant or variable; cure: what is wrong with it
    constant_too_early,          ///< read by a definition that stands before its own
    constant_stored,             ///< subject: the constant that something is stored in
    undeclared_name,             ///< subject: the name
    calculated_index,            ///< `#g(#l1+1)`; cure: the calculation
    unknown_selector,            ///< `#w0(XX)`; cure: which there are
    unknown_internal_constant,   ///< `__n0_q`
    other_vacancy_test,          ///< `DVDEF(__la)`; cure: the test that asks for it
    argument_count,              ///< subject: the function; cure: how many arguments it takes
    bit_out_of_range,            ///< subject: the argument of BITSET; cure: what it may be
    window_out_of_range,         ///< subject: the lines of a WINDOW
    input_into_no_variable,      ///< subject: what stands in the place of the variable
    too_many_conditions,         ///< subject: the condition; cure: how many there are
    selection_of_calculation,    ///< `SWITCH #l1+1`; subject: the calculation
    unknown_call_word,           ///< subject: a word of a call that passes nothing
    too_many_arguments,          ///< subject: the first one too many; cure: how many there may be
    repeat_count,                ///< subject: the word; cure: what it may be
    number_for_block,            ///< subject: a word whose number is no block; cure: what it may be
    long_program_name,           ///< subject: the name; cure: how many characters it may have
    description_unbalanced,      ///< `[//]` that lacks the other one
    wrong_description,           ///< subject: of a transfer value; cure: what is wrong with it
    doubled_alias,               ///< subject: a name for a variable that has one; cure: the other name
    group_unbalanced,            ///< BLOCKSTART or BLOCKEND that lacks the other one
    section_of_other_language,   ///< subject: the word; cure: the one of the other sections' language
    slide_not_in_head,           ///< subject: a block's slides; cure: those of the program head
    blank_in_variable,           ///< `# l1`; cure: without it
    number_too_long,             ///< subject: the number; cure: how many figures there may be
    no_condition,                ///< `IF #l1`; subject: what stands in its place
    converted_leftover,          ///< subject: a remark that a converter left in the place of a block
    missing_equals,              ///< `Z-DEPTH`; subject: the address; cure: the word with its `=`
    remark_without_sign,         ///< text that is no block; cure: the sign that begins a remark
    colon_in_jump,               ///< `GOTOF END:`; cure: the label alone
    second_block,                ///< subject: a block number behind words
    head_at_structure,           ///< subject: a label or skip mark in front of a loop or branch
    foreign_keyword,             ///< `THEN`; cure: how the language writes it
    taken_name,                  ///< of a variable; cure: what has it already
    text_too_long,               ///< subject: the text; cure: how many characters there may be
    malformed_case,              ///< a table of jumps; cure: what is missing
    split_declaration,           ///< PROC or DEF that goes on in the next block
    late_definition,             ///< behind the first block that does something; cure: that block
    unknown_system_variable,     ///< cure: one that is meant, may be empty
    wrong_dimensions,            ///< subject: the variable with its index; cure: how many it has
    too_many_initial_values,     ///< subject: the list; cure: how many places there are
    empty_counting,              ///< `FOR R1=5 TO 1`
    value_twice,                 ///< of a table of jumps; cure: where it stands first
    mark_missing,                ///< of a part to be repeated; subject: the label; cure: one behind it
    passes_out_of_range,         ///< of a part to be repeated; cure: what they may be
    action_on_local,             ///< subject: a variable that acts at preparation; cure: what acts in time
    action_again,                ///< subject: the number of an action that runs already; cure: that one
    action_left,                 ///< subject: the number of an action that a subprogram leaves at work
    alarm_number,                ///< subject: of an alarm that the program raises; cure: what it may be
    block_too_long,       ///< subject: what stands behind its last character; cure: how many there may be
    too_many_functions,   ///< subject: the first one too many of a block; cure: how many there may be
    action_number,        ///< subject: the number of an action; cure: what it may be
    other_program_name,   ///< subject: the name in the text; cure: that of the file
    ambiguous_jump,       ///< its label stands on both sides; cure: the line of the one that is taken
    frame_lost,           ///< subject: a frame that the next one deletes; cure: that one
    position_as_distance, ///< subject: a word; cure: the position that was read
    unreadable,           ///< nothing more exact is known; cure: what was expected
};

/// What is known of how the control answers a syntax error.
enum class Answer : std::uint8_t {
    stops,
    stops_if_assumed, ///< nobody named the control: the one that is assumed stops, another one does not
    unknown,          ///< no document tells
};

/// Replace the bytes of `span` by `text`.
struct TextChange {
    Span span;
    std::string_view text; ///< ASCII, of static lifetime
};

/// What takes the syntax error out of the text.
struct Remedy {
    std::string_view title; ///< an instruction without its full stop
    bool certain = true;    ///< nothing else can have been meant
    std::vector<TextChange> changes = {};
};

/// What exactly the control stops at, where it numbers several alarms for one kind: Alarm::of names these.
namespace faults {
constexpr std::string_view two_signs = "two-signs", two_points = "two-points", character = "character",
                           no_address = "no-address", no_program_number = "no-program-number",
                           number_misplaced = "number-misplaced", no_equals = "no-equals",
                           no_comma = "no-comma", expression = "expression",
                           opening_bracket = "opening-bracket", closing_bracket = "closing-bracket",
                           real_time = "real-time", keyword = "keyword", operation = "operation",
                           statement = "statement";
}

struct SyntaxError {
    SyntaxErrorKind kind;
    Span span;
    std::string subject; ///< the offending text, UTF-8
    std::string cure;    ///< what to write instead, in the user's words; may be empty
    Answer answer = Answer::stops;
    std::string elsewhere = {}; ///< `stops_if_assumed`: names of the controls that take it
    Remedy remedy = {};
    std::string_view fault = {}; ///< one of `faults`; empty: nothing more exact is known
};

} // namespace maclint
