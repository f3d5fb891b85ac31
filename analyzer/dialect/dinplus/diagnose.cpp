//! Finds the cause of a syntax error in a block's text; the parser's recovery is only asked where the text
//! ran out.
#include "analyzer/dialect/dinplus/diagnose.hpp"

#include "analyzer/dialect/cut_block.hpp"
#include "analyzer/dialect/dinplus/keywords.hpp"
#include "analyzer/dialect/dinplus/kinds.hpp"
#include "analyzer/dialect/dinplus/lexer.hpp"
#include "analyzer/dialect/dinplus/sections.hpp"
#include "analyzer/dialect/numbers.hpp"
#include "analyzer/dialect/shown_text.hpp"
#include "analyzer/dialect/wide_signs.hpp"

#include <algorithm>
#include <utility>

namespace maclint::dinplus {
namespace {

using TokenKind = Token::Kind;

/// The tokens of a block and questions about them.
class ErrorExplainer : public CutBlock<Token> {
  public:
    ErrorExplainer(std::string_view text, Span block)
        : CutBlock(text, tokens_of(text, block)) {}

    [[nodiscard]] std::optional<SyntaxError> unclosed_text() const {
        const auto token = std::ranges::find(tokens_, TokenKind::unclosed_text, &Token::kind);
        if (token == tokens_.end()) return std::nullopt;
        return make(SyntaxErrorKind::unreadable, *token, "a '\"' at the end of the text");
    }

    /// `N..`, `X..`: how manuals leave a value to the reader.
    [[nodiscard]] std::optional<SyntaxError> placeholder() const {
        const auto token = std::ranges::find_if(tokens_, [&](const Token& t) {
            return t.kind == TokenKind::number && text(t).find_first_not_of('.') == std::string_view::npos;
        });
        if (token == tokens_.end()) return std::nullopt;
        return make(SyntaxErrorKind::unreadable, *token, "a number");
    }

