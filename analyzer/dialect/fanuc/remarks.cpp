//! Searches remarks for the call of a program.
#include "analyzer/dialect/fanuc/remarks.hpp"

#include "analyzer/dialect/fanuc/lexer.hpp"
#include "analyzer/dialect/numbers.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace maclint::fanuc {
namespace {

/// A remark that describes the program stands at its head.
constexpr std::size_t longest_head = 4000;

/// Whether `P` and the number come next, blanks between them left out.
bool names_program(std::string_view text, std::int64_t number) {
    const auto skip = [&] {
        while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    };
    skip();
    if (text.empty() || to_capital(text.front()) != 'P') return false;
    text.remove_prefix(1);
    skip();
    const auto* const end = std::ranges::find_if_not(text, is_digit);
    const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    return !digits.empty() && read_integer(digits) == number;
}

bool calls(std::string_view remark, std::int64_t number) {
    for (auto six = remark.find('6', 1); six != std::string_view::npos; six = remark.find('6', six + 1)) {
        if (six + 2 >= remark.size()) return false;
        const bool code =
            to_capital(remark[six - 1]) == 'G' && (remark[six + 1] == '5' || remark[six + 1] == '6');
        if (code && names_program(remark.substr(six + 2), number)) return true;
    }
    return false;
}

} // namespace

bool shows_own_call(std::string_view text, std::int64_t number) {
    text = text.substr(0, longest_head);
    for (auto at = text.find('('); at != std::string_view::npos; at = text.find('(', at)) {
        const Offset end = after_comment(text, static_cast<Offset>(at));
        if (calls(text.substr(at, end - at), number)) return true;
        at = end;
    }
    return false;
}

} // namespace maclint::fanuc
