//! Blocks that go on with an arc without naming its code: the rows of the code want their words there, too.
#pragma once

#include "analyzer/program/block_view.hpp"
#include "rules/words/arc_lines.hpp"
#include "rules/words/row_index.hpp"
#include "rules/words/row_pass.hpp"

#include <functional>
#include <optional>

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
    void want(const WordRow& row);
    [[nodiscard]] bool names_motion(const queries::WordsOfBlock& block) const;

    const ProgramAnalysis& analysis_;
    const RowIndex& index_;
    std::optional<GroupId> motion_; ///< nothing: no row is of arcs
    syntax::CodeSet kinds_;         ///< of the arcs
    syntax::AddressSet addresses_;  ///< of which a block must hold one
    ArcLines lines_;
    bool in_arc_ = false; ///< where the text has come to
    std::optional<queries::Mode> told_;
};

} // namespace maclint
