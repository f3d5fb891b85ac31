//! Which words of a program itself have set a modal group before a node, and in which blocks words stand.
#pragma once

#include "analyzer/program/modal_groups.hpp"
#include "analyzer/workspace/program_analysis.hpp"

#include <optional>
#include <vector>

namespace maclint::queries {

/// What the last words before the node set the group to, on all paths there, calls left out: a code, or
/// nothing for a computed one. Empty where no word of the program sets it.
[[nodiscard]] std::vector<std::optional<double>> last_settings_before(const ProgramAnalysis& analysis,
                                                                      flow::NodeId node, GroupId group);

/// Whether the control can come from one of these words to the node.
[[nodiscard]] bool is_set_on_a_path_to(const ProgramAnalysis& analysis, flow::NodeId node, GroupId group);

/// Whether the code is surely in force after the node, and no word or call can set the group otherwise from
/// there on.
[[nodiscard]] bool stays_at(const ProgramAnalysis& analysis, flow::NodeId node, GroupCode code);

/// Whether the control cannot come from one node to the other but over a word that gives the code, which then
/// stays as long as it takes. False, too, when the search for a path gives up.
[[nodiscard]] bool is_given_on_the_way(const ProgramAnalysis& analysis, flow::NodeId from, flow::NodeId to,
                                       GroupCode code);

/// Whether the block that sets a group also gives this code.
[[nodiscard]] bool stands_beside(const ProgramAnalysis& analysis, dataflow::OriginId set, GroupCode code);

/// How a block relies on the motion mode that is in force.
struct ModalMove {
    bool relies;     ///< it moves, and no code of its own says how: no motion code, cycle or code made once
    bool gives_feed; ///< it states a feed
};
[[nodiscard]] ModalMove modal_move_in(const ProgramAnalysis& analysis, const Stretch& block);

} // namespace maclint::queries
