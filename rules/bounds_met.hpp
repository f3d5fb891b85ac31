//! Where the work of rules has met a bound: what they say there is not all that there is to say.
#pragma once

#include "rules/rule.hpp"

#include <compare>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

/// A rule whose check of the file or of some program of it has spent its Budget; or in which a search gave
/// up, where the rule's findings do not stand without a path. Without a code: a program of the file has more
/// ways to its labels than are followed one by one, so that each may lead to any of them.
struct BoundMet {
    std::string path; ///< of the file
    std::string_view code;
    friend auto operator<=>(const BoundMet&, const BoundMet&) = default;
};

/// As run_rules; adds to `met`, in no order and some of them twice. Rules that have not begun when somebody
/// asks to stop are left out.
[[nodiscard]] std::vector<Finding> run_rules(const Workspace& workspace, const Selection& selection,
                                             unsigned jobs, std::vector<BoundMet>& met,
                                             const std::stop_token& stop);

} // namespace maclint
