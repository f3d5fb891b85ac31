//! Collects the names that outlines give.
#include "cli/engine/definitions.hpp"

namespace maclint::cli {

Definitions::Definitions(const Snapshot& snapshot, std::span<const FileOutline> outlines) {
    for (std::size_t i = 0; i < outlines.size(); ++i)
        for (const ProgramOutline& program : outlines[i].programs) {
            if (program.given_names.empty()) continue;
            const Given& given = given_[program.language];
            given.names->insert(program.given_names.begin(), program.given_names.end());
            given.switches->insert(program.given_switches.begin(), program.given_switches.end());
            folders_.add_that_of(snapshot.files[i].input.path, program.language);
        }
}

NamesElsewhere Definitions::names_for(const SnapshotFile& file, std::string_view language) const {
    NamesElsewhere result;
    if (const auto known = given_.find(language); known != given_.end()) {
        result.defined = known->second.names;
        result.switches = known->second.switches;
    }
    if (file.settings.configuration != nullptr) result.named = file.settings.configuration->known_names;
    result.are_all =
        file.settings.complete || result.named != nullptr || folders_.lie_by(file.input.path, language);
    return result;
}

} // namespace maclint::cli
