//! The node kinds and fields of the DIN PLUS grammar as enumerations, so that lowering switches instead of
//! comparing names.
#pragma once

#include "analyzer/syntax/tree.hpp"

#include <cstdint>

namespace maclint::dinplus {

/// The generated grammar.
[[nodiscard]] const TSLanguage* grammar();

/// Named nodes of grammar/dinplus; anonymous ones are `token`.
enum class Kind : std::uint8_t {
    token,
    error,
    file,
    program_name_line,
    header_entry,
    section,
    section_name,
    axis,
    block,
    comment,
    description_mark,
    unclosed_comment,
    foreign_comment,
    slide,
    skip,
    block_number,
    computed_block_number,
    literal_word,
    word,
    extended_word,
    empty_word,
    malformed_word,
    letter_o_word,
    lower_case_word,
    bare_value,
    stray_parenthesis,
    stray_bracket,
    address,
    incremental,
    assignment,
    equality_sign,
    declaration,
    call,
    if_statement,
    then_statement,
    else_statement,
    endif_statement,
    while_statement,
    endwhile_statement,
    switch_statement,
    case_statement,
    default_statement,
    break_statement,
    endswitch_statement,
    return_statement,
    output_statement,
    unit_start,
    unit_end,
    group_start,
    group_end,
    unknown_statement,
    unknown_keyword,
    number,
    string,
    unclosed_string,
    typographic_string,
    parenthesis,
    function_call,
    function,
    unknown_function,
    argument_list,
    vacancy_test,
    unary,
    binary,
    comparison,
    logical,
    operation,
    assignment_sign,
    foreign_operator,
    unknown_coordinate,
    variable,
    selected_variable,
    indirect_variable,
    variable_kind,
    selector_list,
    selector,
    named_variable,
    transfer_variable,
    constant,
    internal_constant,
    double_sharp,
    foreign_variable,
};

enum class Field : std::uint8_t {
    none,
    address,
    argument,
    arguments,
    axis,
    check,
    condition,
    function,
    incremental,
    keyword,
    kind,
    left,
    name,
    number,
    operand,
    operation,
    parameter,
    place,
    right,
    selectors,
    value,
    variable,
    version,
};

/// Address and value, or what was meant as such.
[[nodiscard]] bool is_word(Kind kind);
/// A comment, however it is written.
[[nodiscard]] bool is_remark(const syntax::Node& node);
/// Slides, skip marks and block numbers, which stand before what a block does.
[[nodiscard]] bool is_head(Kind kind);

[[nodiscard]] Kind kind_of(const syntax::Node& node);
[[nodiscard]] Field field_of(const syntax::Node& node);

} // namespace maclint::dinplus
