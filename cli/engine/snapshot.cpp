//! Settings are found one file after the other.
#include "cli/engine/snapshot.hpp"

#include <utility>

namespace maclint::cli {

Snapshot snapshot_of(std::vector<InputFile> inputs, Settings& settings) {
    Snapshot snapshot;
    snapshot.files.reserve(inputs.size());
    for (InputFile& input : inputs)
        if (auto found = settings.for_file(input.path)) {
            // Whoever names a file wants to see all of it.
            if (input.named && settings.named_show_all()) found->vendor = VendorCode::none;
            snapshot.files.push_back({std::move(input), *std::move(found)});
        }
    return snapshot;
}

} // namespace maclint::cli
