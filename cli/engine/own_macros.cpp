//! Looks through the numbers of all programs.
#include "cli/engine/own_macros.hpp"

#include "cli/engine/folders.hpp"

#include <algorithm>

namespace maclint::cli {
namespace {

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
        return holding.first == language && lie_together(own, holding.second);
    });
}

} // namespace maclint::cli
