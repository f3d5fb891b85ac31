//! The lexer: every byte is looked at a bounded number of times.
#include "analyzer/dialect/fanuc/lexer.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

namespace maclint::fanuc {
namespace {

using Kind = Token::Kind;

/// Longer texts are cut: nobody wrote them by hand.
constexpr Offset longest_looked_at = 64 * 1024;

/// How the token that begins with a byte is found.
enum class Start : std::uint8_t {
    blank,
    letter,
    number,
    variable,
    comment,
    name_or_comparison,
    comparison,
    alone
};

struct ByteClass {
    Start start = Start::alone;
    Kind kind = Kind::other; ///< of the byte where it is a token alone
};

constexpr std::array<ByteClass, 256> make_classes() {
    std::array<ByteClass, 256> classes{};
    for (std::size_t i = 0; i < classes.size(); ++i) {
        const char c = static_cast<char>(i);
        if (is_blank(c)) classes[i].start = Start::blank;
        if (is_letter(c)) classes[i].start = Start::letter;
        if (is_digit(c) || c == '.') classes[i].start = Start::number;
    }
    const auto set = [&](char c, Start start, Kind kind) {
        classes[static_cast<unsigned char>(c)] = {start, kind};
    };
    set('#', Start::variable, Kind::sharp);
    set('(', Start::comment, Kind::comment);
    set('<', Start::name_or_comparison, Kind::comparison);
    set('>', Start::comparison, Kind::comparison);
    set('=', Start::comparison, Kind::equals);
    set('!', Start::comparison, Kind::other);
    set('[', Start::alone, Kind::open);
    set(']', Start::alone, Kind::close);
    set('+', Start::alone, Kind::sign);
    set('-', Start::alone, Kind::sign);
    set('*', Start::alone, Kind::operation);
    set('/', Start::alone, Kind::operation);
    set(',', Start::alone, Kind::comma);
    for (const char c : {';', '\n', '\r'}) set(c, Start::alone, Kind::end_of_block);
    return classes;
}

constexpr std::array<ByteClass, 256> classes = make_classes();

constexpr ByteClass class_of(char c) { return classes[static_cast<unsigned char>(c)]; }

/// Bytes of tokens that say nothing about where a block ends.
constexpr std::array<bool, 256> make_ordinary() {
    std::array<bool, 256> ordinary{};
    for (std::size_t i = 0; i < ordinary.size(); ++i) ordinary[i] = classes[i].start != Start::blank;
    for (const char c : std::string_view("(<#%;\r\nOo")) ordinary[static_cast<unsigned char>(c)] = false;
    return ordinary;
}

constexpr std::array<bool, 256> ordinary = make_ordinary();

/// After the bytes at `at` that begin a token in that way.
Offset pass(std::string_view text, Offset at, Start start) {
    while (at < text.size() && class_of(text[at]).start == start) ++at;
    return at;
}

/// A comparison of two signs.
bool is_pair(std::string_view signs) {
    static constexpr std::string_view pairs[] = {"==", "<=", ">=", "=<", "=>", "<>", "!="};
    return std::ranges::find(pairs, signs) != std::end(pairs);
}

/// Whether G10 stands in the head of a block.
bool sets_data(std::string_view head) {
    for (std::size_t at = 0; at < head.size(); ++at) {
        if (to_capital(head[at]) != 'G') continue;
        const std::string_view number = head.substr(pass(head, static_cast<Offset>(at + 1), Start::blank));
        if (number.starts_with("10") && (number.size() == 2 || !is_digit(number[2]))) return true;
    }
    return false;
}

/// `G10L60P1[*BDB...]`: after the value of a word, brackets hold data of the machine builder, no expression.
void blank_out_data(std::string_view block, std::string& key) {
    const std::size_t open = block.find('[');
    if (open == std::string_view::npos) return;
    const std::size_t value = block.substr(0, open).find_last_not_of(" \t");
    if (value == std::string_view::npos || !is_digit(block[value])) return;
    const std::size_t close = block.find(']', open);
    if (close == std::string_view::npos || block.find('#') != std::string_view::npos) return;
    if (!sets_data(block.substr(0, open))) return;
    std::fill(key.begin() + static_cast<std::ptrdiff_t>(open),
              key.begin() + static_cast<std::ptrdiff_t>(close) + 1, ' ');
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
    at_ = pass(text_, at_, Start::blank);
    if (at_ >= text_.size()) return std::nullopt;
    const Offset begin = at_;
    const Kind kind = cut();
    if (kind != Kind::comment) at_head_ = kind == Kind::end_of_block;
    return Token{kind, {begin, at_}};
}

Lexer::Passed Lexer::pass_ordinary() {
    const std::string_view text = text_;
    Passed passed{0, at_};
    Offset at = at_;
    for (; at < text.size(); ++at) {
        const char c = text[at];
        if (ordinary[static_cast<unsigned char>(c)] ||
            (c == '#' && at + 1 < text.size() && is_digit(text[at + 1]))) {
            ++passed.length;
            passed.end = at + 1;
        } else if (!is_blank(c)) {
            break;
        }
    }
    at_ = at;
    if (passed.length != 0) at_head_ = false;
    return passed;
}

Kind Lexer::cut() {
    const ByteClass first = class_of(text_[at_]);
    switch (first.start) {
    case Start::letter: return cut_letters();
    case Start::number: at_ = pass(text_, at_, Start::number); return Kind::number;
    case Start::variable: return cut_variable();
    case Start::comment: at_ = after_comment(text_, at_); return Kind::comment;
    case Start::name_or_comparison:
        if (const std::optional<Offset> after = at_head_ ? after_name(text_, at_) : std::nullopt)
            return at_ = *after, Kind::other;
        [[fallthrough]];
    case Start::comparison:
        if (is_pair(text_.substr(at_, 2))) return at_ += 2, Kind::comparison;
        break;
    case Start::blank:
    case Start::alone: break;
    }
    ++at_;
    return first.kind;
}

/// The jump word may have blanks inside: `GO TO`.
Kind Lexer::cut_letters() {
    at_ = pass(text_, at_, Start::letter);
    const std::string_view before = text_.substr(0, at_);
    if (!before.ends_with("GO") && !before.ends_with("go")) return Kind::letters;
    const Offset next = pass(text_, at_, Start::blank);
    const Offset end = pass(text_, next, Start::letter);
    const std::string_view word = text_.substr(next, end - next);
    if (word == "TO" || word == "to") at_ = end;
    return Kind::letters;
}

/// What begins with `#`; in a name in `<` `>` a '(' is a letter like any other.
Kind Lexer::cut_variable() {
    const Offset next = pass(text_, ++at_, Start::blank);
    if (next >= text_.size()) return Kind::sharp;
    if (is_digit(text_[next])) {
        at_ = next;
        while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
        return Kind::variable;
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
    key.resize(block.size());
    std::ranges::transform(block, key.begin(), [](char c) { return is_digit(c) ? '0' : c; });
    for (auto skip = block.find('/'); skip != std::string_view::npos && skip + 1 < block.size();
         skip = block.find('/', skip + 1))
        key[skip + 1] = block[skip + 1]; // a level is one of 1 to 9
    blank_out_data(block, key);
    if (block.find('(') == std::string_view::npos) return;
    Lexer lexer(block, {0, static_cast<Offset>(block.size())});
    while (true) {
        lexer.pass_ordinary();
        const std::optional<Token> token = lexer.next();
        if (!token) return;
        if (token->kind != Kind::comment) continue;
        auto [begin, end] = token->span;
        if (is_closed(block.substr(begin, end - begin))) --end;
        std::fill(key.begin() + begin + 1, key.begin() + end, '-');
    }
}

} // namespace maclint::fanuc
