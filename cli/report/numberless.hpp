//! Text of blocks as it stays when a program is spaced or numbered otherwise.
#pragma once

#include "analyzer/source/source.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

namespace maclint::cli {

/// A place of a finding, without what renumbering changes.
struct NumberlessPlace {
    std::string line; ///< in which the place begins
    std::string part; ///< that the place covers of that line
};

/// Leaves out blanks, the sequence number of a block, and the number of a jump (GOTO, P and Q of M97, M99 and
/// G70 to G73, NS with NE) where a block of the file bears it; what is left is in capitals. A number that no
/// block bears stays, and so does one in brackets: renumbering leaves it alone. Of lines over 4 KiB only what
/// is near the place is taken.
/// Remembers the numbers of files, which must live as long.
class Numberless {
  public:
    [[nodiscard]] NumberlessPlace of(const Source& source, Span span);

  private:
    /// Of one file, in which several programs may bear the same ones.
    struct Numbers {
        std::vector<std::uint32_t> begins; ///< lines with which programs begin, or end
        std::vector<std::unordered_set<std::string>> borne = {
            {}}; ///< before the first and after each of them
    };
    [[nodiscard]] static Numbers read_numbers(const Source& source);
    /// Those of the program that the line is in.
    const std::unordered_set<std::string>& numbers_at(const Source& source, std::uint32_t line);

    std::unordered_map<const Source*, Numbers> numbers_;
};

} // namespace maclint::cli
