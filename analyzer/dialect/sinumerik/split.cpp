//! The splitter.
#include "analyzer/dialect/sinumerik/split.hpp"

#include "analyzer/dialect/sinumerik/lexer.hpp"

#include <optional>

namespace maclint::sinumerik {

void cut_block(std::string_view text, Offset begin, RawBlock& block) {
    block.comments.clear();
    block.open_comment = false;
    block.code = 0;
    const Offset first = skip_blanks(text, begin);
    block.span = {first, first};
    block.next = static_cast<Offset>(text.size());
    Lexer lexer(text, {first, block.next});
    while (const std::optional<Token> token = lexer.next()) {
        const Span span = token->span;
        if (token->kind == Token::Kind::end_of_line) {
            block.next = span.end;
            return;
        }
        if (token->kind == Token::Kind::comment)
            block.comments.push_back(span);
        else
            block.code += span.length();
        block.span.end = span.end;
    }
}

} // namespace maclint::sinumerik
