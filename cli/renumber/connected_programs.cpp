//! A glance at each file tells its numbers and calls; those that meet are read whole.
#include "cli/renumber/connected_programs.hpp"

#include "analyzer/program/model.hpp"
#include "analyzer/workspace/outline.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <utility>

namespace maclint::cli {
namespace {

std::set<std::int64_t> numbers_of(const FileOutline& outline) {
    std::set<std::int64_t> numbers;
    for (const ProgramOutline& program : outline.programs)
        if (program.number) numbers.insert(*program.number);
    return numbers;
}

std::set<std::int64_t> calls_of(const FileOutline& outline) {
    std::set<std::int64_t> numbers;
    for (const ProgramOutline& program : outline.programs)
        for (const CallOutline& call : program.calls)
            if (const auto* number = std::get_if<std::int64_t>(&call.program)) numbers.insert(*number);
    return numbers;
}

bool meet(const std::set<std::int64_t>& some, const std::set<std::int64_t>& others) {
    return std::ranges::any_of(some, [&](std::int64_t number) { return others.contains(number); });
}

} // namespace

ReadFile open_and_read(const SnapshotFile& file, Extent extent, ProgramStore& store) {
    auto opened = open_file(file);
    if (auto* notice = std::get_if<Notice>(&opened)) return ReadFile{.notice = std::move(*notice)};
    return read_source(file, std::make_shared<const Source>(std::get<Source>(std::move(opened))), extent,
                       store);
}

std::vector<std::shared_ptr<const ProgramFile>>
connected_programs(const Snapshot& around, const ProgramFile& file, ProgramStore& store) {
    const auto numbers = numbers_of(outline_of(file)), called = calls_of(outline_of(file));
    std::vector<std::shared_ptr<const ProgramFile>> files;
    for (const SnapshotFile& other : around.files) {
        if (other.input.path == file.source->path()) continue;
        const ReadFile glance = open_and_read(other, Extent::names_and_calls, store);
        if (glance.file == nullptr || glance.not_nc) continue;
        const FileOutline outline = outline_of(*glance.file);
        if (!meet(numbers_of(outline), called) && !meet(calls_of(outline), numbers)) continue;
        if (auto whole = open_and_read(other, Extent::whole, store); whole.file != nullptr)
            files.push_back(std::move(whole.file));
    }
    return files;
}

} // namespace maclint::cli
