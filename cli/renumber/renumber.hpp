//! New numbers for the blocks of a file, and for all that names them.
#pragma once

#include "cli/renumber/block_numbers.hpp"
#include "cli/renumber/numbering.hpp"
#include "rules/finding.hpp"

#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace maclint::cli {

/// The edits that number the blocks of each space in the order of the text; blocks without a number get none.
/// They are in the order of the text and touch not.
[[nodiscard]] std::variant<std::vector<Edit>, UnsafeNumber>
renumbering_of(const std::shared_ptr<const Source>& source, const NumberSpaces& spaces, Numbering numbering);

/// "line 3: 'GOTO#1' jumps …", with the name of the file before it where that is not the one at `path`.
[[nodiscard]] std::string reason_of(const UnsafeNumber& unsafe, std::string_view path);

/// Whether the words of both name the same blocks, counted from the top of their space.
[[nodiscard]] bool name_the_same_blocks(const NumberSpaces& before, const NumberSpaces& after);

} // namespace maclint::cli
