//! One pass over the tokens of a block.
#include "analyzer/dialect/sinumerik/plausible.hpp"

#include "analyzer/dialect/sinumerik/lexer.hpp"

#include <optional>
#include <utility>

namespace maclint::sinumerik {

bool is_plausible(std::string_view text, Span block) {
    using TokenKind = Token::Kind;
    constexpr std::size_t most_errors = 24;
    constexpr std::size_t most_open = 48;
    std::size_t errors = 0;
    std::size_t open = 0;
    bool operand = false; // what stands before ends a value
    Lexer lexer(text, block);
    while (const std::optional<Token> token = lexer.next()) {
        const char first = text[token->span.begin];
        switch (token->kind) {
        case TokenKind::open:
            ++open;
            operand = false;
            break;
        case TokenKind::close:
            if (open == 0) ++errors;
            open -= open == 0 ? 0 : 1;
            operand = true;
            break;
        case TokenKind::sign:
            // Places of a list may be empty: `(,,1`.
            if (!std::exchange(operand, false) && first != ',') ++errors;
            if (first == '?' || first == '!' || first == '@' || first == '{' || first == '}') ++errors;
            break;
        case TokenKind::other:
        case TokenKind::unclosed_text: ++errors; break;
        case TokenKind::comment:
        case TokenKind::end_of_line: break;
        default: operand = true; break;
        }
        if (errors > most_errors || open > most_open) return false;
    }
    return true;
}

} // namespace maclint::sinumerik
