//! Finds the cause of a syntax error in a block's text; the parser's recovery is only asked where the text
//! ran out.
#include "analyzer/dialect/dinplus/diagnose.hpp"

#include "analyzer/dialect/dinplus/keywords.hpp"
#include "analyzer/dialect/dinplus/kinds.hpp"
#include "analyzer/dialect/dinplus/sections.hpp"
#include "analyzer/dialect/dinplus/tokens.hpp"
#include "analyzer/dialect/numbers.hpp"

#include <algorithm>
#include <array>

namespace maclint::dinplus {
namespace {

using TokenKind = Token::Kind;

constexpr std::size_t longest_shown = 60;

constexpr bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

std::string shown(std::string_view text) {
    if (text.size() <= longest_shown) return std::string(text);
    return std::string(text.substr(0, longest_shown)) + "...";
}

/// The tokens of a block and questions about them.
class Clues {
  public:
    Clues(std::string_view text, Span block)
        : text_(text)
        , tokens_(tokens_of(text, block)) {}

    [[nodiscard]] std::span<const Token> tokens() const { return tokens_; }
    [[nodiscard]] std::string_view text(const Token& token) const {
        return text_.substr(token.span.begin, token.span.length());
    }

    [[nodiscard]] std::optional<Irregularity> unclosed_text() const {
        const auto token = std::ranges::find(tokens_, TokenKind::unclosed_text, &Token::kind);
        if (token == tokens_.end()) return std::nullopt;
        return make(Irregular::unreadable, *token, "a '\"' at the end of the text");
    }

    [[nodiscard]] std::optional<Irregularity> bracket_mismatch() const {
        std::vector<const Token*> open;
        for (const Token& token : tokens_) {
            if (token.kind == TokenKind::open) open.push_back(&token);
            if (token.kind != TokenKind::close) continue;
            if (open.empty()) return make(Irregular::bracket_mismatch, token, "a '(' is missing before it");
            open.pop_back();
        }
        if (open.empty()) return std::nullopt;
        return make(Irregular::bracket_mismatch, *open.back(), "its ')' is missing");
    }

    /// Capital words of three or more letters are keywords or nothing; two of them can be addresses.
    [[nodiscard]] std::optional<Irregularity> unknown_keyword() const {
        for (const Token& token : tokens_) {
            if (token.kind != TokenKind::letters || token.span.length() < 3) continue;
            if (!std::ranges::all_of(text(token), [](char c) { return is_capital(c) || c == '_'; })) continue;
            const std::string capitals = capitals_of(text(token));
            if (capitals.front() == '_' || capitals == "HID" || is_keyword(capitals)) continue;
            return make(Irregular::unknown_keyword, token, meant_by(capitals));
        }
        return std::nullopt;
    }

  private:
    [[nodiscard]] Irregularity make(Irregular kind, const Token& token, std::string cure) const {
        return {kind, token.span, shown(text(token)), std::move(cure)};
    }

    std::string_view text_;
    std::vector<Token> tokens_;
};

Irregularity unreadable(std::string_view text, Span block, const syntax::Tree& tree) {
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
    return {Irregular::unreadable, span, shown(text.substr(span.begin, span.length())), std::move(expected)};
}

} // namespace

void diagnose(std::string_view text, Span block, const syntax::Tree& tree,
              std::vector<Irregularity>& irregularities) {
    const Clues clues(text, block);
    for (const auto cause : {&Clues::unclosed_text, &Clues::bracket_mismatch, &Clues::unknown_keyword}) {
        if (std::optional<Irregularity> found = (clues.*cause)()) {
            irregularities.push_back(std::move(*found));
            return;
        }
    }
    irregularities.push_back(unreadable(text, block, tree));
}

bool is_plausible(std::string_view text, Span block) {
    constexpr std::size_t most_stumbles = 24;
    std::size_t stumbles = 0;
    bool operand = false; // what stands before ends a value
    for (const Token& token : tokens_of(text, block)) {
        switch (token.kind) {
        case TokenKind::sign: {
            const char sign = text[token.span.begin];
            const bool may_begin = sign == '-' || sign == '+' || sign == '>' || sign == '=' || sign == '/';
            if (!operand && !may_begin) ++stumbles;
            if (sign == '=' || (!operand && may_begin)) ++stumbles;
            operand = false;
            break;
        }
        case TokenKind::close:
            if (!operand) ++stumbles;
            operand = true;
            break;
        case TokenKind::open: operand = false; break;
        case TokenKind::other:
        case TokenKind::unclosed_text: ++stumbles; break;
        case TokenKind::variable:
            if (token.span.length() == 1 || operand) ++stumbles;
            operand = true;
            break;
        case TokenKind::comment: break;
        case TokenKind::letters: operand = false; break;
        default: operand = true; break;
        }
        if (stumbles > most_stumbles) return false;
    }
    return true;
}

UnreadableBlock names_in(const Program& program, Span block) {
    const Clues clues(program.text, block);
    const std::span<const Token> tokens = clues.tokens();
    UnreadableBlock names{{}, {}, false, false};
    for (std::size_t i = 0; i < tokens.size(); ++i) {
        const Token& token = tokens[i];
        const Token* next = i + 1 < tokens.size() ? &tokens[i + 1] : nullptr;
        const std::string_view written = clues.text(token);
        if (token.kind == TokenKind::variable && written.size() > 2 && next != nullptr &&
            clues.text(*next) == "=") {
            const std::optional<FamilyId> family = family_of(written[1]);
            const std::optional<std::int64_t> number = read_integer(written.substr(2));
            if (!family || !number || *number > INT32_MAX) continue;
            const auto n = static_cast<std::int32_t>(*number);
            const VariableRange* range = program.control->families[*family].find(n);
            if (range != nullptr && range->meaning == Meaning::place)
                names.may_write.push_back({range->space, n});
        }
        if (token.kind != TokenKind::letters) continue;
        const std::string capitals = capitals_of(written);
        const std::string meant = is_keyword(capitals) ? capitals : meant_by(capitals);
        names.may_open_or_close |= is_structural(meant);
        const bool calls = capitals == "L" && next != nullptr && next->kind == TokenKind::text;
        const bool leaves = capitals == "M" && next != nullptr && next->kind == TokenKind::number;
        names.may_call_or_return |= meant == "RETURN" || calls || leaves;
    }
    return names;
}

} // namespace maclint::dinplus
