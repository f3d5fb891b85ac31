//! Blocks that go on with an arc without naming its code: the rows of the code want their words there, too.
#pragma once

#include "analyzer/program/block_view.hpp"
#include "analyzer/program/lines_with.hpp"
#include "rules/words/row_index.hpp"
#include "rules/words/row_pass.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace maclint {

/// Good for one section, whose items are handed over in the order of the text.
class ArcsGoingOn {
  public:
    ArcsGoingOn(const ProgramAnalysis& analysis, const RowIndex& index);

    /// `visit(line)` for each line of the run that may go on with an arc and lacks a word. Where no arc
    /// stands only codes are looked for.
    void for_each_line(const PlainRun& run, const std::function<void(Span)>& visit);
    /// Has the rows look at such a line, or at a block with effects of its own; each arc is told once.
    void look_at(const queries::WordsOfBlock& block, RowPass& pass);

  private:
    /// What a letter of a line is.
    enum class Letter : std::uint8_t { none, axis, wanted, code, line_end, comment };

    void want(const WordRow& row);
    [[nodiscard]] bool goes_on(std::string_view text, std::size_t& at);
    [[nodiscard]] std::size_t end_of_line(std::string_view text, std::size_t at) const;
    void read_lines(Span part, const std::function<void(Span)>& visit);
    [[nodiscard]] bool names_motion(const queries::WordsOfBlock& block) const;

    const ProgramAnalysis& analysis_;
    const RowIndex& index_;
    std::optional<GroupId> motion_; ///< nothing: no row is of arcs
    CodeNumbers arcs_, others_;     ///< codes of the group
    syntax::CodeSet kinds_;         ///< of the arcs
    syntax::AddressSet addresses_;  ///< of which a block must hold one
    std::array<Letter, 256> letters_{};
    bool in_arc_ = false;  ///< where the text has come to
    char line_end_ = '\n'; ///< of the run that is read
    std::optional<queries::Mode> told_;
};

} // namespace maclint
