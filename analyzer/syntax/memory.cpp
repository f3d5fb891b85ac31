//! Remembers parse trees within fixed bounds.
#include "analyzer/syntax/memory.hpp"

namespace maclint::syntax {
namespace {

/// Longer blocks seldom come twice.
constexpr std::size_t longest_remembered = 160;
/// Some megabytes a thread; past it everything is forgotten and learned again.
constexpr std::size_t most_remembered = 8192;

} // namespace

const Tree& TreeMemory::parse(std::string_view text, std::string_view shape) {
    if (text.size() > longest_remembered) {
        syntax::parse(grammar_, text, long_text_);
        return long_text_;
    }
    if (const auto known = maps_.find(shape); known != maps_.end()) return known->second;
    if (maps_.size() >= most_remembered) maps_.clear();
    Tree& tree = maps_[std::string(shape)];
    syntax::parse(grammar_, text, tree);
    tree.nodes.shrink_to_fit();
    return tree;
}

} // namespace maclint::syntax
