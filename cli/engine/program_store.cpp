//! One version of a file is kept: nobody asks for an older one.
#include "cli/engine/program_store.hpp"

#include "analyzer/program/model.hpp"

#include <utility>

namespace maclint::cli {

std::shared_ptr<const ProgramFile> ProgramStore::find(const std::string& path, const Stamp& stamp,
                                                      const Reading& reading) {
    if (!stamp) return nullptr;
    const std::lock_guard lock(mutex_);
    const auto found = by_path_.find(path);
    if (found == by_path_.end() || found->second.stamp != stamp || found->second.reading != reading)
        return nullptr;
    found->second.used = true;
    return found->second.file;
}

std::shared_ptr<const ProgramFile> ProgramStore::read(const std::shared_ptr<const Source>& source,
                                                      const Reading& reading, const Stamp& stamp) {
    {
        const std::lock_guard lock(mutex_);
        if (const auto found = by_path_.find(source->path()); found != by_path_.end()) {
            Kept& kept = found->second;
            const Source& before = *kept.file->source;
            if (kept.reading == reading && before.encoding() == source->encoding() &&
                before.bytes() == source->bytes()) {
                kept.used = true;
                kept.stamp = stamp;
                return kept.file;
            }
            size_ -= before.size();
            by_path_.erase(found);
        }
        ++reads_;
    }
    auto file =
        std::make_shared<const ProgramFile>(reading.dialect->read(source, *reading.control, Extent::whole));
    const std::lock_guard lock(mutex_);
    if (size_ + source->size() <= capacity_ &&
        by_path_.try_emplace(source->path(), Kept{file, reading, stamp}).second)
        size_ += source->size();
    return file;
}

void ProgramStore::drop_unused() {
    const std::lock_guard lock(mutex_);
    std::erase_if(by_path_, [&](const auto& entry) {
        if (!entry.second.used) size_ -= entry.second.file->source->size();
        return !entry.second.used;
    });
    for (auto& entry : by_path_) entry.second.used = false;
}

} // namespace maclint::cli
