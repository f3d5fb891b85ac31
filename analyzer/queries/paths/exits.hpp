//! Where a program is left.
#pragma once

#include "analyzer/program/block_view.hpp"
#include "analyzer/workspace/program_analysis.hpp"

namespace maclint::queries {

/// What leaves it: M99, M30; for a program that runs off its end the text that runs last.
[[nodiscard]] Span span_of_exit(const ProgramAnalysis& analysis, const flow::Exit& exit);

/// The last block with a move that stands in the text before the exit, without its number; nothing where none
/// does.
[[nodiscard]] std::optional<Span> last_move_before(const ProgramAnalysis& analysis, const flow::Exit& exit);

/// The block after which a program ends that runs off its end: of blocks that run in a row the last one, and
/// `last`, the program's last block, where the exit has no text of its own.
[[nodiscard]] Span last_block_before(const ProgramAnalysis& analysis, const flow::Exit& exit,
                                     const BlockView& last);

/// Whether no path to an exit, alarms left out, leads around the node.
[[nodiscard]] bool is_on_every_path(const ProgramAnalysis& analysis, flow::NodeId node);

/// The only node that follows; where `side` is asked for, on that side of the node's decision. Nothing where
/// there are none or several.
[[nodiscard]] std::optional<flow::NodeId> only_successor(const ProgramAnalysis& analysis, flow::NodeId node,
                                                         std::optional<bool> side);

/// Whether that side of the decision in the node `test` leads straight to an alarm, or to a call that does
/// not come back.
[[nodiscard]] bool ends_in_alarm(const ProgramAnalysis& analysis, flow::NodeId test, bool side);

} // namespace maclint::queries
