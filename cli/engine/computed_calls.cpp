//! Folders are compared as texts: those of configurations are absolute.
#include "cli/engine/computed_calls.hpp"

#include <algorithm>

namespace maclint::cli {
namespace {

/// The folder of the configuration that holds for the file, with a '/' after it; "" without one.
std::string folder_of(const SnapshotFile& file) {
    return file.settings.configuration ? file.settings.configuration->folder + "/" : std::string();
}

} // namespace

ComputedCalls::ComputedCalls(const Snapshot& snapshot, std::span<const FileOutline> outlines) {
    for (std::size_t i = 0; i < outlines.size(); ++i)
        for (const ProgramOutline& program : outlines[i].programs)
            if (std::ranges::any_of(program.calls, &CallOutline::is_computed))
                folders_.emplace(program.language, folder_of(snapshot.files[i]));
}

bool ComputedCalls::may_mean(const SnapshotFile& file, std::string_view language) const {
    const std::string own = folder_of(file);
    return std::ranges::any_of(folders_, [&](const auto& calling) {
        return calling.first == language &&
               (own.starts_with(calling.second) || calling.second.starts_with(own));
    });
}

} // namespace maclint::cli
