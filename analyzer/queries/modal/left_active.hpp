//! What acts on every later move until it is switched off, and is still on: radius compensation, tilted
//! planes and the like.
#pragma once

#include "analyzer/program/modal_groups.hpp"
#include "analyzer/queries/modal/modal_leaks.hpp"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace maclint::queries {

/// The group of this role, where rules of its own speak of it.
[[nodiscard]] std::optional<GroupId> find_own_group(const ControlModel& control, ModalRole role);

/// What a called program has switched on itself and leaves on when it returns. What a subprogram may switch
/// on for its caller counts only when a caller is there that leaves it on.
[[nodiscard]] std::vector<ModalLeak> left_at_return(const ProgramAnalysis& analysis);

/// What the program has switched on itself in the group of this role, and is still on when it ends.
[[nodiscard]] std::optional<ModalLeak> left_at_end(const ProgramAnalysis& analysis, ModalRole role);

/// How long what a program switches on stays so.
class Lasting {
  public:
    explicit Lasting(const ProgramAnalysis& analysis)
        : analysis_(analysis) {}
    /// Whether some path that can be taken leads from the node that set the group to this one, with the group
    /// left alone in between.
    [[nodiscard]] bool until(flow::NodeId node, GroupId group, flow::NodeId set);

  private:
    /// The nodes that set the group for all of the channels, sorted.
    [[nodiscard]] const std::vector<flow::NodeId>& setting(GroupId group, Channels channels);

    const ProgramAnalysis& analysis_;
    std::map<std::pair<GroupId, Channels>, std::vector<flow::NodeId>> setting_; ///< found when asked for
};

} // namespace maclint::queries
