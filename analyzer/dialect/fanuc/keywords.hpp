//! Keywords, functions and operators, and what somebody meant who wrote another word.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace maclint::fanuc {

/// IF, GOTO, SIN, EQ ...: what may stand between or instead of address letters.
[[nodiscard]] bool is_keyword(std::string_view capitals);
[[nodiscard]] bool is_function(std::string_view capitals);
/// EQ, AND, MOD ...
[[nodiscard]] bool is_operator_word(std::string_view capitals);

/// EQ for `=`, GE for `>=`; empty for what is no sign of a comparison in any language.
[[nodiscard]] std::string_view comparison_word(std::string_view sign);

/// The keywords that a row of capitals consists of; empty when it does not consist of keywords alone, or is a
/// word of another language.
[[nodiscard]] std::vector<std::string_view> split_keywords(std::string_view capitals);

/// [4: there is no ELSE]
constexpr std::string_view in_place_of_block_if = "THEN takes one statement in its own block, and there is "
                                                  "no ELSE or ENDIF. To skip several blocks, let IF "
                                                  "and GOTO jump over them";

/// ENDIF, RETURN, GTE: what other languages have, or people expect.
[[nodiscard]] bool is_word_elsewhere(std::string_view capitals);

/// Whether a word, of capitals and bytes that are not ASCII, is one that no control could mean: three letters
/// or more that are no keywords, as in remarks.
[[nodiscard]] bool is_for_people(std::string_view capitals);

/// Letters that can only be a GOTO with one left out or doubled: `GTO`, and `GOT` behind an IF. Elsewhere
/// `GOT0101` may be G0 T0101 with the letter for the figure.
[[nodiscard]] bool is_misspelt_goto(std::string_view capitals, bool behind_if);

/// What somebody meant who wrote a word that is none.
struct Misspelling {
    bool known;        ///< a word of other languages, or close to a keyword
    std::string meant; ///< may be empty
    std::string_view
        advice; ///< a sentence without its full stop where the language has no such word; may be empty
};
[[nodiscard]] Misspelling explain(std::string_view capitals);

} // namespace maclint::fanuc
