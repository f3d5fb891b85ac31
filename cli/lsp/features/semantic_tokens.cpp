//! Made of mentions: words and numbers are coloured by the editor's own grammar.
#include "cli/lsp/features/semantic_tokens.hpp"

#include "analyzer/program/tables.hpp"
#include "cli/lsp/features/read_document.hpp"
#include "cli/lsp/mentions/place.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace maclint::cli::lsp {
namespace {

constexpr std::size_t most_in_one_piece = std::size_t{4} << 20U; ///< bytes of text

/// Their order is the number of each.
enum class TokenType : std::uint8_t { variable, parameter, function, label, property };
constexpr std::array<std::string_view, 5> type_names{"variable", "parameter", "function", "label",
                                                     "property"};
constexpr std::array<std::string_view, 3> modifier_names{"declaration", "modification", "defaultLibrary"};
constexpr unsigned declares = 1, stores = 2, of_control = 4;

struct Token {
    Span span;
    TokenType type;
    unsigned modifiers;
};

unsigned modifiers_of(Mention::Role role) {
    return role == Mention::Role::declares ? declares : role == Mention::Role::stores ? stores : 0;
}

/// Of an argument the address alone: its value may hold names of its own.
Token token_of(const Program& program, const Mention& mention) {
    struct Typing {
        const Program& program;
        Token token;
        Token operator()(const Variable& variable) {
            token.type = program.is_formal(variable) && !program.formals.empty() ? TokenType::parameter
                                                                                 : TokenType::variable;
            return token;
        }
        Token operator()(const MachineValue& /*value*/) { return of_the_control(); }
        Token operator()(const ModalValueName& /*name*/) { return of_the_control(); }
        Token operator()(const BlockName& /*name*/) { return typed(TokenType::label); }
        Token operator()(const ProgramName& /*name*/) { return typed(TokenType::function); }
        Token operator()(const ArgumentName& name) {
            const auto& call = std::get<Call>(program.effects[name.call].what);
            const auto length = program.arguments_of(call)[name.place].address.size();
            token.span.end =
                token.span.begin + static_cast<Offset>(std::min<std::size_t>(length, token.span.length()));
            token.modifiers = 0;
            return typed(TokenType::property);
        }
        Token operator()(const ToolName& /*name*/) { return typed(TokenType::property); }
        Token typed(TokenType type) {
            token.type = type;
            return token;
        }
        Token of_the_control() {
            token.modifiers |= of_control;
            return typed(TokenType::variable);
        }
    };
    return std::visit(Typing{program, {mention.span, TokenType::variable, modifiers_of(mention.role)}},
                      mention.named);
}

std::vector<Token> tokens_in(const ReadText& text, Span wanted) {
    std::vector<Token> tokens;
    for (const Program& program : text.programs().programs)
        for_each_mention(program, [&](const Mention& mention) {
            if (mention.span.end < wanted.begin || wanted.end < mention.span.begin) return;
            if (const Token token = token_of(program, mention); !token.span.empty()) tokens.push_back(token);
        });
    std::ranges::sort(tokens, {},
                      [](const Token& token) { return std::pair(token.span.begin, token.span.end); });
    return tokens;
}

/// Five numbers a token, lines and columns counted from the token before. What overlaps the token before, or
/// goes over a line's end, is left out.
Json encoded(const ReadText& text, const std::vector<Token>& tokens) {
    Json data = Json::array();
    std::int64_t line = 0, column = 0;
    Offset end = 0;
    for (const Token& token : tokens) {
        if (token.span.begin < end) continue;
        const Json from = text.lines.position(token.span.begin), to = text.lines.position(token.span.end);
        if (from["line"] != to["line"]) continue;
        const auto at_line = from["line"].get<std::int64_t>(), at = from["character"].get<std::int64_t>();
        data.push_back(at_line - line);
        data.push_back(at_line == line ? at - column : at);
        data.push_back(to["character"].get<std::int64_t>() - at);
        data.push_back(static_cast<int>(token.type));
        data.push_back(token.modifiers);
        line = at_line;
        column = at;
        end = token.span.end;
    }
    return {{"data", std::move(data)}};
}

} // namespace

Json semantic_tokens(Session& session, const Json& params) {
    const auto text = read_document(session, params);
    if (text == nullptr || text->source().size() > most_in_one_piece) return {{"data", Json::array()}};
    return encoded(*text, tokens_in(*text, {0, text->source().size()}));
}

Json semantic_tokens_in_range(Session& session, const Json& params) {
    const auto text = read_document(session, params);
    if (text == nullptr) return {{"data", Json::array()}};
    return encoded(*text, tokens_in(*text, text->lines.span(member(params, "range"))));
}

Json semantic_tokens_options() {
    return {{"legend", {{"tokenTypes", type_names}, {"tokenModifiers", modifier_names}}},
            {"full", true},
            {"range", true}};
}

} // namespace maclint::cli::lsp
