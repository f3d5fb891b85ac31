//! The lexer of the Fanuc family: classes of bytes, comments, tokens. Whatever looks at the text of a block
//! looks through it: splitter, diagnosis, parse cache, plausibility, the search for a lathe's words.
#pragma once

#include "analyzer/dialect/characters.hpp"
#include "analyzer/source/span.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::fanuc {

constexpr bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; }
/// NUL is blank tape.
constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\0'; }
constexpr bool is_line_break(char c) { return c == '\n' || c == '\r'; }
constexpr bool ends_block(char c) { return c == ';' || is_line_break(c); }

/// After the comment that opens at `open`: after its ')', or at its line's end where that is missing.
[[nodiscard]] Offset after_comment(std::string_view text, Offset open);
/// Whether a comment that after_comment() found has its ')'.
[[nodiscard]] constexpr bool is_closed(std::string_view comment) {
    return comment.size() > 1 && comment.back() == ')';
}
/// After the name `<FLANGE>` that opens at `open`; empty where no name stands.
[[nodiscard]] std::optional<Offset> after_name(std::string_view text, Offset open);

struct Token {
    enum class Kind : std::uint8_t {
        letters,      ///< letters in a row, and `GO TO`: keywords, functions, addresses
        number,       ///< digits and points in a row
        variable,     ///< `#101`
        foreign_name, ///< `#<_depth>` of other controls
        sharp,        ///< `#` alone, or before a bracket or a name
        open,
        close,
        comment,
        equals,
        comparison, ///< `<`, `>=`, `==` ...
        sign,       ///< `+`, `-`
        operation,  ///< `*`, `/`
        comma,
        end_of_block, ///< `;`, or a byte of a line end
        other,        ///< also the name of a program at the head of a block
    };
    Kind kind;
    Span span; ///< in the file
};

/// Cuts a part of a file into tokens; blanks stand between them.
class Lexer {
  public:
    Lexer(std::string_view file, Span part)
        : text_(file.substr(0, part.end))
        , at_(part.begin) {}

    /// Empty at the end of the part.
    [[nodiscard]] std::optional<Token> next();

    /// Tokens that were passed over.
    struct Passed {
        Offset length; ///< of all of them, the blanks between them left out
        Offset end;    ///< of the last one
    };
    /// Passes over tokens that say nothing about where blocks and comments begin and end: all but comments,
    /// names, tape marks, ends of blocks and letters O, and nearly all there are.
    Passed pass_ordinary();

  private:
    Token::Kind cut();
    Token::Kind cut_letters();
    Token::Kind cut_variable();

    std::string_view text_;
    Offset at_;
    bool at_head_ = true; ///< of the block; comments do not count
};

/// The tokens of the block at `block` in `file`, of at most the first 64 KiB of it.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view file, Span block);

/// Writes into `key` what the grammar looks at in a block: a text of the same length and with the same tree,
/// digits and the text of comments made equal.
void make_cache_key(std::string_view block, std::string& key);

} // namespace maclint::fanuc
