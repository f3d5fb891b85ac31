//! The lexer of SINUMERIK: classes of bytes, comments, texts, tokens. Splitter, diagnosis, parse cache and
//! plausibility look at the text of a line through it.
#pragma once

#include "analyzer/dialect/characters.hpp"
#include "analyzer/source/span.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::sinumerik {

/// `_` counts as a letter [NCP19 p.52].
constexpr bool begins_name(char c) { return is_letter(c) || c == '_'; }
/// `&` counts as a blank [NCP19 p.52]; so do the leader and the end mark of old editors.
constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '&' || c == '\0' || c == '\x1A'; }
constexpr bool is_line_break(char c) { return c == '\n' || c == '\r'; }

/// After the blanks and the byte order mark at `at`.
[[nodiscard]] Offset skip_blanks(std::string_view text, Offset at);

struct Token {
    enum class Kind : std::uint8_t {
        name,   ///< letters, digits and `_`, the first one no digit
        number, ///< digits and points in a row
        text,   ///< in quotes, closed on its line
        unclosed_text,
        open,  ///< `(`, `[`
        close, ///< `)`, `]`
        sign,  ///< any other character of ASCII
        comment,
        end_of_line, ///< a byte of it
        other,       ///< means nothing outside of texts and comments
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

  private:
    template<class Is>
    void pass(const Is& is) {
        while (at_ < text_.size() && is(text_[at_])) ++at_;
    }
    Token::Kind cut(char first);
    Token::Kind cut_text();

    std::string_view text_;
    Offset at_;
};

/// The tokens of a block, without comments.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view file, Span block);

/// Writes into `key` what the grammar looks at in a block: a text of the same length and with the same tree,
/// digits and the inside of comments made equal.
void make_cache_key(std::string_view block, std::string& key);

} // namespace maclint::sinumerik
