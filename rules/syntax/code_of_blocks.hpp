//! The code of a program's blocks, comments left out.
#pragma once

#include "analyzer/program/block_view.hpp"

#include <optional>
#include <string_view>

namespace maclint::rules {

/// The first place in code that `find(code)` tells, a position in the text it is given or npos, of a language
/// whose comments stand in ( ). `find` is given what stands between comments.
template<class Find>
std::optional<Offset> find_in_code(const Program& program, const Find& find) {
    std::optional<Offset> found;
    for_each_block(program, [&](const BlockView& block) {
        const std::string_view text = program.slice(block.span);
        for (std::size_t at = 0; at < text.size() && !found;) {
            const std::size_t open = text.find('(', at);
            const std::string_view code = text.substr(at, open == std::string_view::npos ? open : open - at);
            const std::size_t place = find(code);
            if (place != std::string_view::npos) found = block.span.begin + static_cast<Offset>(at + place);
            const std::size_t close = open == std::string_view::npos ? open : text.find(')', open);
            at = close == std::string_view::npos ? text.size() : close + 1;
        }
        return !found.has_value();
    });
    return found;
}

} // namespace maclint::rules
