//! Words beside a code that name blocks.
#pragma once

#include "analyzer/program/block_view.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

namespace maclint::cli {

/// What a word that names a block names it in.
struct NamedIn {
    /// Program number of a program that is called from that block on; nothing: the program of the word.
    std::optional<std::int64_t> program;
};

/// `visit(word, where)` for the words of the program that name blocks beside what jumps and returns do: P and
/// Q of cycles that take a contour (G71), NS and NE, Q of a call that begins at a block (M98 P9100 Q20).
void for_each_naming_word(const Program& program,
                          const std::function<void(const Word&, const NamedIn&)>& visit);

} // namespace maclint::cli
