//! The tree that a block gets from the parse cache, held against its own.
#pragma once

#include "analyzer/dialect/raw_block.hpp"
#include "analyzer/syntax/parse_cache.hpp"

#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace maclint::test {

/// What a dialect does with the text of a block.
struct BlockLanguage {
    syntax::Grammar grammar;
    void (*make_cache_key)(std::string_view block, std::string& key);
    void (*cut_block)(std::string_view text, Offset begin, RawBlock& block);
};
extern const BlockLanguage fanuc_blocks, dinplus_blocks;

/// The blocks of a text that are short enough for the cache.
void add_blocks(const BlockLanguage& language, std::string_view text, std::set<std::string>& blocks);

/// Compares trees; each block goes through one cache, as in a run.
class TreeComparison {
  public:
    explicit TreeComparison(const BlockLanguage& language)
        : language_(language)
        , cache_(language.grammar) {}

    /// Nothing when the block has its own tree.
    [[nodiscard]] std::optional<std::string> difference(std::string block);

  private:
    const BlockLanguage& language_;
    syntax::ParseCache cache_;
    syntax::Tree own_;
    std::string key_;
};

} // namespace maclint::test
