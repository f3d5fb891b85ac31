//! The lexer of DIN PLUS: classes of bytes, comments, texts, tokens. Whatever looks at the text of a line
//! looks through it: splitter, diagnosis, parse cache, plausibility, the search for section words.
#pragma once

#include "analyzer/dialect/characters.hpp"
#include "analyzer/source/span.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::dinplus {

/// Bytes that are not ASCII count: files in Latin-1 come undecoded.
constexpr bool is_letter(char c) {
    return is_capital(c) || (c >= 'a' && c <= 'z') || c == '_' || static_cast<unsigned char>(c) >= 0x80;
}
/// Leader, form feeds and the end mark of old editors count as blanks.
constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\0' || c == '\f' || c == '\v' || c == '\x1A';
}
constexpr bool is_line_break(char c) { return c == '\n' || c == '\r'; }

/// After the blanks, the byte order mark and the leader at `at`.
[[nodiscard]] Offset skip_blanks(std::string_view text, Offset at);
/// After the slides and skip marks at `at`, and the blanks around them: `$1 /2`.
[[nodiscard]] Offset after_marks(std::string_view text, Offset at);
/// The words at `at`, in any case and with blanks between them, as far as they reach; the first has three
/// letters or more.
[[nodiscard]] Span words_at(std::string_view text, Offset at);
/// Whether the line at `at` looks like a block, whatever stands before it: a block number with something
/// after it, or a section word.
[[nodiscard]] bool begins_block(std::string_view text, Offset at);

struct Token {
    enum class Kind : std::uint8_t {
        letters,  ///< letters and underscores in a row: keywords, addresses, names
        number,   ///< digits and points in a row
        variable, ///< `#l1`, `#_name`, `#`
        open,     ///< `(`
        close,    ///< `)`
        text,     ///< closed on its line, in straight quotes or in curly ones
        unclosed_text,
        comment,          ///< may span lines
        unclosed_comment, ///< ends with the line before which blocks visibly begin again
        foreign_comment,  ///< `;` or `//` and what stands after it
        header,           ///< `#UNIT METRIC`: quotes mean nothing there
        program_name,     ///< `%shaft.nc`
        sign,             ///< an operator or a comma
        end_of_line,      ///< a byte of it
        other,            ///< means nothing outside of texts and comments
    };
    Kind kind;
    Span span; ///< in the file
};
[[nodiscard]] constexpr bool is_comment(Token::Kind kind) {
    return kind == Token::Kind::comment || kind == Token::Kind::unclosed_comment;
}

/// Cuts a part of a file, which begins with a line, into tokens; blanks stand between them.
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
    Token::Kind cut_letters();
    Token::Kind cut_text();
    Token::Kind cut_comment();
    Token::Kind cut_foreign_comment();
    Token::Kind cut_sharp();
    Token::Kind cut_program_name();

    std::string_view text_;
    Offset at_;
    bool at_head_ = true; ///< of the line; comments do not count
    bool in_header_ = false;
};

/// The tokens of the block at `block` in `file`, of at most the first 64 KiB of it; without those of line
/// ends and of foreign comments, where nothing is code.
[[nodiscard]] std::vector<Token> tokens_of(std::string_view file, Span block);

/// Writes into `key` what the grammar looks at in a block: a text of the same length and with the same tree,
/// digits and the inside of comments and texts made equal.
void make_cache_key(std::string_view block, std::string& key);

} // namespace maclint::dinplus
