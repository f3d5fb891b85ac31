//! One pass over the tokens of a block.
#include "analyzer/dialect/fanuc/plausible.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/fanuc/lexer.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace maclint::fanuc {
namespace {

using Kind = Token::Kind;

constexpr std::size_t farthest_value = 48;
constexpr std::size_t most_parse_errors = 32;

/// The words of an output or naming statement are free text.
bool holds_free_text(std::string_view block) {
    const std::string capitals = in_capitals(block);
    return capitals.find("PRNT") != std::string::npos || capitals.find("SETVN") != std::string::npos;
}

/// Digits, or the sign before a name: `[#DEPTH]`.
bool is_value(std::string_view text, const Token& token) {
    switch (token.kind) {
    case Kind::variable:
    case Kind::foreign_name: return true;
    case Kind::number:
        return std::any_of(text.begin() + token.span.begin, text.begin() + token.span.end, is_digit);
    case Kind::sharp: return token.span.end < text.size() && is_letter(text[token.span.end]);
    default: return false;
    }
}

} // namespace

bool is_plausible(std::string_view text, Span block) {
    std::size_t without_value = 0; // bytes since the last value
    std::size_t parse_errors = 0;  // commas without a letter after them, values that follow a value
    char before = '\0';
    Lexer lexer(text, block);
    while (const std::optional<Token> token = lexer.next()) {
        if (token->kind == Kind::comment) continue;
        const char first = text[token->span.begin];
        const bool ends_value = before == ']' || is_digit(before);
        if ((first == '[' || first == '#') && ends_value) ++parse_errors;
        if (before == ',' && !is_letter(first)) ++parse_errors;
        without_value = is_value(text, *token) ? 0 : without_value + token->span.length();
        if (without_value > farthest_value) break;
        before = text[token->span.end - 1];
    }
    if (parse_errors > most_parse_errors) return false;
    return without_value <= farthest_value || holds_free_text(text.substr(block.begin, block.length()));
}

} // namespace maclint::fanuc
