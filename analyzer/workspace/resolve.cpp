//! Program numbers and names to programs, by distance between folders.
#include "analyzer/workspace/resolve.hpp"

#include <algorithm>

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
            if (program.number) add(by_number_[{program.language, *program.number}], file, program, index);
            for (const std::string& name : program.names)
                add(by_name_[{program.language, name}], file, program, index);
            ++index;
        }
}

void CallResolver::add(ProgramsByName& programs_by_name, std::size_t file, const ProgramOutline& program,
                       ProgramIndex index) {
    const std::size_t by_hand = handicap(program);
    // A file that says in which folders its programs are stored is itself a folder.
    const std::string_view home = home_of(file, program);
    // Every file may have local programs of the same names: only calls in the file look at them.
    if (program.local) return programs_by_name.local[file].consider(index, by_hand);
    if (program.folder.empty()) programs_by_name.in_file[file].consider(index, by_hand);
    for_each_folder_around(home, [&](std::string_view folder, std::size_t down) {
        programs_by_name.below[folder].consider(index, step * down + by_hand);
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
    const ProgramsByName* programs_by_name = programs_named(caller, call);
    if (programs_by_name == nullptr) return found;
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
    if (caller.folder.empty()) look_into(programs_by_name->in_file);
    if (call.lookup != LookupScope::other_files) look_into(programs_by_name->local);
    if (found.nearest.empty())
        for_each_folder_around(home_of(file, caller), [&](std::string_view folder, std::size_t up) {
            if (const auto there = programs_by_name->below.find(folder);
                there != programs_by_name->below.end())
                look_at(there->second, step * (1 + up));
        });
    if (found.nearest.empty()) look_into(programs_by_name->local);

    // Seen from the outermost folder, all that are not local are there.
    if (const auto all = programs_by_name->below.find(std::string_view{});
        all != programs_by_name->below.end())
        found.all += all->second.all;
    if (const auto local = programs_by_name->local.find(file); local != programs_by_name->local.end())
        found.all += local->second.all;
    return found;
}

} // namespace maclint
