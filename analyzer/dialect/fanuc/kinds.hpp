//! The node kinds and fields of the Fanuc grammar as enumerations, so that lowering switches instead of
//! comparing names.
#pragma once

#include "analyzer/syntax/tree.hpp"

#include <array>
#include <cstdint>

namespace maclint::fanuc {

/// The generated grammar.
[[nodiscard]] const TSLanguage* grammar();

/// Named nodes of grammar/fanuc; anonymous ones are `token`.
enum class Kind : std::uint8_t {
    token,
    error,
    file,
    block,
    comment,
    tape_mark,
    skip,
    program_number,
    computed_program_number,
    named_program,
    program_name,
    sequence_number,
    computed_sequence_number,
    literal_word,
    word,
    comma_word,
    empty_word,
    bare_value,
    malformed_word,
    letter_o_word,
    stray_parenthesis,
    block_condition,
    address,
    incremental,
    assignment,
    goto_statement,
    label,
    if_statement,
    while_statement,
    do_statement,
    end_statement,
    output_statement,
    output_text,
    output_variable,
    naming_statement,
    variable_name,
    foreign_keyword,
    condition,
    compound_condition,
    unbracketed_condition,
    variable,
    indirect_variable,
    double_sharp,
    named_variable,
    foreign_variable,
    system_name,
    user_name,
    number,
    bracket,
    call,
    argument_list,
    function,
    unary,
    binary,
    comparison,
    operation,
    symbolic_operator,
};

enum class Field : std::uint8_t {
    none,
    address,
    argument,
    condition,
    consequence,
    divisor,
    format,
    function,
    incremental,
    index,
    left,
    loop,
    name,
    number,
    operand,
    operation,
    right,
    target,
    then,
    value,
    variable,
};

/// The grammar's numbers as kinds and fields, for look-ups that every node of every block goes through.
struct GrammarNumbers {
    std::array<Kind, 1024> kinds; ///< the symbol of an ERROR node is the only one beyond
    std::array<Field, 256> fields;
};
[[nodiscard]] const GrammarNumbers& grammar_numbers();

[[nodiscard]] inline Kind kind_of(const syntax::Node& node) {
    static const GrammarNumbers& numbers = grammar_numbers();
    return node.symbol < numbers.kinds.size() ? numbers.kinds[node.symbol] : Kind::error;
}

/// A comment.
[[nodiscard]] inline bool is_remark(const syntax::Node& node) { return kind_of(node) == Kind::comment; }

/// An address with what belongs to it, or `<NAME>`.
[[nodiscard]] bool is_word(Kind kind);

[[nodiscard]] inline Field field_of(const syntax::Node& node) {
    static const GrammarNumbers& numbers = grammar_numbers();
    return node.field < numbers.fields.size() ? numbers.fields[node.field] : Field::none;
}

} // namespace maclint::fanuc
