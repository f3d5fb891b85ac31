//! What acts on every later move until it is switched off, and is still on: radius compensation, tilted
//! planes and the like.
#pragma once

#include "analyzer/queries/modal_leaks.hpp"

#include <optional>
#include <vector>

namespace maclint::queries {

/// The group of this role, where rules of its own speak of it.
[[nodiscard]] std::optional<GroupId> find_own_group(const ControlModel& control, ModalRole role);

/// What a called program has switched on itself and leaves on when it returns. What a subprogram may switch
/// on for its caller counts only when a caller is there that leaves it on.
[[nodiscard]] std::vector<ModalLeak> left_at_return(const ProgramAnalysis& analysis);

/// What the program has switched on itself in the group of this role, and is still on when it ends.
[[nodiscard]] std::optional<ModalLeak> left_at_end(const ProgramAnalysis& analysis, ModalRole role);

/// Whether some path that can be taken leads from the block that set the part to the node, with the group
/// left alone in between.
[[nodiscard]] bool lasts_until(const ProgramAnalysis& analysis, GroupId group,
                               const dataflow::ModalPart& part, flow::NodeId node);

} // namespace maclint::queries
