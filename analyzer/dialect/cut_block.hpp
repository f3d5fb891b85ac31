//! A block cut into the tokens of its dialect, with what every diagnosis asks of them.
#pragma once

#include "analyzer/program/syntax_error.hpp"
#include "analyzer/source/span.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint {

/// `Token` has the span of its text.
template<class Token>
class CutBlock {
  public:
    CutBlock(std::string_view text, std::vector<Token> tokens)
        : text_(text)
        , tokens_(std::move(tokens)) {}

    [[nodiscard]] std::span<const Token> tokens() const { return tokens_; }
    [[nodiscard]] std::string_view text(const Token& token) const {
        return text_.substr(token.span.begin, token.span.length());
    }

  protected:
    /// nullptr behind the last.
    [[nodiscard]] const Token* at(std::size_t index) const {
        return index < tokens_.size() ? &tokens_[index] : nullptr;
    }

    std::string_view text_; ///< of the whole program
    std::vector<Token> tokens_;
};

} // namespace maclint
