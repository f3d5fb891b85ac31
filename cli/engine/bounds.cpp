//! Puts bounds into words.
#include "cli/engine/bounds.hpp"

#include "cli/text/shown.hpp"

#include <string>
#include <string_view>

namespace maclint::cli {
namespace {

/// "in this file", "in this file and 3 other files".
std::string in_files(const std::set<std::string_view>& files) {
    return files.size() == 1 ? "in this file" : "in this file and " + counted(files.size() - 1, "other file");
}

} // namespace

void Bounds::add(const std::vector<BoundMet>& met) {
    const std::scoped_lock lock(mutex_);
    met_.insert(met.begin(), met.end());
}

std::optional<Notice> Bounds::searches() const {
    const std::scoped_lock lock(mutex_);
    std::set<std::string_view> files, codes;
    for (const BoundMet& met : met_) {
        if (met.code.empty()) continue;
        files.insert(met.path);
        codes.insert(met.code);
    }
    if (files.empty()) return std::nullopt;
    std::string rules;
    for (const std::string_view code : codes) rules.append(rules.empty() ? "" : ", ").append(code);
    return Notice{NoticeKind::left_out, std::string(*files.begin()),
                  "a search was given up " + in_files(files) + ": findings of " + rules +
                      " count for less there, or are missing."};
}

std::optional<Notice> Bounds::jumps() const {
    const std::scoped_lock lock(mutex_);
    std::set<std::string_view> files;
    for (const BoundMet& met : met_)
        if (met.code.empty()) files.insert(met.path);
    if (files.empty()) return std::nullopt;
    return Notice{NoticeKind::left_out, std::string(*files.begin()),
                  "computed jumps or returns are too many to follow one by one " + in_files(files) +
                      ": each may lead to any label, in the eyes of all rules."};
}

} // namespace maclint::cli
