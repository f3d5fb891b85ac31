//! The lexer: every byte is looked at a bounded number of times.
#include "analyzer/dialect/dinplus/lexer.hpp"

#include "analyzer/dialect/dinplus/sections.hpp"

#include <algorithm>

namespace maclint::dinplus {
namespace {

using Kind = Token::Kind;

/// Longer texts are cut: nobody wrote them by hand.
constexpr Offset longest_looked_at = 64 * 1024;

Offset size_of(std::string_view text) { return static_cast<Offset>(text.size()); }

/// The mark of UTF-8, which editors leave wherever files were joined.
bool is_byte_order_mark(std::string_view text, Offset at) {
    return text[at] == '\xEF' && text.substr(at, 3) == "\xEF\xBB\xBF";
}

struct CommentEnd {
    Offset at;
    bool closed;
};

/// Where the comment that opens at `open` ends. One that runs into the next comment after a line that looks
/// like a block was never closed either: the ']' is the other one's.
CommentEnd find_comment_end(std::string_view text, Offset open) {
    Offset blocks_begin = 0; // line end before the first line that looks like a block
    for (Offset at = open + 1; at < text.size(); ++at) {
        if (text[at] == ']') return {at + 1, true};
        if (text[at] == '[' && blocks_begin != 0) break;
        if (is_line_break(text[at]) && blocks_begin == 0 && begins_block(text, at + 1)) blocks_begin = at;
    }
    Offset end = blocks_begin != 0 ? blocks_begin : size_of(text);
    while (end > open + 1 && (is_blank(text[end - 1]) || is_line_break(text[end - 1]))) --end;
    return {end, false};
}

/// U+201C to U+201E, as word processors make them of straight quotes.
bool is_curly_quote(std::string_view text, Offset at) {
    if (text[at] != '\xE2') return false;
    const std::string_view bytes = text.substr(at, 3);
    return bytes == "\xE2\x80\x9C" || bytes == "\xE2\x80\x9D" || bytes == "\xE2\x80\x9E";
}

/// After the text that opens with the curly quote at `open`; empty when nothing closes it on its line.
std::optional<Offset> after_curly_text(std::string_view text, Offset open) {
    for (Offset at = open + 3; at < text.size() && !is_line_break(text[at]) && text[at] != '\0'; ++at) {
        if (text[at] == '"') return at + 1;
        if (is_curly_quote(text, at)) return at + 3;
    }
    return std::nullopt;
}

/// Whether a `#` at `at`, the head of a line, begins an entry of the program head: `#UNIT METRIC`. `#l1` and
/// `#G20` are variables.
bool begins_header(std::string_view text, Offset at) {
    if (at + 2 >= text.size() || !is_capital(text[at + 1])) return false;
    const char second = text[at + 2];
    return is_capital(second) || static_cast<unsigned char>(second) >= 0x80 || second == '\1';
}

/// Whether the block may hold a remark in parentheses in which a byte stands that would otherwise begin a
/// text or a comment: `(SEE "A) X1`. Only the grammar knows where such a remark may stand.
bool may_hold_remark_with_marks(std::string_view block) {
    for (std::size_t open = block.find('('); open != std::string_view::npos;
         open = block.find('(', open + 1)) {
        const std::size_t first = block.find_first_not_of(" \t", open + 1);
        if (first == std::string_view::npos || !is_letter(block[first])) continue;
        const std::size_t close = block.find_first_of("()\r\n#", first);
        if (close == std::string_view::npos || block[close] != ')') continue;
        const std::string_view remark = block.substr(first, close - first);
        if (remark.find_first_of("\"[;\xE2") != std::string_view::npos ||
            remark.find("//") != std::string_view::npos)
            return true;
    }
    return false;
}

/// Bytes that mean something where a text or comment may not be what it seems, or that the grammar tells
/// apart in there: `[//]` is no comment, U+201D ends a text. They are few.
bool is_kept_in_key(char c) {
    switch (c) {
    case '"':
    case '[':
    case ']':
    case '(':
    case ')':
    case '#':
    case ';':
    case '/':
    case '\r':
    case '\n': return true;
    default: return static_cast<unsigned char>(c) >= 0x80;
    }
}

/// Whether a text or a comment may begin with the byte.
bool may_open(char c) { return c == '[' || c == '"' || c == '\xE2'; }

} // namespace

Offset skip_blanks(std::string_view text, Offset at) {
    while (at < text.size()) {
        if (is_blank(text[at]))
            ++at;
        else if (is_byte_order_mark(text, at))
            at += 3;
        else
            break;
    }
    return at;
}

Offset after_marks(std::string_view text, Offset at) {
    at = skip_blanks(text, at);
    while (at < text.size() && (text[at] == '$' || text[at] == '/')) {
        do ++at;
        while (at < text.size() && is_digit(text[at]));
        at = skip_blanks(text, at);
    }
    return at;
}

Span words_at(std::string_view text, Offset at) {
    constexpr Offset longest = 64;
    Span words{at, at};
    text = text.substr(0, std::min<std::size_t>(text.size(), at + longest));
    while (at < text.size() && is_letter(text[at])) {
        const Offset begin = at;
        while (at < text.size() && is_letter(text[at])) ++at;
        // `X118`, `ID"A"`, `N5`: words of a block, not of a name.
        if (at < text.size() && !is_blank(text[at]) && !is_line_break(text[at]) && text[at] != '[' &&
            text[at] != '"')
            break;
        if (at - begin < 3 && words.empty()) break;
        words.end = at;
        while (at < text.size() && is_blank(text[at])) ++at;
    }
    return words;
}

bool begins_block(std::string_view text, Offset at) {
    at = after_marks(text, at);
    if (at >= text.size()) return false;
    if (text[at] == 'N') {
        const Offset digits = skip_blanks(text, at + 1);
        Offset end = digits;
        while (end < text.size() && is_digit(text[end])) ++end;
        const Offset next = skip_blanks(text, end);
        return end > digits && next < text.size() && !is_line_break(text[next]);
    }
    const Span words = words_at(text, at);
    if (words.empty()) return false;
    const auto section = find_section(text.substr(words.begin, words.length()));
    return section && section->capitals && section->word->use != SectionWord::Use::translated;
}

std::optional<Token> Lexer::next() {
    at_ = skip_blanks(text_, at_);
    if (at_ >= text_.size()) return std::nullopt;
    const Offset begin = at_;
    const Kind kind = cut(text_[at_]);
    if (kind == Kind::end_of_line) {
        at_head_ = true;
        in_header_ = false;
    } else if (!is_comment(kind) && kind != Kind::foreign_comment) {
        at_head_ = false;
    }
    return Token{kind, {begin, at_}};
}

Kind Lexer::cut(char first) {
    if (first == '[') return cut_comment();
    if (is_line_break(first)) return ++at_, Kind::end_of_line;
    if (in_header_ || (first == '#' && at_head_ && begins_header(text_, at_))) {
        in_header_ = true;
        pass([](char c) { return c != '[' && !is_line_break(c); });
        while (is_blank(text_[at_ - 1])) --at_;
        return Kind::header;
    }
    if (is_letter(first)) return cut_letters();
    if (is_digit(first) || first == '.')
        return pass([](char c) { return is_digit(c) || c == '.'; }), Kind::number;
    switch (first) {
    case '#': return cut_sharp();
    case '"': return cut_text();
    case ';': return cut_foreign_comment();
    case '%': return at_head_ ? cut_program_name() : (++at_, Kind::other);
    case '/':
        if (text_.substr(at_).starts_with("//")) return cut_foreign_comment();
        break;
    default: break;
    }
    ++at_;
    switch (first) {
    case '(': return Kind::open;
    case ')': return Kind::close;
    case '+':
    case '-':
    case '*':
    case '/':
    case '=':
    case '<':
    case '>':
    case ',': return Kind::sign;
    default: return Kind::other;
    }
}

Kind Lexer::cut_letters() {
    if (is_curly_quote(text_, at_)) {
        if (const std::optional<Offset> after = after_curly_text(text_, at_)) return at_ = *after, Kind::text;
        return at_ += 3, Kind::other;
    }
    while (at_ < text_.size() && is_letter(text_[at_]) && !is_curly_quote(text_, at_)) ++at_;
    return Kind::letters;
}

Kind Lexer::cut_text() {
    ++at_;
    pass([](char c) { return c != '"' && !is_line_break(c); });
    if (at_ == text_.size() || text_[at_] != '"') return Kind::unclosed_text;
    return ++at_, Kind::text;
}

Kind Lexer::cut_comment() {
    const CommentEnd end = find_comment_end(text_, at_);
    at_ = end.at;
    return end.closed ? Kind::comment : Kind::unclosed_comment;
}

Kind Lexer::cut_foreign_comment() {
    pass([](char c) { return c != '[' && !is_line_break(c); });
    return Kind::foreign_comment;
}

Kind Lexer::cut_sharp() {
    ++at_;
    pass([](char c) { return is_letter(c) || is_digit(c); });
    return Kind::variable;
}

Kind Lexer::cut_program_name() {
    while (at_ < text_.size() && text_[at_] != '[' && text_[at_] != '"' && !is_line_break(text_[at_]) &&
           !is_curly_quote(text_, at_))
        ++at_;
    while (is_blank(text_[at_ - 1])) --at_;
    return Kind::program_name;
}

std::vector<Token> tokens_of(std::string_view file, Span block) {
    Lexer lexer(file, {block.begin, std::min(block.end, block.begin + longest_looked_at)});
    std::vector<Token> tokens;
    while (const std::optional<Token> token = lexer.next())
        if (token->kind != Kind::end_of_line && token->kind != Kind::foreign_comment)
            tokens.push_back(*token);
    return tokens;
}

void make_cache_key(std::string_view block, std::string& key) {
    key.assign(block);
    std::ranges::replace_if(key, is_digit, '0');
    if (std::ranges::none_of(block, may_open) || may_hold_remark_with_marks(block)) return;
    Lexer lexer(block, {0, size_of(block)});
    while (const std::optional<Token> token = lexer.next()) {
        const bool inside =
            is_comment(token->kind) || token->kind == Kind::text || token->kind == Kind::unclosed_text;
        if (!inside) continue;
        for (Offset at = token->span.begin; at < token->span.end; ++at)
            if (!is_kept_in_key(key[at])) key[at] = '-';
    }
}

} // namespace maclint::dinplus
