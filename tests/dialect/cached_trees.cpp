//! Cuts blocks as the readers do.
#include "tests/dialect/cached_trees.hpp"

#include "analyzer/dialect/dinplus/kinds.hpp"
#include "analyzer/dialect/dinplus/lexer.hpp"
#include "analyzer/dialect/dinplus/split.hpp"
#include "analyzer/dialect/fanuc/kinds.hpp"
#include "analyzer/dialect/fanuc/lexer.hpp"
#include "analyzer/dialect/fanuc/split.hpp"

#include <algorithm>

namespace maclint::test {
namespace {

std::string printed(const BlockLanguage& language, const syntax::Tree& tree) {
    std::string out = syntax::s_expression(language.grammar, tree);
    for (const syntax::Node& node : tree.nodes)
        out += ' ' + std::to_string(node.span.begin) + '-' + std::to_string(node.span.end);
    return out;
}

} // namespace

const BlockLanguage fanuc_blocks{fanuc::grammar, fanuc::make_cache_key,
                                 [](std::string_view text, Offset begin, RawBlock& block) {
                                     fanuc::cut_block(text, begin, fanuc::Reading::takes, block);
                                 }};
const BlockLanguage dinplus_blocks{dinplus::grammar, dinplus::make_cache_key, dinplus::cut_block};

void add_blocks(const BlockLanguage& language, std::string_view text, std::set<std::string>& blocks) {
    constexpr Offset longest = 160;
    RawBlock raw{};
    for (Offset at = 0; at < text.size(); at = std::max(raw.next, at + 1)) {
        language.cut_block(text, at, raw);
        if (!raw.span.empty() && raw.span.length() <= longest)
            blocks.emplace(text.substr(raw.span.begin, raw.span.length()));
    }
}

std::optional<std::string> TreeComparison::difference(std::string block) {
    language_.make_cache_key(block, key_);
    const std::string both = "block: " + block + "\nkey:   " + key_;
    if (key_.size() != block.size()) return "the key has another length\n" + both;
    // NUL is blank tape: in a comment or text it is a byte like any other, where the grammar takes it for
    // the end.
    for (std::size_t i = 0; i < block.size(); ++i)
        if (block[i] == '\0' && key_[i] != '\0') block[i] = '-';
    const syntax::Tree& cached = cache_.parse(key_);
    syntax::parse(language_.grammar, block, own_);
    if (cached.has_error != own_.has_error) return "only one is in error\n" + both;
    if (own_.has_error) return std::nullopt; // nothing is read out of the recovery but where it begins
    const std::string found = printed(language_, cached);
    const std::string own = printed(language_, own_);
    return found == own ? std::nullopt : std::optional(both + "\ncached: " + found + "\nown:    " + own);
}

} // namespace maclint::test
