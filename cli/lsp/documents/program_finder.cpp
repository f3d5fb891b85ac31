//! Outlines are kept by what the system says of files; texts of the editor by where they lie in memory.
#include "cli/lsp/documents/program_finder.hpp"

#include "analyzer/source/platform/paths.hpp"
#include "cli/renumber/connected_programs.hpp"

#include <algorithm>
#include <utility>

namespace maclint::cli::lsp {
namespace {

SeenFile look_at(const SnapshotFile& file) {
    ProgramStore store(0);
    SeenFile seen{open_and_read(file, Extent::names_and_calls, store), {}};
    if (seen.read.file != nullptr && !seen.read.not_nc) seen.outline = outline_of(*seen.read.file);
    seen.read.file = nullptr;
    seen.read.source = nullptr;
    return seen;
}

/// Whether a call is one of a program with that number or name, near or far.
bool names(const CallOutline& call, const ProgramOutline& program) {
    if (const auto* number = std::get_if<std::int64_t>(&call.program)) return program.number == *number;
    const auto* name = std::get_if<std::string>(&call.program);
    return name != nullptr && std::ranges::binary_search(program.names, *name);
}

} // namespace

ProgramMap::ProgramMap(Snapshot snapshot, std::vector<FileOutline> outlines)
    : snapshot_(std::move(snapshot))
    , outlines_(std::move(outlines))
    , resolver_(outlines_) {
    for (std::size_t file = 0; file < outlines_.size(); ++file) {
        by_path_.emplace(snapshot_.files[file].input.path, file);
        for (std::size_t program = 0; program < outlines_[file].programs.size(); ++program)
            places_.push_back({file, program});
    }
}

std::optional<std::size_t> ProgramMap::file_at(std::string_view path) const {
    const auto found = by_path_.find(path);
    return found == by_path_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<ProgramPlace> ProgramMap::meant_by(const CallPlace& call) const {
    std::vector<ProgramPlace> meant;
    const ProgramOutline& caller = outline(call.caller);
    if (call.call >= caller.calls.size()) return meant;
    const Namesakes found = resolver_.resolve(call.caller.file, caller, caller.calls[call.call]);
    for (const auto& list : found.nearest)
        for (const ProgramIndex index : *list) meant.push_back(places_[index]);
    std::ranges::sort(meant);
    return meant;
}

std::vector<CallPlace> ProgramMap::calls_of(ProgramPlace program) const {
    const auto index =
        static_cast<ProgramIndex>(std::ranges::lower_bound(places_, program) - places_.begin());
    std::vector<CallPlace> calls;
    for (const ProgramPlace caller : places_) {
        const auto& all = outline(caller).calls;
        for (std::size_t call = 0; call < all.size(); ++call)
            if (names(all[call], outline(program)) && may_mean({caller, call}, index))
                calls.push_back({caller, call});
    }
    return calls;
}

bool ProgramMap::may_mean(const CallPlace& call, ProgramIndex program) const {
    const ProgramOutline& caller = outline(call.caller);
    const Namesakes found = resolver_.resolve(call.caller.file, caller, caller.calls[call.call]);
    return std::ranges::any_of(
        found.nearest, [&](const auto& list) { return std::ranges::find(*list, program) != list->end(); });
}

FileOutline ProgramFinder::outline_of_text(const SnapshotFile& file) {
    const auto kept = texts_.find(file.input.path);
    if (kept != texts_.end() && kept->second.text.bytes().data() == file.text->bytes().data() &&
        kept->second.dialect == file.settings.dialect)
        return kept->second.outline;
    FileOutline outline = look_at(file).outline;
    texts_.insert_or_assign(file.input.path, Looked{*file.text, file.settings.dialect, outline});
    return outline;
}

FileOutline ProgramFinder::outline_of_file(const SnapshotFile& file) {
    const auto stamp = platform::settled_stamp_of(platform::path_of(file.input.path));
    if (auto kept = seen_.find(file, stamp)) return std::move(kept->outline);
    SeenFile seen = look_at(file);
    FileOutline outline = seen.outline;
    seen_.keep(file, stamp, std::move(seen));
    return outline;
}

std::shared_ptr<const ProgramMap> ProgramFinder::map(const std::vector<Document>& documents) {
    Snapshot snapshot = files_.snapshot(documents, Asked::documents);
    std::erase_if(texts_, [&](const auto& entry) {
        return std::ranges::find(documents, entry.first, &Document::path) == documents.end();
    });
    std::vector<FileOutline> outlines;
    outlines.reserve(snapshot.files.size());
    for (const SnapshotFile& file : snapshot.files)
        outlines.push_back(file.text ? outline_of_text(file) : outline_of_file(file));
    return std::make_shared<const ProgramMap>(std::move(snapshot), std::move(outlines));
}

} // namespace maclint::cli::lsp