    /// `X–5`: for the lexer such characters are letters.
    [[nodiscard]] std::optional<SyntaxError> wide_sign() const {
        for (const Token& token : tokens_) {
            if (token.kind != TokenKind::letters) continue;
            for (Offset at = token.span.begin; at < token.span.end; ++at) {
                const auto sign = wide_sign_at(text_, at);
                if (!sign || at + sign->length != token.span.end) continue;
                return SyntaxError{SyntaxErrorKind::wide_sign,
                                   {at, token.span.end},
                                   std::string(text_.substr(at, sign->length)),
                                   std::string(1, sign->meant)};
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<SyntaxError> bracket_mismatch() const {
        std::vector<const Token*> open;
        for (const Token& token : tokens_) {
            if (token.kind == TokenKind::open) open.push_back(&token);
            if (token.kind != TokenKind::close) continue;
            if (open.empty())
                return make(SyntaxErrorKind::bracket_mismatch, token, "a '(' is missing before it");
            open.pop_back();
        }
        if (open.empty()) return std::nullopt;
        return make(SyntaxErrorKind::bracket_mismatch, *open.back(), "its ')' is missing");
    }

    /// Capital words of three or more letters are keywords or nothing; two of them can be addresses.
    [[nodiscard]] std::optional<SyntaxError> unknown_keyword() const {
        std::vector<bool> selectors; // of the open brackets: after a variable, as in #w0(WTL)
        for (std::size_t i = 0; i < tokens_.size(); ++i) {
            const Token& token = tokens_[i];
            if (token.kind == TokenKind::open)
                selectors.push_back(i > 0 && tokens_[i - 1].kind == TokenKind::variable);
            if (token.kind == TokenKind::close && !selectors.empty()) selectors.pop_back();
            if (token.kind != TokenKind::letters || token.span.length() < 3) continue;
            if (!selectors.empty() && selectors.back()) continue;
            if (!std::ranges::all_of(text(token), [](char c) { return is_capital(c) || c == '_'; })) continue;
            const std::string capitals = capitals_of(text(token));
            if (capitals.front() == '_' || capitals == "HID" || is_keyword(capitals)) continue;
            std::string meant = meant_by(capitals);
            if (meant == capitals) continue; // a section word
            // A function has an argument: `T3 TAP M10` is no TAN.
            const bool has_argument = i + 1 < tokens_.size() && tokens_[i + 1].kind == TokenKind::open;
            if (is_function(meant) && !has_argument) meant.clear();
            return make(SyntaxErrorKind::unknown_keyword, token, std::move(meant));
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] SyntaxError make(SyntaxErrorKind kind, const Token& token, std::string cure) const {
        return {kind, token.span, shown(text(token)), std::move(cure)};
    }
};

} // namespace

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
    const ErrorExplainer explainer(text, block);
    for (const auto cause :
         {&ErrorExplainer::unclosed_text, &ErrorExplainer::placeholder, &ErrorExplainer::wide_sign,
          &ErrorExplainer::bracket_mismatch, &ErrorExplainer::unknown_keyword})
        if (std::optional<SyntaxError> found = (explainer.*cause)()) return found;
    return std::nullopt;
}

namespace {

/// The variable that `#l1`, `#_depth`, `#__la` or, as DEF wants it, `__la` names.
std::optional<Variable> variable_named(std::string_view written, const OpenProgram& program) {
    const std::size_t begin = written.find_first_not_of("# \t");
    if (begin == std::string_view::npos) return std::nullopt;
    const std::string_view name = written.substr(begin);
    if (name.starts_with("__")) return transfer_variable(name.substr(2));
    if (name.starts_with('_')) {
        const Variable* alias = program.alias_of(name);
        return alias == nullptr ? std::nullopt : std::optional(*alias);
    }
    const std::optional<FamilyId> family = begin == 0 ? std::nullopt : family_of(name.front());
    const std::optional<std::int64_t> number = read_integer(name);
    if (!family || !number || *number > INT32_MAX) return std::nullopt;
    const auto n = static_cast<std::int32_t>(*number);
    const VariableRange* range = control().families[*family].find(n);
    if (range == nullptr || range->meaning != Meaning::variable) return std::nullopt;
    return Variable{range->space, n};
}

void add_variable(const std::optional<Variable>& variable, NamedInBlock& names) {
    if (variable && std::ranges::find(names.variables, *variable) == names.variables.end())
        names.variables.push_back(*variable);
}

/// A text that is not closed takes in variables that were meant to stand after it.
void add_variables_in(std::string_view text, const OpenProgram& program, NamedInBlock& names) {
    for (auto at = text.find('#'); at != std::string_view::npos; at = text.find('#', at + 1)) {
        const auto end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz_0123456789", at + 1);
        add_variable(variable_named(text.substr(at, end == std::string_view::npos ? end : end - at), program),
                     names);
    }
}

} // namespace

NamedInBlock names_in(const OpenProgram& program, Span block) {
    const ErrorExplainer explainer(program.builder.program().text, block);
    const std::span<const Token> tokens = explainer.tokens();
    NamedInBlock names;
    constexpr int most_guesses = 16; // in noise every word is a riddle
    int guesses = 0;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const Token& token = tokens[i];
        const Token* next = i + 1 < tokens.size() ? &tokens[i + 1] : nullptr;
        const std::string_view written = explainer.text(token);
        const bool name = token.kind == TokenKind::variable || written.front() == '_';
        if (name) add_variable(variable_named(written, program), names);
        if (token.kind == TokenKind::unclosed_text) add_variables_in(written, program, names);
        if (token.kind != TokenKind::letters) continue;
        std::string meant = capitals_of(written);
        if (meant.size() > 2 && !is_keyword(meant) && guesses++ < most_guesses) meant = meant_by(meant);
        names.may_open_or_close |= is_structural(meant);
        const bool calls = meant == "L" && next != nullptr && next->kind == TokenKind::text;
        const bool leaves = meant == "M" && next != nullptr && next->kind == TokenKind::number;
        names.may_call_or_return |= meant == "RETURN" || calls || leaves;
    }
    return names;
}

} // namespace maclint::dinplus
