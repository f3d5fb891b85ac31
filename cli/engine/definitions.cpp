//! Collects the names that outlines give.
#include "cli/engine/definitions.hpp"

namespace maclint::cli {

Definitions::Definitions(const Snapshot& snapshot, std::span<const FileOutline> outlines) {
    for (std::size_t i = 0; i < outlines.size(); ++i)
        for (const ProgramOutline& program : outlines[i].programs) {
            if (program.given_names.empty()) continue;
            std::shared_ptr<TextSet>& names = names_[program.language];
            if (names == nullptr) names = std::make_shared<TextSet>();
            names->insert(program.given_names.begin(), program.given_names.end());
            folders_.add_that_of(snapshot.files[i].input.path, program.language);
        }
}

NamesElsewhere Definitions::names_for(const SnapshotFile& file, std::string_view language) const {
    NamesElsewhere result;
    if (const auto known = names_.find(language); known != names_.end()) result.defined = known->second;
    if (file.settings.configuration != nullptr) result.named = file.settings.configuration->known_names;
    result.are_all =
        file.settings.complete || result.named != nullptr || folders_.lie_by(file.input.path, language);
    return result;
}

} // namespace maclint::cli
