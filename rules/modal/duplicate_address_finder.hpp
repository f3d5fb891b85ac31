//! Of MAC559: addresses that stand twice in a block.
#pragma once

#include "analyzer/queries/words/block_words.hpp"

#include <string_view>
#include <vector>

namespace maclint::rules {

/// An address of a block, and the first and the last of its words that have a value.
struct RepeatedAddress {
    std::string_view address;
    const Word* first;
    const Word* last;
    const Word* other; ///< the first that is not written as the last one; nullptr: all are
};

/// In the order of their first words. None of a block that has alternatives, or calls twice (MAC423).
[[nodiscard]] std::vector<RepeatedAddress> repeated_addresses(const queries::WordsOfBlock& block);

} // namespace maclint::rules
