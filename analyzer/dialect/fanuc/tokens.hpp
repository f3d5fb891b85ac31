//! The pieces of a block's text without any structure: what is left to look at when the parser gives up.
#pragma once

#include "analyzer/source/span.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::fanuc {

struct Token {
    enum class Kind : std::uint8_t {
        letters, ///< letters in a row: keywords, functions, addresses
        number,
        variable, ///< `#101`
        sharp,    ///< `#` alone, or before a bracket or a name
        open,
        close,
        comment,
        equals,
        comparison, ///< `<`, `>=`, `==` ...
        sign,       ///< `+`, `-`
        operation,  ///< `*`, `/`
        comma,
        other,
    };
    Kind kind;
    Span span; ///< in the file
};

/// Cuts the block at `block` in `file`.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view file, Span block);

/// IF, GOTO, SIN, EQ ...: what may stand between or instead of address letters.
[[nodiscard]] bool is_keyword(std::string_view capitals);
[[nodiscard]] bool is_function(std::string_view capitals);
/// EQ, AND, MOD ...
[[nodiscard]] bool is_operator_word(std::string_view capitals);

/// EQ for `=`, GE for `>=`; empty for what is no sign of a comparison in any language.
[[nodiscard]] std::string_view comparison_word(std::string_view sign);

/// The keywords that a row of capitals consists of; empty when it does not consist of keywords alone.
[[nodiscard]] std::vector<std::string_view> split_keywords(std::string_view capitals);

/// What somebody meant who wrote a word that is none.
struct Misspelling {
    bool known;        ///< a word of other languages, or close to a keyword
    std::string meant; ///< may be empty
    std::string_view
        advice; ///< a sentence without its full stop where the language has no such word; may be empty
};
[[nodiscard]] Misspelling explain(std::string_view capitals);

} // namespace maclint::fanuc
