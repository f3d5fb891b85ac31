//! The tokenizer.
#include "analyzer/dialect/dinplus/tokens.hpp"

#include <algorithm>

namespace maclint::dinplus {
namespace {

using Kind = Token::Kind;

/// Longer texts are cut: nobody wrote them by hand.
constexpr Offset longest_looked_at = 64 * 1024;

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

class Cutter {
  public:
    Cutter(std::string_view file, Span block)
        : text_(file.substr(0, std::min(block.end, block.begin + longest_looked_at)))
        , at_(block.begin) {}

    std::vector<Token> run() {
        while (at_ < text_.size()) {
            const char c = text_[at_];
            const Offset begin = at_;
            if (c == ' ' || c == '\t' || c == '\n' || c == '\r')
                ++at_;
            else
                tokens_.push_back({cut(c), {begin, at_}});
        }
        return std::move(tokens_);
    }

  private:
    template<class Is>
    void pass(const Is& is) {
        while (at_ < text_.size() && is(text_[at_])) ++at_;
    }

    Kind cut(char c) {
        if (is_letter(c)) return pass(is_letter), Kind::letters;
        if (is_digit(c) || c == '.')
            return pass([](char d) { return is_digit(d) || d == '.'; }), Kind::number;
        ++at_;
        switch (c) {
        case '#': return pass([](char d) { return is_letter(d) || is_digit(d); }), Kind::variable;
        case '"': {
            pass([](char d) { return d != '"' && d != '\n' && d != '\r'; });
            const bool closed = at_ < text_.size() && text_[at_] == '"';
            if (closed) ++at_;
            return closed ? Kind::text : Kind::unclosed_text;
        }
        case '[':
            pass([](char d) { return d != ']'; });
            if (at_ < text_.size()) ++at_;
            return Kind::comment;
        case '(': return Kind::open;
        case ')': return Kind::close;
        case '+':
        case '-':
        case '*':
        case '/':
        case '=':
        case '<':
        case '>':
        case ',': return Kind::sign;
        default: return Kind::other;
        }
    }

    std::string_view text_;
    Offset at_;
    std::vector<Token> tokens_;
};

} // namespace

std::vector<Token> tokens_of(std::string_view file, Span block) { return Cutter(file, block).run(); }

} // namespace maclint::dinplus
