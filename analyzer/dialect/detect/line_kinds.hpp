//! What the lines of a text are to a control of the Fanuc family: blocks, data, or words for people.
#pragma once

#include "analyzer/dialect/detect/line.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace maclint::detect {

enum class LineKind : std::uint8_t {
    nothing,   ///< a comment, a tape mark
    block,     ///< a control could mean it
    offset,    ///< `G10 L2 P1 X-350.`: values that nothing computes
    variable,  ///< `#500=12.5`, `SETVN500[A,B]`
    parameter, ///< `N6000P00100000`
    position,  ///< `X10.001 Y20.002`: a block beside others, else what a probe measured
    other,     ///< words for people, rows of a table
};
constexpr std::size_t line_kind_count = 7;

/// What a line that is not empty is to a control of the Fanuc family.
[[nodiscard]] LineKind kind_of(const Line& line);

/// Whether most lines of a text that bears marks of DIN PLUS can be read as such.
[[nodiscard]] bool reads_as_din_plus(std::string_view text);

/// How many lines of each kind a text has.
class LineCounts {
  public:
    void add(const Line& line);

    /// Whether most of its lines can be read. One line that cannot must not look like a block at all.
    [[nodiscard]] bool is_program_text() const;
    [[nodiscard]] std::size_t blocks() const { return of(LineKind::block); }
    /// "offsets": where it reads and holds nothing that a control would do, but at least two rows of data.
    [[nodiscard]] std::optional<std::string_view> data() const;

  private:
    [[nodiscard]] std::size_t of(LineKind kind) const { return counts_[static_cast<std::size_t>(kind)]; }

    std::array<std::size_t, line_kind_count> counts_{};
    std::size_t unlike_blocks_ = 0; ///< others that do not even begin like a block
    bool has_head_ = false;         ///< `%`, `O8000`
    bool has_end_ = false;          ///< M02, M30, M99
};

} // namespace maclint::detect
