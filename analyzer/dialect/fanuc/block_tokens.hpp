//! The tokens of a block, and what they say.
#pragma once

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/fanuc/lexer.hpp"
#include "analyzer/program/syntax_error.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace maclint::fanuc {

/// Text and tokens have to outlive it.
class BlockTokens {
  public:
    BlockTokens(std::string_view text, std::span<const Token> tokens)
        : text_(text)
        , tokens_(tokens) {}

    [[nodiscard]] std::size_t size() const { return tokens_.size(); }
    [[nodiscard]] Span span(std::size_t i) const { return tokens_[i].span; }
    [[nodiscard]] bool is(std::size_t i, Token::Kind kind) const {
        return i < tokens_.size() && tokens_[i].kind == kind;
    }
    [[nodiscard]] std::string_view written(std::size_t i) const {
        return text_.substr(tokens_[i].span.begin, tokens_[i].span.length());
    }
    [[nodiscard]] std::string capitals(std::size_t i) const {
        return is(i, Token::Kind::letters) ? without_blanks(written(i)) : std::string();
    }
    [[nodiscard]] bool touch(std::size_t i) const { return span(i).end == span(i + 1).begin; }

    /// The first one behind skip marks.
    [[nodiscard]] std::size_t after_marks() const {
        std::size_t i = 0;
        while (i < size() && written(i) == "/") i += is(i + 1, Token::Kind::number) ? 2 : 1;
        return i;
    }
    /// The first one behind skip marks and sequence numbers.
    [[nodiscard]] std::size_t after_head() const {
        std::size_t i = after_marks();
        while (capitals(i) == "N" && is(i + 1, Token::Kind::number)) i += 2;
        return i;
    }
    /// Behind the variable at `i`, `#5` or `#[#1+2]`; `i` where none stands.
    [[nodiscard]] std::size_t after_variable(std::size_t i) const {
        if (is(i, Token::Kind::variable)) return i + 1;
        if (!is(i, Token::Kind::sharp) || !is(i + 1, Token::Kind::open)) return i;
        int depth = 0;
        for (std::size_t at = i + 1; at < size(); ++at) {
            depth += is(at, Token::Kind::open) ? 1 : is(at, Token::Kind::close) ? -1 : 0;
            if (depth == 0) return at + 1;
        }
        return i;
    }

    [[nodiscard]] SyntaxError error(Span span, std::string expected, std::string_view fault) const {
        constexpr std::size_t longest_shown = 60;
        std::string subject(text_.substr(span.begin, std::min<std::size_t>(span.length(), longest_shown)));
        if (span.length() > longest_shown) subject += "...";
        SyntaxError error{SyntaxErrorKind::unreadable, span, std::move(subject), std::move(expected)};
        error.fault = fault;
        return error;
    }

  private:
    std::string_view text_;
    std::span<const Token> tokens_;
};

} // namespace maclint::fanuc
