//! Program numbers and names to programs, by distance between folders.
#include "analyzer/workspace/resolve.hpp"

#include "analyzer/program/call_kinds.hpp"

#include <algorithm>
#include <utility>

namespace maclint {
namespace {

std::string_view folder_of(std::string_view path) {
    const auto slash = path.find_last_of('/');
    return slash == std::string_view::npos ? std::string_view{} : path.substr(0, slash);
}

/// Calls `visit(folder, steps up to it)` for the folder and all around it.
template<class Visit>
void for_each_folder_around(std::string_view folder, const Visit& visit) {
    for (std::size_t steps = 0;; ++steps) {
        visit(folder, steps);
        if (folder.empty()) return;
        folder = folder_of(folder);
    }
}

/// What is started by hand is called only where nothing else as near has the name.
constexpr std::size_t step = 2;
std::size_t handicap(const ProgramOutline& program) { return program.started_by_hand ? 1 : 0; }

} // namespace

std::optional<ProgramIndex> Namesakes::only() const {
    if (nearest.size() != 1 || nearest.front()->size() != 1) return std::nullopt;
    return nearest.front()->front();
}

void CallResolver::Nearest::consider(ProgramIndex program, std::size_t steps_to_it) {
    ++all;
    if (steps_to_it > steps) return;
    if (steps_to_it < steps) programs = std::make_shared<NamesakeList>();
    steps = steps_to_it;
    programs->push_back(program);
}

CallResolver::CallResolver(std::span<const FileOutline> files)
    : files_(files) {
    ProgramIndex index = 0;
    for (std::size_t file = 0; file < files.size(); ++file)
        for (const ProgramOutline& program : files[file].programs) {
            if (!program.folder.empty())
                homes_.try_emplace({file, program.folder}, files[file].path + "/" + program.folder);
            const ProgramInFile here{file, &program};
            if (program.number) add(by_number_[{program.language, *program.number}], here, index);
            for (const std::string& name : program.names)
                add(by_name_[{program.language, name}], here, index);
            ++index;
        }
}

void CallResolver::add(ProgramsByName& named, ProgramInFile program, ProgramIndex index) const {
    if (!named.places && !named.only_one && !program.outline->local) {
        named.only_one = std::make_shared<NamesakeList>(NamesakeList{index});
        named.where_it_is = program;
        return;
    }
    if (!named.places) named.places = std::make_unique<Places>();
    if (const auto first = std::exchange(named.only_one, nullptr))
        add_to_places(*named.places, named.where_it_is, first->front());
    add_to_places(*named.places, program, index);
}

void CallResolver::add_to_places(Places& places, ProgramInFile program, ProgramIndex index) const {
    const auto& [file, outline] = program;
    const std::size_t by_hand = handicap(*outline);
    // Every file may have local programs of the same names: only calls in the file look at them.
    if (outline->local) return places.local[file].consider(index, by_hand);
    if (outline->folder.empty()) places.in_file[file].consider(index, by_hand);
    // A file that says in which folders its programs are stored is itself a folder.
    for_each_folder_around(home_of(file, *outline), [&](std::string_view folder, std::size_t down) {
        places.below[folder].consider(index, step * down + by_hand);
    });
}

std::string_view CallResolver::home_of(std::size_t file, const ProgramOutline& program) const {
    if (program.folder.empty()) return folder_of(files_[file].path);
    return homes_.find({file, program.folder})->second;
}

const CallResolver::ProgramsByName* CallResolver::programs_named(const ProgramOutline& caller,
                                                                 const CallOutline& call) const {
    const auto look_up = [&](const auto& index, const auto& name) -> const ProgramsByName* {
        const auto found = index.find({caller.language, name});
        return found == index.end() ? nullptr : &found->second;
    };
    if (const auto* name = std::get_if<std::string>(&call.program)) return look_up(by_name_, *name);
    const auto* number = std::get_if<std::int64_t>(&call.program);
    return number == nullptr ? nullptr : look_up(by_number_, *number);
}

Namesakes CallResolver::resolve(std::size_t file, const ProgramOutline& caller,
                                const CallOutline& call) const {
    Namesakes found;
    const ProgramsByName* named = programs_named(caller, call);
    if (named == nullptr) return found;
    if (named->only_one) return {.nearest = {named->only_one}, .all = 1};
    const Places& places = *named->places;
    std::size_t nearest = static_cast<std::size_t>(-1);
    const auto look_at = [&](const Nearest& there, std::size_t steps_there) {
        const std::size_t steps = steps_there + there.steps;
        if (steps > nearest) return;
        if (steps < nearest) found.nearest.clear();
        found.nearest.push_back(there.programs);
        nearest = steps;
    };
    const auto look_into = [&](const auto& files) {
        if (const auto there = files.find(file); there != files.end()) look_at(there->second, 0);
    };
    // First the file itself, then folder by folder outwards. A name that the call looks for in other files
    // may still be that of a local program.
    if (caller.folder.empty()) look_into(places.in_file);
    if (call.lookup != LookupScope::other_files) look_into(places.local);
    if (found.nearest.empty())
        for_each_folder_around(home_of(file, caller), [&](std::string_view folder, std::size_t up) {
            if (const auto there = places.below.find(folder); there != places.below.end())
                look_at(there->second, step * (1 + up));
        });
    if (found.nearest.empty()) look_into(places.local);

    // Seen from the outermost folder, all that are not local are there.
    if (const auto all = places.below.find(std::string_view{}); all != places.below.end())
        found.all += all->second.all;
    if (const auto local = places.local.find(file); local != places.local.end())
        found.all += local->second.all;
    return found;
}

} // namespace maclint
