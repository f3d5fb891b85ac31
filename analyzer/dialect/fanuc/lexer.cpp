//! The lexer: every byte is looked at a bounded number of times.
#include "analyzer/dialect/fanuc/lexer.hpp"

#include <algorithm>

namespace maclint::fanuc {
namespace {

using Kind = Token::Kind;

/// Longer texts are cut: nobody wrote them by hand.
constexpr Offset longest_looked_at = 64 * 1024;

/// The length of the comparison that begins at `at`; 0 where none does.
Offset comparison_length(std::string_view text, Offset at) {
    static constexpr std::string_view pairs[] = {"==", "<=", ">=", "=<", "=>", "<>", "!="};
    for (const std::string_view pair : pairs)
        if (text.substr(at).starts_with(pair)) return 2;
    return text[at] == '<' || text[at] == '>' ? 1 : 0;
}

} // namespace

Offset after_comment(std::string_view text, Offset open) {
    Offset at = open + 1;
    while (at < text.size() && text[at] != ')' && !is_line_break(text[at])) ++at;
    return at < text.size() && text[at] == ')' ? at + 1 : at;
}

std::optional<Offset> after_name(std::string_view text, Offset open) {
    const std::size_t close = text.find_first_of(">\r\n;(#[", open + 1);
    if (close == std::string_view::npos || text[close] != '>') return std::nullopt;
    return static_cast<Offset>(close) + 1;
}

std::optional<Token> Lexer::next() {
    pass(is_blank);
    if (at_ >= text_.size()) return std::nullopt;
    const Offset begin = at_;
    const Kind kind = cut(text_[at_]);
    if (kind != Kind::comment) at_head_ = kind == Kind::end_of_block;
    return Token{kind, {begin, at_}};
}

Kind Lexer::cut(char first) {
    if (is_letter(first)) return pass(is_letter), Kind::letters;
    if (is_digit(first) || first == '.')
        return pass([](char c) { return is_digit(c) || c == '.'; }), Kind::number;
    switch (first) {
    case '#': return cut_variable();
    case '(': at_ = after_comment(text_, at_); return Kind::comment;
    case '<':
        if (!at_head_) break;
        if (const std::optional<Offset> after = after_name(text_, at_)) return at_ = *after, Kind::other;
        break;
    default: break;
    }
    const bool may_compare = first == '<' || first == '>' || first == '=' || first == '!';
    if (const Offset length = may_compare ? comparison_length(text_, at_) : 0; length != 0)
        return at_ += length, Kind::comparison;
    ++at_;
    switch (first) {
    case '[': return Kind::open;
    case ']': return Kind::close;
    case '=': return Kind::equals;
    case '+':
    case '-': return Kind::sign;
    case '*':
    case '/': return Kind::operation;
    case ',': return Kind::comma;
    case ';':
    case '\n':
    case '\r': return Kind::end_of_block;
    default: return Kind::other;
    }
}

/// What begins with `#`; in a name in `<` `>` a '(' is a letter like any other.
Kind Lexer::cut_variable() {
    Offset next = ++at_;
    while (next < text_.size() && is_blank(text_[next])) ++next;
    if (next >= text_.size()) return Kind::sharp;
    if (is_digit(text_[next])) {
        at_ = next;
        return pass(is_digit), Kind::variable;
    }
    if (text_[next] != '<') return Kind::sharp;
    constexpr std::string_view ends(">\r\n;\0", 5);
    const std::size_t close = text_.find_first_of(ends, next);
    if (close == std::string_view::npos || text_[close] != '>') return Kind::sharp;
    at_ = static_cast<Offset>(close) + 1;
    return Kind::foreign_name;
}

std::vector<Token> tokens_of(std::string_view file, Span block) {
    Lexer lexer(file, {block.begin, std::min(block.end, block.begin + longest_looked_at)});
    std::vector<Token> tokens;
    while (const std::optional<Token> token = lexer.next()) tokens.push_back(*token);
    return tokens;
}

void make_cache_key(std::string_view block, std::string& key) {
    key.assign(block);
    Lexer lexer(block, {0, static_cast<Offset>(block.size())});
    while (const std::optional<Token> token = lexer.next()) {
        auto [begin, end] = token->span;
        if (token->kind == Kind::comment) {
            if (is_closed(block.substr(begin, end - begin))) --end;
            std::fill(key.begin() + begin + 1, key.begin() + end, '-');
        } else if (token->kind == Kind::number || token->kind == Kind::variable) {
            // After '/' the first digit counts: a skip level is one of 1 to 9.
            if (begin > 0 && block[begin - 1] == '/') ++begin;
            std::replace_if(key.begin() + begin, key.begin() + end, is_digit, '0');
        }
    }
}

} // namespace maclint::fanuc
