//! Looks through the numbers of all programs.
#include "cli/engine/own_macros.hpp"

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
            if (is_for_codes(program)) folders_.add_that_of(snapshot.files[i].input.path, program.language);
}

bool OwnMacros::lie_by(const SnapshotFile& file, std::string_view language) const {
    return folders_.lie_by(file.input.path, language);
}

} // namespace maclint::cli
