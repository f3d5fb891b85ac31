//! Conditions of tables on the words of a block: "A", "-A", "A=1|2", "A?1|2", "A!0", "A>1", "A<1".
#pragma once

#include "analyzer/program/model.hpp"

#include <algorithm>
#include <span>
#include <string_view>

namespace maclint {

/// One condition; the values stand with '|' between them.
struct WordCondition {
    std::string_view address;
    std::string_view values; ///< empty: any
    bool there = true;       ///< the word stands in the block
    bool or_missing = false;
    bool others = false; ///< the word has a value that is none of these
    bool above = false;  ///< or one that is more than the value, or less
    bool below = false;
};

[[nodiscard]] WordCondition condition_of(std::string_view text);

/// Whether something holds of a word, or may.
enum class Fits : unsigned char { yes, no, unknown };

/// Whether the word has one of the values; a calculated one may have any of them, or none.
[[nodiscard]] Fits fits(const Word& word, std::string_view values);

/// Whether all conditions, with blanks between them, hold of the words beside the code.
[[nodiscard]] Fits fits_beside(std::span<const Word> words, const Word& code, std::string_view conditions);

/// `visit(std::string_view)` for each part of a list, without the blanks around it; empty parts are left out.
template<class Visit>
void for_each_part(std::string_view list, char separator, const Visit& visit) {
    while (!list.empty()) {
        const std::size_t end = std::min(list.find(separator), list.size());
        std::string_view part = list.substr(0, end);
        while (part.starts_with(' ')) part.remove_prefix(1);
        while (part.ends_with(' ')) part.remove_suffix(1);
        if (!part.empty()) visit(part);
        list.remove_prefix(std::min(end + 1, list.size()));
    }
}

} // namespace maclint
