//! Keywords, and what is written for one by a slip.
#pragma once

#include <string_view>

namespace maclint::sinumerik {

/// Words that open, divide or close a part of a program.
[[nodiscard]] bool is_structural(std::string_view capitals);

/// The word that closes a loop or a branch, one slip away from this one; empty: none is. Any name may be a
/// program: only one that stands alone in its block can be meant for a keyword.
[[nodiscard]] std::string_view closer_meant_by(std::string_view capitals);
/// The word that opens a loop or a branch, likewise, at the head of a block that cannot be read.
[[nodiscard]] std::string_view opener_meant_by(std::string_view capitals);
/// Of these words one that stands alone in its block: ELSE, LOOP, REPEAT.
[[nodiscard]] std::string_view bare_opener_meant_by(std::string_view capitals);
/// DO1, END1 of other controls.
[[nodiscard]] bool is_foreign_loop_word(std::string_view capitals);
/// The word of a jump, likewise; it has a label behind it.
[[nodiscard]] std::string_view jump_meant_by(std::string_view capitals);

/// Of variables [NCP19 p.409].
inline constexpr std::string_view type_names[] = {"REAL", "INT", "BOOL", "CHAR", "STRING", "AXIS", "FRAME"};

/// DEF, PROC or EXTERN, judged by the word behind it too; PROC only where nothing was done before.
[[nodiscard]] std::string_view declaration_meant_by(std::string_view capitals, std::string_view behind,
                                                    bool at_the_begin);
/// A procedure, a code of several letters, MCALL or CALL. A name beside other words can be no program.
[[nodiscard]] std::string_view command_meant_by(std::string_view capitals, bool may_be_program);
/// A function, where a name has arguments in a calculation: ISNUMER(NAME).
[[nodiscard]] std::string_view function_meant_by(std::string_view capitals);
/// TRUE or FALSE, where a name stands for a value.
[[nodiscard]] std::string_view value_meant_by(std::string_view capitals);
/// A cycle of the same number: CYCEL81.
[[nodiscard]] std::string_view cycle_meant_by(std::string_view capitals);

} // namespace maclint::sinumerik
