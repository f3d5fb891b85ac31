//! Text that is no program of its language.
#pragma once

#include "analyzer/source/span.hpp"

#include <cstdint>
#include <string>

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
    unreadable,                  ///< nothing more exact is known; cure: what was expected
};

struct SyntaxError {
    SyntaxErrorKind kind;
    Span span;
    std::string subject; ///< the offending text, UTF-8
    std::string cure;    ///< what to write instead, in the user's words; may be empty
};

} // namespace maclint
