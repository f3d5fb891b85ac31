//! Finds the cause of a syntax error in a block's text; the parser's recovery is only asked where the text
//! ran out.
#include "analyzer/dialect/sinumerik/diagnose.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/dialect/shown_text.hpp"
#include "analyzer/dialect/sinumerik/keywords.hpp"
#include "analyzer/dialect/sinumerik/kinds.hpp"
#include "analyzer/dialect/sinumerik/lexer.hpp"

#include <algorithm>
#include <utility>

namespace maclint::sinumerik {
namespace {

using TokenKind = Token::Kind;

std::string_view text_of(std::string_view text, const Token& token) {
    return text.substr(token.span.begin, token.span.length());
}

SyntaxError error_at(std::string_view text, SyntaxErrorKind kind, Span span, std::string cure) {
    return {kind, span, shown(text.substr(span.begin, span.length())), std::move(cure)};
}

std::optional<SyntaxError> unclosed_text(std::string_view text, std::span<const Token> tokens) {
    const auto token = std::ranges::find(tokens, TokenKind::unclosed_text, &Token::kind);
    if (token == tokens.end()) return std::nullopt;
    return error_at(text, SyntaxErrorKind::unreadable, token->span, "a '\"' at the end of the text");
}

/// `X. . .`: how courses leave a value to the reader.
std::optional<SyntaxError> placeholder(std::string_view text, std::span<const Token> tokens) {
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const Token& token = tokens[i];
        const bool points = token.kind == TokenKind::number &&
                            text_of(text, token).find_first_not_of('.') == std::string_view::npos;
        const bool extension = i + 1 < tokens.size() && tokens[i + 1].kind == TokenKind::name; // NAME.SPF
        if (points && !extension) return error_at(text, SyntaxErrorKind::unreadable, token.span, "a number");
    }
    return std::nullopt;
}

/// A line of dashes, or text outside of ASCII: a remark that lost its `;`.
std::optional<SyntaxError> bare_remark(std::string_view text, std::span<const Token> tokens) {
    constexpr std::size_t fewest = 3;
    if (tokens.empty()) return std::nullopt;
    const bool dashes = tokens.size() >= fewest &&
                        std::ranges::all_of(tokens.first(fewest),
                                            [](const Token& token) { return token.kind == TokenKind::sign; });
    if (!dashes && tokens[0].kind != TokenKind::other) return std::nullopt;
    SyntaxError error = error_at(text, SyntaxErrorKind::remark_without_sign,
                                 {tokens.front().span.begin, tokens.back().span.end}, "");
    error.remedy = remark_remedy(error.span.begin);
    return error;
}

/// `CASE R1 OF 1 GOTOF ONE DEFAULT OTHER`.
std::optional<SyntaxError> case_without_jump(std::string_view text, std::span<const Token> tokens) {
    const auto is = [&](const Token& token, std::string_view word) {
        return token.kind == TokenKind::name && in_capitals(text_of(text, token)) == word;
    };
    const auto word = std::ranges::find_if(tokens, [&](const Token& token) { return is(token, "DEFAULT"); });
    const bool is_case = std::ranges::any_of(tokens, [&](const Token& token) { return is(token, "CASE"); });
    if (!is_case || word == tokens.end()) return std::nullopt;
    return error_at(text, SyntaxErrorKind::malformed_case, word->span, "a jump such as GOTOF behind it");
}

/// A block is one line: `PROC SLOT(REAL WIDTH,` and the rest in the next one.
std::optional<SyntaxError> split_declaration(std::string_view text, std::span<const Token> tokens) {
    const auto word = std::ranges::find(tokens, TokenKind::name, &Token::kind);
    if (word == tokens.end() || word != tokens.begin()) return std::nullopt;
    const std::string first = in_capitals(text_of(text, *word));
    if (first != "PROC" && first != "DEF" && first != "EXTERN") return std::nullopt;
    const auto opened = std::ranges::count(tokens, TokenKind::open, &Token::kind);
    const auto closed = std::ranges::count(tokens, TokenKind::close, &Token::kind);
    const Token& last = tokens.back();
    if (text_of(text, last) != "," && !(opened > closed && text_of(text, last) == "(")) return std::nullopt;
    return error_at(text, SyntaxErrorKind::split_declaration, {tokens.front().span.begin, last.span.end}, "");
}

/// `DEF INT G6_OLD`: the parser takes what is before the second letter for a word of its own.
std::optional<SyntaxError> malformed_name(std::string_view text, std::span<const Token> tokens) {
    if (tokens.empty() || in_capitals(text_of(text, tokens.front())) != "DEF") return std::nullopt;
    int depth = 0; // sizes and values stand in brackets
    for (std::size_t i = 1; i < tokens.size(); ++i) {
        const std::string_view name = text_of(text, tokens[i]);
        depth += tokens[i].kind == TokenKind::open ? 1 : tokens[i].kind == TokenKind::close ? -1 : 0;
        const bool is_name =
            tokens[i].kind == TokenKind::name && depth == 0 && text_of(text, tokens[i - 1]) != "=";
        if (is_name && name.size() > 1 && is_digit(name[1]))
            return error_at(text, SyntaxErrorKind::malformed_name, tokens[i].span,
                            "its first two characters are not letters or _");
    }
    return std::nullopt;
}

/// `WHLIE R1<5`
std::optional<SyntaxError> misspelled_opener(std::string_view text, std::span<const Token> tokens) {
    const auto word = std::ranges::find(tokens, TokenKind::name, &Token::kind);
    if (word == tokens.end() || word != tokens.begin()) return std::nullopt;
    const std::string_view meant = opener_meant_by(in_capitals(text_of(text, *word)));
    if (meant.empty()) return std::nullopt;
    return error_at(text, SyntaxErrorKind::unknown_keyword, word->span, std::string(meant));
}

char closer_of(char open) { return open == '(' ? ')' : ']'; }

std::optional<SyntaxError> bracket_mismatch(std::string_view text, std::span<const Token> tokens) {
    std::vector<const Token*> open;
    for (const Token& token : tokens) {
        if (token.kind == TokenKind::open) open.push_back(&token);
        if (token.kind != TokenKind::close) continue;
        const char close = text[token.span.begin];
        const std::string wanted = close == ')' ? "(" : "[";
        if (open.empty())
            return error_at(text, SyntaxErrorKind::bracket_mismatch, token.span,
                            "a '" + wanted + "' is missing before it");
        const char opened = text[open.back()->span.begin];
        if (closer_of(opened) != close)
            return error_at(text, SyntaxErrorKind::bracket_mismatch, open.back()->span,
                            std::string("its '") + closer_of(opened) + "' is missing");
        open.pop_back();
    }
    if (open.empty()) return std::nullopt;
    return error_at(text, SyntaxErrorKind::bracket_mismatch, open.back()->span,
                    std::string("its '") + closer_of(text[open.back()->span.begin]) + "' is missing");
}

} // namespace

