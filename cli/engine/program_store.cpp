//! One version of a file is kept: nobody asks for an older one.
#include "cli/engine/program_store.hpp"

#include "analyzer/program/model.hpp"

#include <utility>

namespace maclint::cli {

std::shared_ptr<const ProgramFile> ProgramStore::read(const std::shared_ptr<const Source>& source,
                                                      const Dialect& dialect, const ControlModel& control,
                                                      std::shared_ptr<const Configuration> configuration) {
    {
        const std::lock_guard lock(mutex_);
        if (const auto found = by_path_.find(source->path()); found != by_path_.end()) {
            Kept& kept = found->second;
            const Source& before = *kept.file->source;
            if (kept.dialect == &dialect && kept.control == &control && kept.configuration == configuration &&
                before.encoding() == source->encoding() && before.bytes() == source->bytes()) {
                kept.used = true;
                return kept.file;
            }
            size_ -= before.size();
            by_path_.erase(found);
        }
        ++reads_;
    }
    auto file = std::make_shared<const ProgramFile>(dialect.read(source, control, Extent::whole));
    const std::lock_guard lock(mutex_);
    if (size_ + source->size() <= capacity_ &&
        by_path_.try_emplace(source->path(), Kept{file, &dialect, &control, std::move(configuration), true})
            .second)
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
