//! One list a path.
#include "cli/lsp/diagnostics/finding_store.hpp"

#include <utility>

namespace maclint::cli::lsp {

void FindingStore::set(const std::string& path, DocumentFindings findings) {
    auto stored = std::make_shared<const DocumentFindings>(std::move(findings));
    const std::lock_guard lock(mutex_);
    by_path_.insert_or_assign(path, std::move(stored));
}

void FindingStore::remove(std::string_view path) {
    const std::lock_guard lock(mutex_);
    if (const auto found = by_path_.find(path); found != by_path_.end()) by_path_.erase(found);
}

std::shared_ptr<const DocumentFindings> FindingStore::find(std::string_view path,
                                                           std::int64_t version) const {
    const std::lock_guard lock(mutex_);
    const auto found = by_path_.find(path);
    if (found == by_path_.end() || found->second->version != version) return nullptr;
    return found->second;
}

} // namespace maclint::cli::lsp