Remedy remark_remedy(Offset begin) { return {"Write a semicolon before it", true, {{{begin, begin}, ";"}}}; }

std::string_view label_in(std::string_view written) {
    if (written.ends_with(wide_colon)) written.remove_suffix(wide_colon.size());
    if (written.ends_with(':')) written.remove_suffix(1);
    while (!written.empty() && is_blank(written.back())) written.remove_suffix(1);
    return written;
}

SyntaxError find_parse_error(std::string_view text, Span block, const syntax::Tree& tree) {
    Span span = block;
    std::string expected;
    const auto error = std::ranges::find_if(
        tree.nodes, [](const syntax::Node& n) { return n.missing || kind_of(n) == Kind::error; });
    if (error != tree.nodes.end()) {
        if (error->missing && !error->named)
            expected = "'" + std::string(syntax::symbol_name(grammar, error->symbol)) + "'";
        else if (!error->span.empty())
            span = {block.begin + error->span.begin, block.begin + error->span.end};
    }
    return unreadable(text, span, std::move(expected));
}

std::optional<SyntaxError> find_cause(std::string_view text, Span block) {
    const std::vector<Token> tokens = tokens_of(text, block);
    for (const auto cause : {&bare_remark, &unclosed_text, &placeholder, &split_declaration,
                             &bracket_mismatch, &case_without_jump, &malformed_name, &misspelled_opener})
        if (std::optional<SyntaxError> found = cause(text, tokens)) return found;
    return std::nullopt;
}

bool declares_program(std::string_view text, Span block) {
    const std::vector<Token> tokens = tokens_of(text, block);
    constexpr std::size_t furthest = 2;       // a block number may stand before it
    constexpr std::string_view next = "NAME"; // whatever it is
    return std::ranges::any_of(std::span(tokens).first(std::min(furthest, tokens.size())),
                               [&](const Token& token) {
                                   const std::string word = in_capitals(text_of(text, token));
                                   return word == "PROC" || declaration_meant_by(word, next, true) == "PROC";
                               });
}

/// Any name may be a label or a program, and any variable may be written.
NamedInBlock names_in(OpenProgram& program, Span block) {
    const std::string_view text = program.builder.program().text;
    NamedInBlock names;
    names.may_call_or_return = true;
    for (const Token& token : tokens_of(text, block)) {
        if (token.kind != TokenKind::name) continue;
        const std::string word = in_capitals(text_of(text, token));
        names.may_open_or_close |= is_structural(word);
        if (const auto known = program.variables.find(word); known != program.variables.end()) {
            if (std::ranges::find(names.variables, known->second) == names.variables.end())
                names.variables.push_back(known->second);
        } else {
            const Label label = program.builder.block_name(word);
            if (std::ranges::find(names.labels, label) == names.labels.end()) names.labels.push_back(label);
        }
    }
    return names;
}

} // namespace maclint::sinumerik
