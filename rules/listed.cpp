//! Puts commas between words.
#include "rules/listed.hpp"

#include <cstddef>

namespace maclint::rules {

std::string listed(std::span<const std::string> words, std::string_view last) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i != 0) text += i + 1 == words.size() ? last : std::string_view(", ");
        text += words[i];
    }
    return text;
}

} // namespace maclint::rules
