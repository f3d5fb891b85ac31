//! Digits become '0', the inside of comments and texts becomes '-'.
#include "analyzer/dialect/dinplus/shape.hpp"

#include <algorithm>

namespace maclint::dinplus {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Begins and ends the descriptions of transfer values: a token of its own.
constexpr std::string_view description_mark = "[//]";

} // namespace

void shape_of(std::string_view block, std::string& shape) {
    shape.assign(block);
    for (std::size_t i = 0; i < shape.size(); ++i) {
        if (is_digit(shape[i])) {
            shape[i] = '0';
        } else if (shape[i] == '[') {
            if (block.substr(i).starts_with(description_mark)) continue;
            while (i + 1 < shape.size() && shape[i + 1] != ']') shape[++i] = '-';
        } else if (shape[i] == '"') {
            // Only a text that is closed on its line: elsewhere a quote may mean nothing.
            const std::size_t end = block.find_first_of("\"\r\n", i + 1);
            if (end == std::string_view::npos || block[end] != '"') continue;
            std::fill(shape.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                      shape.begin() + static_cast<std::ptrdiff_t>(end), '-');
            i = end;
        }
    }
}

} // namespace maclint::dinplus
