//! Conditions of rows on the words of a block: "A", "-A", "A=1|2", "A?1|2", "A!0".
#pragma once

#include "analyzer/queries/block_words.hpp"

#include <string>
#include <string_view>

namespace maclint {

/// One condition; the values stand with '|' between them.
struct RowCondition {
    std::string_view address;
    std::string_view values; ///< empty: any
    bool there = true;       ///< the word stands in the block
    bool or_missing = false;
    bool others = false; ///< the word has a value that is none of these
};

[[nodiscard]] RowCondition condition_of(std::string_view text);

/// Whether the word has one of the values; a calculated one may have any of them, or none.
enum class Fits : unsigned char { yes, no, unknown };
[[nodiscard]] Fits fits(const Word& word, std::string_view values);

/// Whether all conditions surely hold beside the code.
[[nodiscard]] bool holds_beside(const queries::WordsOfBlock& block, const Word& code,
                                std::string_view conditions);

/// "Q of 1 or 2", "no A".
[[nodiscard]] std::string in_words(const RowCondition& condition);
/// "With Q of 1 or 2 and no A".
[[nodiscard]] std::string conditions_in_words(std::string_view conditions);

} // namespace maclint
