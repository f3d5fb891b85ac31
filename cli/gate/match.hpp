//! Which findings a baseline knows. No file is looked at here.
#pragma once

#include "cli/config/selection.hpp"
#include "cli/gate/baseline_file.hpp"

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace maclint::cli {

/// A finding, in the order of reports: a place of its own, then the others of the same cause.
using FoundPlaces = std::vector<KnownPlace>;

/// A file that is gone, and the one that has its findings.
struct Renamed {
    std::string from, to;

    friend bool operator==(const Renamed&, const Renamed&) = default;
};

struct Matched {
    std::vector<bool> known; ///< by finding
    std::vector<Renamed> renamed;
    std::size_t gone = 0; ///< places of the baseline that were looked for and not found
    Baseline rest;        ///< without those, without files that are gone, and under the new names
};

/// What a run looked at: names of files with the rules that held for each.
using LookedAt = std::map<std::string, const RuleStates*>;

/// A finding is known when all of its places are; of several that are alike as many as the baseline counts. A
/// file that is gone is taken for renamed when a file that the baseline does not know has half of its known
/// places: the one with most of them, of the same name if there is one.
[[nodiscard]] Matched match(const Baseline& baseline, const std::vector<FoundPlaces>& findings,
                            const LookedAt& looked_at,
                            const std::function<bool(const std::string& name)>& exists);

/// Entries that `looked_at` says nothing of: of other files that exist, and of rules that were off.
[[nodiscard]] Baseline out_of_sight(const Baseline& baseline, const LookedAt& looked_at,
                                    const std::function<bool(const std::string& name)>& exists);

} // namespace maclint::cli
