//! Reads letter and number wherever they stand for themselves.
#include "cli/report/mentions.hpp"

namespace maclint::cli {
namespace {

bool is_figure(char c) { return c >= '0' && c <= '9'; }
bool is_of_a_word(char c) { return is_figure(c) || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

/// The number at the beginning of a text: "01.1" of "01.1 X". A full stop that ends a sentence is none of it.
std::string_view number_at(std::string_view text) {
    std::size_t end = 0;
    while (end < text.size() &&
           (is_figure(text[end]) || (text[end] == '.' && end + 1 < text.size() && is_figure(text[end + 1]))))
        ++end;
    return text.substr(0, end);
}

std::string_view shortened(std::string_view number) {
    while (number.size() > 1 && number.front() == '0' && number[1] != '.') number.remove_prefix(1);
    return number;
}

} // namespace

bool mentions_code(std::string_view text, std::string_view code) {
    const std::string_view wanted = shortened(code.substr(1));
    for (auto at = text.find(code.front()); at != std::string_view::npos;
         at = text.find(code.front(), at + 1)) {
        if (at > 0 && is_of_a_word(text[at - 1])) continue;
        const std::string_view number = number_at(text.substr(at + 1));
        const auto end = at + 1 + number.size();
        if (!number.empty() && shortened(number) == wanted &&
            (end == text.size() || !is_of_a_word(text[end])))
            return true;
    }
    return false;
}

} // namespace maclint::cli
