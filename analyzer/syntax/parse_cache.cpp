//! Keeps parse trees within fixed bounds.
#include "analyzer/syntax/parse_cache.hpp"

namespace maclint::syntax {
namespace {

/// Longer blocks seldom come twice.
constexpr std::size_t longest_kept = 160;
/// Some megabytes a thread; past it everything is dropped and parsed again.
constexpr std::size_t most_kept = 8192;

} // namespace

const Tree* ParseCache::find(std::string_view key) const {
    if (key.size() > longest_kept) return nullptr;
    const auto known = trees_.find(key);
    return known == trees_.end() ? nullptr : &known->second;
}

const Tree& ParseCache::parse(std::string_view key) {
    if (key.size() > longest_kept) {
        syntax::parse(grammar_, key, long_text_);
        return long_text_;
    }
    if (const Tree* known = find(key)) return *known;
    if (trees_.size() >= most_kept) trees_.clear();
    Tree& tree = trees_[std::string(key)];
    syntax::parse(grammar_, key, tree);
    tree.nodes.shrink_to_fit();
    return tree;
}

} // namespace maclint::syntax
