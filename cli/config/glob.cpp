//! Matching without recursion: a star that turns out too short is made one longer, only the last one needs
//! it.
#include "cli/config/glob.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace maclint::cli {
namespace {

/// Length of the set `[…]` at the head of `pattern`, 0 when it is not closed.
std::size_t set_length(std::string_view pattern) {
    std::size_t end = 1;
    if (end < pattern.size() && pattern[end] == '!') ++end;
    if (end < pattern.size() && pattern[end] == ']') ++end;
    while (end < pattern.size() && pattern[end] != ']') ++end;
    return end < pattern.size() ? end + 1 : 0;
}

bool in_set(std::string_view set, char c) {
    set = set.substr(1, set.size() - 2);
    const bool inverted = set.starts_with('!');
    if (inverted) set.remove_prefix(1);
    bool found = false;
    while (!set.empty()) {
        const bool range = set.size() > 2 && set[1] == '-';
        found = found || (range ? set[0] <= c && c <= set[2] : set[0] == c);
        set.remove_prefix(range ? 3 : 1);
    }
    return found != inverted;
}

/// How much of `pattern` takes the character, 0 when its head does not match it.
std::size_t take(std::string_view pattern, char c) {
    if (pattern.empty()) return 0;
    if (pattern.front() == '?') return 1;
    if (pattern.front() == '[')
        if (const std::size_t length = set_length(pattern))
            return in_set(pattern.substr(0, length), c) ? length : 0;
    return pattern.front() == c ? 1 : 0;
}

} // namespace

bool matches_name(std::string_view pattern, std::string_view name) {
    std::size_t p = 0;
    std::size_t star = std::string_view::npos;
    std::size_t star_name = 0;
    for (std::size_t n = 0; n < name.size();) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = ++p;
            star_name = n;
        } else if (const std::size_t length = take(pattern.substr(p), name[n])) {
            p += length;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star;
            n = ++star_name;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

std::vector<std::string_view> names_of(std::string_view path) {
    std::vector<std::string_view> names;
    while (!path.empty()) {
        const auto name = path.substr(0, path.find('/'));
        if (!name.empty() && name != ".") names.push_back(name);
        path.remove_prefix(name.size() == path.size() ? name.size() : name.size() + 1);
    }
    return names;
}

bool matches_names(std::span<const std::string> pattern, std::span<const std::string_view> names) {
    std::size_t p = 0;
    std::size_t star = std::string_view::npos;
    std::size_t star_name = 0;
    std::size_t n = 0;
    while (true) {
        if (p == pattern.size() && n == names.size()) return n > 0;
        if (p < pattern.size() && pattern[p] == "**") {
            star = ++p;
            star_name = n;
            if (p == pattern.size()) return n < names.size();
        } else if (p < pattern.size() && n < names.size() && matches_name(pattern[p], names[n])) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos && star_name < names.size()) {
            p = star;
            n = ++star_name;
        } else {
            return false;
        }
    }
}

} // namespace maclint::cli
