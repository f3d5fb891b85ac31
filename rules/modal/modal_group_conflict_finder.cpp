//! Looks into the one table or the other.
#include "rules/modal/modal_group_conflict_finder.hpp"

#include <algorithm>

namespace maclint::rules {

std::optional<ExclusiveKind> exclusive_kind(const ControlModel& control, char letter, double code) {
    for (std::size_t i = 0; i < control.exclusive_codes.size(); ++i) {
        const ExclusiveCodes& row = control.exclusive_codes[i];
        if (row.letter == letter && std::ranges::find(row.codes, code) != row.codes.end())
            return ExclusiveKind{i, row.name};
    }
    if (!control.exclusive_codes.empty() || letter != 'G') return std::nullopt;
    const auto group = control.group_of('G', code);
    return group ? std::optional(ExclusiveKind{*group, control.groups[*group].name}) : std::nullopt;
}

} // namespace maclint::rules
