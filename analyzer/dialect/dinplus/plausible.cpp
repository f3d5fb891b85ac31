//! One pass over the tokens of a block.
#include "analyzer/dialect/dinplus/plausible.hpp"

#include "analyzer/dialect/dinplus/lexer.hpp"

#include <optional>
#include <utility>

namespace maclint::dinplus {

using Kind = Token::Kind;

bool is_plausible(std::string_view text, Span block) {
    constexpr std::size_t most_parse_errors = 24;
    constexpr std::size_t most_open = 48;
    constexpr std::size_t most_keywords = 64;
    constexpr Offset longest_address = 3; // HID, XKi
    std::size_t parse_errors = 0;
    std::size_t open = 0;
    std::size_t keywords = 0;
    bool operand = false; // what stands before ends a value
    bool closed = false;  // that is a parenthesis
    bool address = false; // letters that a value follows stand before
    char sign = '\0';     // the operator that stands before
    Lexer lexer(text, block);
    while (const std::optional<Token> next = lexer.next()) {
        const Token& token = *next;
        const char first = text[token.span.begin];
        const char before = std::exchange(sign, '\0');
        const bool after_close = std::exchange(closed, token.kind == Kind::close);
        const bool after_address = std::exchange(address, false);
        switch (token.kind) {
        case Kind::sign: {
            const bool may_begin =
                first == '-' || first == '+' || first == '>' || first == '=' || first == '/';
            const bool begins_value = after_address && (first == '-' || first == '+');
            if (!operand && !may_begin) ++parse_errors;
            if (first == '=' || (!operand && may_begin && !begins_value)) ++parse_errors;
            operand = false;
            sign = first;
            break;
        }
        case Kind::close:
            if (!operand || open == 0) ++parse_errors;
            open -= open == 0 ? 0 : 1;
            operand = true;
            break;
        case Kind::open:
            if (operand && after_close) ++parse_errors; // `(1)(1)`
            ++open;
            operand = false;
            break;
        case Kind::other:
        case Kind::unclosed_text: ++parse_errors; break;
        case Kind::variable:
            if (token.span.length() == 1 || operand) ++parse_errors;
            operand = true;
            break;
        case Kind::comment:
        case Kind::unclosed_comment:
        case Kind::foreign_comment:
        case Kind::header:
        case Kind::program_name:
        case Kind::end_of_line: break;
        case Kind::letters:
            // An address where an operand is due.
            if (before != '\0' && before != ',' && first != '_' && token.span.length() < 3) ++parse_errors;
            if (token.span.length() > 2 || text.substr(token.span.begin, 2) == "IF") ++keywords;
            operand = first == '_';
            address = before == '\0' && !operand && token.span.length() <= longest_address;
            break;
        default: operand = true; break;
        }
        if (parse_errors > most_parse_errors || open > most_open || keywords > most_keywords) return false;
    }
    return true;
}

} // namespace maclint::dinplus
