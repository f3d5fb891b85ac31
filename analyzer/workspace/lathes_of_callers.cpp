//! Hands the machines of files on, call by call.
#include "analyzer/workspace/lathes_of_callers.hpp"

#include "analyzer/workspace/resolve.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace maclint {
namespace {

constexpr char mill = 'M'; ///< and what else is no lathe

/// The files that the programs of each file call, with those that show their machine themselves left out.
std::vector<std::vector<std::size_t>> calls_of(std::span<const FileOutline> files) {
    std::vector<std::size_t> file_of; // by program
    for (std::size_t file = 0; file < files.size(); ++file)
        file_of.insert(file_of.end(), files[file].programs.size(), file);
    const CallResolver resolver(files);
    std::vector<std::vector<std::size_t>> called(files.size());
    for (std::size_t file = 0; file < files.size(); ++file) {
        for (const ProgramOutline& program : files[file].programs)
            for (const CallOutline& call : program.calls)
                for (const auto& namesakes : resolver.resolve(file, program, call).nearest)
                    for (const ProgramIndex meant : *namesakes)
                        if (!files[file_of[meant]].machine_signs.tell) called[file].push_back(file_of[meant]);
        std::ranges::sort(called[file]);
        called[file].erase(std::ranges::unique(called[file]).begin(), called[file].end());
    }
    return called;
}

/// The one system that stands there.
char lathe_among(std::string_view machines, MachineSigns signs) {
    const bool fits = machines.size() == 1 && machines != std::string_view(&mill, 1) &&
                      !(machines == "A" && signs.has_distance_code);
    return fits ? machines.front() : '\0';
}

} // namespace

std::vector<char> lathes_of_callers(std::span<const FileOutline> files) {
    std::vector<char> lathes(files.size());
    const bool asked = std::ranges::any_of(files, [](const auto& file) { return !file.machine_signs.tell; });
    const bool answered = std::ranges::any_of(
        files, [](const auto& file) { return file.machine_signs.tell && file.code_system != 0; });
    if (!asked || !answered) return lathes;
    const auto called = calls_of(files);
    std::vector<std::string> machines(files.size()); // that are known of each file, each once
    std::vector<std::size_t> worklist;
    const auto add = [&](std::size_t file, char machine) {
        if (machines[file].find(machine) != std::string::npos) return;
        machines[file] += machine;
        worklist.push_back(file);
    };
    for (std::size_t file = 0; file < files.size(); ++file)
        if (files[file].machine_signs.tell)
            add(file, files[file].code_system == 0 ? mill : files[file].code_system);
    while (!worklist.empty()) {
        const std::size_t caller = worklist.back();
        worklist.pop_back();
        for (const std::size_t file : called[caller])
            for (const char machine : machines[caller]) add(file, machine);
    }
    for (std::size_t file = 0; file < files.size(); ++file)
        if (!files[file].machine_signs.tell)
            lathes[file] = lathe_among(machines[file], files[file].machine_signs);
    return lathes;
}

} // namespace maclint
