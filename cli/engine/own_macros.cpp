//! Folders are compared as texts.
#include "cli/engine/own_macros.hpp"

#include <algorithm>

namespace maclint::cli {
namespace {

/// "shop/" of "shop/O1.nc"; "" of "O1.nc".
std::string folder_of(const std::string& path) { return path.substr(0, path.rfind('/') + 1); }

bool is_for_codes(const ProgramOutline& program) {
    constexpr std::int64_t first = 9001, last = 9029;
    return program.number && first <= *program.number && *program.number <= last;
}

} // namespace

OwnMacros::OwnMacros(const Snapshot& snapshot, std::span<const FileOutline> outlines) {
    for (std::size_t i = 0; i < outlines.size(); ++i)
        for (const ProgramOutline& program : outlines[i].programs)
            if (is_for_codes(program))
                folders_.emplace(program.language, folder_of(snapshot.files[i].input.path));
}

bool OwnMacros::lie_by(const SnapshotFile& file, std::string_view language) const {
    const std::string own = folder_of(file.input.path);
    return std::ranges::any_of(folders_, [&](const auto& holding) {
        return holding.first == language &&
               (own.starts_with(holding.second) || holding.second.starts_with(own));
    });
}

} // namespace maclint::cli
