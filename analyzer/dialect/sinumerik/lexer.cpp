//! The lexer: every byte is looked at a bounded number of times.
#include "analyzer/dialect/sinumerik/lexer.hpp"

#include <algorithm>

namespace maclint::sinumerik {

using TokenKind = Token::Kind;

Offset skip_blanks(std::string_view text, Offset at) {
    constexpr std::string_view mark = "\xEF\xBB\xBF"; // editors leave it wherever files were joined
    while (at < text.size()) {
        if (is_blank(text[at]))
            ++at;
        else if (text.substr(at, mark.size()) == mark)
            at += static_cast<Offset>(mark.size());
        else
            break;
    }
    return at;
}

std::optional<Token> Lexer::next() {
    at_ = skip_blanks(text_, at_);
    if (at_ >= text_.size()) return std::nullopt;
    const Offset begin = at_++;
    const TokenKind kind = cut(text_[begin]);
    return Token{kind, {begin, at_}};
}

TokenKind Lexer::cut(char first) {
    if (is_line_break(first)) return TokenKind::end_of_line;
    if (begins_name(first)) {
        pass([](char c) { return begins_name(c) || is_digit(c); });
        return TokenKind::name;
    }
    if (is_digit(first) || first == '.') {
        pass([](char c) { return is_digit(c) || c == '.'; });
        return TokenKind::number;
    }
    switch (first) {
    case ';': pass([](char c) { return !is_line_break(c); }); return TokenKind::comment;
    case '"': return cut_text();
    case '(':
    case '[': return TokenKind::open;
    case ')':
    case ']': return TokenKind::close;
    default: break;
    }
    if (static_cast<unsigned char>(first) < 0x80) return TokenKind::sign;
    pass([](char c) { return static_cast<unsigned char>(c) >= 0x80; });
    return TokenKind::other;
}

/// A quotation mark inside is written '"' [HLS].
TokenKind Lexer::cut_text() {
    for (; at_ < text_.size() && !is_line_break(text_[at_]); ++at_) {
        if (text_.substr(at_, 3) == "'\"'") {
            at_ += 2;
        } else if (text_[at_] == '"') {
            ++at_;
            return TokenKind::text;
        }
    }
    return TokenKind::unclosed_text;
}

std::vector<Token> tokens_of(std::string_view file, Span block) {
    std::vector<Token> tokens;
    Lexer lexer(file, block);
    while (const std::optional<Token> token = lexer.next())
        if (token->kind != TokenKind::comment && token->kind != TokenKind::end_of_line)
            tokens.push_back(*token);
    return tokens;
}

/// No keyword holds a digit, so that blocks which differ in digits alone have the same tree.
void make_cache_key(std::string_view block, std::string& key) {
    key.assign(block);
    std::ranges::replace_if(key, is_digit, '0');
    if (block.find(';') == std::string_view::npos) return;
    Lexer lexer(block, {0, static_cast<Offset>(block.size())});
    while (const std::optional<Token> token = lexer.next())
        if (token->kind == TokenKind::comment)
            std::fill(key.begin() + token->span.begin + 1, key.begin() + token->span.end, '-');
}

} // namespace maclint::sinumerik
