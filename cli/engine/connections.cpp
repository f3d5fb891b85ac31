//! Made of outlines alone, and known by them.
#include "cli/engine/connections.hpp"

#include "analyzer/workspace/groups.hpp"
#include "analyzer/workspace/lathes_of_callers.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace maclint::cli {
namespace {

std::vector<Group> largest_first(std::vector<Group> groups) {
    std::ranges::stable_sort(groups, std::ranges::greater(), &Group::size);
    return groups;
}

} // namespace

Connections::FileFacts::FileFacts(const SnapshotFile& file)
    : path(file.input.path)
    , standard_input(file.input.standard_input)
    , complete(file.settings.complete)
    , configuration(file.settings.configuration) {}

Connections::Connections(const Snapshot& snapshot, std::vector<FileOutline> outlines)
    : files_(snapshot.files.begin(), snapshot.files.end())
    , outlines_(std::move(outlines))
    , groups_(largest_first(groups_of(outlines_)))
    , computed_calls_(snapshot, outlines_)
    , same_numbers_(snapshot, outlines_)
    , own_macros_(snapshot, outlines_)
    , definitions_(snapshot, outlines_)
    , lathes_of_callers_(lathes_of_callers(outlines_)) {}

bool Connections::hold_for(const Snapshot& snapshot, const std::vector<FileOutline>& outlines) const {
    const auto is_same = [](const FileFacts& known, const SnapshotFile& file) {
        return known == FileFacts(file);
    };
    return outlines_ == outlines && std::ranges::equal(files_, snapshot.files, is_same);
}

} // namespace maclint::cli
