//! The lines of a text that hold one of a few letters, found without a look at the others.
#pragma once

#include "analyzer/source/span.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace maclint {

/// `visit(Span)` for each line of the part, its end left out, that holds one of the letters; lines end at LF
/// or CR.
template<class Visit>
void for_each_line_with(std::string_view letters, std::string_view text, Span part, const Visit& visit) {
    constexpr std::string_view line_ends = "\n\r";
    const std::string_view whole = text.substr(0, part.end);
    std::vector<std::size_t> next(letters.size(), 0); ///< place of each letter, not before `at`
    for (std::size_t at = part.begin; at < whole.size();) {
        std::size_t first = std::string_view::npos;
        for (std::size_t i = 0; i < letters.size(); ++i) {
            if (next[i] < at || next[i] == 0) next[i] = whole.find(letters[i], at);
            first = std::min(first, next[i]);
        }
        if (first == std::string_view::npos) return;
        const std::size_t before = whole.substr(at, first - at).find_last_of(line_ends);
        const std::size_t begin = before == std::string_view::npos ? at : at + before + 1;
        const std::size_t end = std::min(whole.find_first_of(line_ends, first), whole.size());
        visit(Span{static_cast<Offset>(begin), static_cast<Offset>(end)});
        at = end + 1;
    }
}

} // namespace maclint
