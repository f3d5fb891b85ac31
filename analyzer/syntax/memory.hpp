//! Parse trees of blocks seen before: NC programs repeat the same few shapes with other numbers.
#pragma once

#include "analyzer/source/text_hash.hpp"
#include "analyzer/syntax/tree.hpp"

#include <functional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace maclint::syntax {

/// Remembers trees by shape. A shape is a text of the same length whose tree is the same by the grammar's
/// rules, with whatever does not matter (digits, comment text) made equal; the dialect makes it.
class TreeMemory {
  public:
    explicit TreeMemory(Grammar grammar)
        : grammar_(grammar) {}

    /// The tree of `text`, good until the next call.
    [[nodiscard]] const Tree& parse(std::string_view text, std::string_view shape);

  private:
    Grammar grammar_;
    std::unordered_map<std::string, Tree, TextHash, std::equal_to<>> maps_;
    Tree long_text_;
};

} // namespace maclint::syntax
