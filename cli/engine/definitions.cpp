//! Collects the names that outlines give.
#include "cli/engine/definitions.hpp"

namespace maclint::cli {
namespace {

/// Two files may give a name with different meanings: then nobody knows which counts.
void add(GivenByName<GivenWord>& words, const GivenWord& word) {
    const auto [known, is_new] = words.emplace(word.name, word);
    if (!is_new && known->second != word) known->second = {word.name, false};
}

void add(GivenByName<ArrayDefinition>& arrays, const ArrayDefinition& array) {
    const auto [known, is_new] = arrays.emplace(array.name, array);
    if (!is_new && known->second != array) known->second = {array.name, {}, {}};
}

} // namespace

Definitions::Definitions(const Snapshot& snapshot, std::span<const FileOutline> outlines) {
    for (std::size_t i = 0; i < outlines.size(); ++i)
        for (const ProgramOutline& program : outlines[i].programs) {
            if (program.given_names.empty()) continue;
            const Given& given = given_[program.language];
            given.names->insert(program.given_names.begin(), program.given_names.end());
            for (const GivenWord& word : program.given_words) add(*given.words, word);
            for (const ArrayDefinition& array : program.arrays) add(*given.arrays, array);
            folders_.add_that_of(snapshot.files[i].input.path, program.language);
        }
}

NamesElsewhere Definitions::names_for(const SnapshotFile& file, std::string_view language) const {
    NamesElsewhere result;
    if (const auto known = given_.find(language); known != given_.end()) {
        result.defined = known->second.names;
        result.words = known->second.words;
        result.arrays = known->second.arrays;
    }
    if (file.settings.configuration != nullptr) result.named = file.settings.configuration->known_names;
    result.are_all =
        file.settings.complete || result.named != nullptr || folders_.lie_by(file.input.path, language);
    return result;
}

} // namespace maclint::cli
