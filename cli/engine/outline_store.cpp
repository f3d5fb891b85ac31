//! One version of a file is kept: nobody asks for an older one.
#include "cli/engine/outline_store.hpp"

#include <algorithm>
#include <utility>

namespace maclint::cli {
namespace {

bool is_same_control(const NamedControl& one, const NamedControl& other) {
    return one.control == other.control;
}

/// Whether a look under one of the settings shows what it shows under the other.
bool reads_alike(const FileSettings& one, const FileSettings& other) {
    return one.configuration == other.configuration && one.dialect == other.dialect &&
           one.dialect_reason == other.dialect_reason && one.max_file_size == other.max_file_size &&
           std::ranges::equal(one.controls, other.controls, is_same_control);
}

} // namespace

std::optional<SeenFile> OutlineStore::find(const SnapshotFile& file,
                                           const std::optional<platform::FileStamp>& stamp) {
    if (!stamp) return std::nullopt;
    const std::lock_guard lock(mutex_);
    const auto found = by_path_.find(file.input.path);
    if (found == by_path_.end()) return std::nullopt;
    Kept& kept = found->second;
    if (kept.stamp != *stamp || kept.named != file.input.named || !reads_alike(kept.settings, file.settings))
        return std::nullopt;
    kept.used = true;
    return kept.seen;
}

void OutlineStore::keep(const SnapshotFile& file, const std::optional<platform::FileStamp>& stamp,
                        SeenFile seen) {
    if (!stamp) return;
    seen.read.source = nullptr;
    seen.read.file = nullptr;
    const std::lock_guard lock(mutex_);
    by_path_.insert_or_assign(file.input.path,
                              Kept{*stamp, file.settings, file.input.named, std::move(seen)});
}

void OutlineStore::drop_unused() {
    const std::lock_guard lock(mutex_);
    std::erase_if(by_path_, [](const auto& entry) { return !entry.second.used; });
    for (auto& entry : by_path_) entry.second.used = false;
}

} // namespace maclint::cli
