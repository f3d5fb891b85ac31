//! Which blanks of a block its writer may choose, and which of them he may leave out.
#pragma once

#include "analyzer/dialect/dialect.hpp"
#include "analyzer/source/span.hpp"
#include "analyzer/syntax/tree.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace maclint {

/// Between which parts of a block blanks stand, or may.
enum class GapKind : std::uint8_t {
    words,     ///< of a block
    operators, ///< between an operator and what it takes
    brackets,  ///< between a bracket and what it encloses
};

/// Blanks, or a place where two parts touch.
struct Gap {
    GapKind kind;
    Span span;      ///< in the file; empty: they touch
    bool may_close; ///< both are still told apart when they touch
};

/// What is said of a kind of node in a grammar; of others nothing is changed beside or in them.
struct SpacingRow {
    enum class Parts : std::uint8_t {
        kept,      ///< stand as they are written
        row,       ///< are words in a row
        operation, ///< are an operator and what it takes
        enclosed,  ///< stand in brackets
        tight,     ///< stand as they are written, and so do parts of parts outside of brackets
    };
    enum class Beside : std::uint8_t {
        kept,    ///< it stands as it is written: a remark, a mistake
        apart,   ///< in a row it may have blanks beside it, and keeps those that it has
        touches, ///< a letter and a number: it may also touch another
    };
    std::string_view node;
    Parts parts;
    Beside beside;
};

struct SpacingTable {
    syntax::Grammar grammar;
    std::span<const SpacingRow> rows;
    bool blanks_say_nothing; ///< to the control: whatever may stand apart may touch
};

[[nodiscard]] const SpacingTable& spacing_of(const Dialect& dialect);

/// Reads blocks of one language; keeps its memory.
class SpacingReader {
  public:
    explicit SpacingReader(const SpacingTable& table);

    /// Places in the block at `block`, in the order of the text; none where it cannot be parsed.
    [[nodiscard]] std::vector<Gap> gaps_in(std::string_view text, Span block);
    /// Whether two blocks are the same but for blanks between their parts.
    [[nodiscard]] bool read_the_same(std::string_view one, std::string_view other);

  private:
    const SpacingTable& table_;
    std::vector<const SpacingRow*> rows_; ///< by symbol of the grammar; nullptr: none
    syntax::Tree tree_, other_;
};

} // namespace maclint
