//! Reads as little of each file as tells what it is.
#include "cli/commands/show_files.hpp"

#include "cli/engine/read.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace maclint::cli {
namespace {

std::string fate_of(const SnapshotFile& file, ProgramStore& store, std::vector<Notice>& notices) {
    auto opened = open_file(file);
    if (auto* notice = std::get_if<Notice>(&opened)) {
        notices.push_back(std::move(*notice));
        return "cannot be read";
    }
    const ReadFile read =
        read_source(file, std::make_shared<const Source>(std::get<Source>(std::move(opened))),
                    Extent::names_and_calls, store);
    if (read.not_nc) return "no NC program: " + *read.not_nc;
    if (read.dialect == nullptr) return "not linted: " + read.dialect_reason;
    return "read as " + std::string(read.dialect->name) + " (" + read.dialect_reason + ")";
}

} // namespace

ShownFiles show_files(const Snapshot& snapshot, const Discovered& inputs) {
    ShownFiles shown_files;
    std::vector<std::pair<std::string, std::string>> lines;
    ProgramStore store(0);
    for (const SnapshotFile& file : snapshot.files)
        if (file.input.asked) lines.emplace_back(file.input.path, fate_of(file, store, shown_files.notices));
    for (const auto& [path, why] : inputs.files_passed_over)
        lines.emplace_back(path, "passed over: " + std::string(why));
    std::ranges::stable_sort(lines);
    for (const auto& [path, fate] : lines) shown_files.text += shown(path) + ": " + shown(fate) + "\n";
    return shown_files;
}

} // namespace maclint::cli
