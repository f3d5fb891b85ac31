//! The lines of plain blocks that go on with an arc and lack a word, found by their letters.
#pragma once

#include "analyzer/program/lines_with.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

namespace maclint {

class ArcLines {
  public:
    ArcLines();
    /// A whole code that begins an arc, and one that ends it.
    void add_arc(double code) { arcs_.add(code); }
    void add_other(double code) { others_.add(code); }
    /// A letter by which a line moves, and one that it must have.
    void move(char capital) { mark(capital, Letter::axis); }
    void want(char capital) { mark(capital, Letter::wanted); }

    /// `visit(line)` for the lines of the part; some may go on with no arc. `in_arc`: one is in force when it
    /// begins. Where none is only codes are looked for.
    void read(std::string_view whole, Span part, bool in_arc, const std::function<void(Span)>& visit);

  private:
    /// What a letter of a line is.
    enum class Letter : std::uint8_t { none, axis, wanted, code, line_end, comment };

    void mark(char capital, Letter letter);
    [[nodiscard]] bool goes_on(std::string_view text, std::size_t& at);
    [[nodiscard]] std::size_t end_of_line(std::string_view text, std::size_t at) const;

    CodeNumbers arcs_, others_;
    std::array<Letter, 256> letters_{};
    bool in_arc_ = false;  ///< where the text has come to
    char line_end_ = '\n'; ///< of the part that is read
};

} // namespace maclint
