//! A file that was written just now has no stamp, and is read again.
#include "cli/gate/baseline_store.hpp"

#include "analyzer/source/platform/paths.hpp"

#include <utility>

namespace maclint::cli {

std::variant<std::shared_ptr<const Baseline>, Notice> BaselineStore::read(const std::string& path,
                                                                          NamedBy named_by) {
    const auto stamp = platform::settled_stamp_of(platform::path_of(path));
    const auto kept = by_path_.find(path);
    if (stamp && kept != by_path_.end() && kept->second.stamp == *stamp) return kept->second.baseline;
    ++reads_;
    auto read = read_baseline(path, named_by);
    if (auto* notice = std::get_if<Notice>(&read)) return std::move(*notice);
    auto baseline = std::make_shared<const Baseline>(std::get<Baseline>(std::move(read)));
    if (stamp) by_path_.insert_or_assign(path, Kept{*stamp, baseline});
    return baseline;
}

} // namespace maclint::cli
