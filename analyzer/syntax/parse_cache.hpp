//! Parse trees of blocks seen before: NC programs repeat the same few blocks with other numbers.
#pragma once

#include "analyzer/source/text_hash.hpp"
#include "analyzer/syntax/tree.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace maclint::syntax {

/// Keeps trees by key. The key of a block is a text of the same length with the same tree, in which whatever
/// the grammar does not look at is made equal (digits, the text of comments); the dialect's lexer makes it.
/// It is the key that is parsed: which tree a block gets never depends on the blocks before it.
class ParseCache {
  public:
    explicit ParseCache(Grammar grammar)
        : grammar_(grammar) {}

    /// The tree of the blocks with that key if it is there.
    [[nodiscard]] const Tree* find(std::string_view key) const;
    /// The tree of the blocks with that key, good until the next call.
    [[nodiscard]] const Tree& parse(std::string_view key);

  private:
    Grammar grammar_;
    std::unordered_map<std::string, Tree, TextHash, std::equal_to<>> trees_;
    Tree long_text_;
};

} // namespace maclint::syntax
