//! Findings in the order of reports. Few files sort them: the sort is not compiled by all that know findings.
#pragma once

#include "rules/finding.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace maclint {

/// Puts things that have findings in that order, which is what they mostly are in. There may be a million:
/// each is moved once at most.
template<class T, class FindingOf>
void put_in_order(std::vector<T>& things, const FindingOf& finding_of) {
    if (std::ranges::is_sorted(things, comes_before, finding_of)) return;
    std::vector<std::size_t> order(things.size()); ///< which one comes to each place
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
        return comes_before(std::invoke(finding_of, things[a]), std::invoke(finding_of, things[b]));
    });
    for (std::size_t first = 0; first < things.size(); ++first) {
        if (order[first] == first) continue;
        T held = std::move(things[first]);
        std::size_t place = first;
        while (order[place] != first) {
            things[place] = std::move(things[order[place]]);
            place = std::exchange(order[place], place);
        }
        things[place] = std::move(held);
        order[place] = place;
    }
}
inline void put_in_order(std::vector<Finding>& findings) { put_in_order(findings, std::identity{}); }

} // namespace maclint
