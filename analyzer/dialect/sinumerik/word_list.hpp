//! Lists of words in one text, as tables hold them.
#pragma once

#include <algorithm>
#include <string_view>

namespace maclint::sinumerik {

/// Visits the words of a list, between which single blanks stand.
template<class Visit>
void for_each_word(std::string_view list, const Visit& visit) {
    while (!list.empty()) {
        const std::size_t end = std::min(list.find(' '), list.size());
        visit(list.substr(0, end));
        list.remove_prefix(std::min(end + 1, list.size()));
    }
}

} // namespace maclint::sinumerik
