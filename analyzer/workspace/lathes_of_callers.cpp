//! Hands the machines of files on, call by call.
#include "analyzer/workspace/lathes_of_callers.hpp"

#include "analyzer/workspace/calls_of_files.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>

namespace maclint {
namespace {

constexpr char mill = 'M'; ///< and what else is no lathe

/// The machines that are known of each file, handed on from callers to what they may call.
class Machines {
  public:
    explicit Machines(std::span<const FileOutline> files)
        : files_(files)
        , resolver_(files)
        , file_of_(files_of_programs(files))
        , called_(files.size())
        , of_file_(files.size()) {
        for_each_called_list(resolver_, files, [&](std::size_t file, const NamesakeList& namesakes) {
            called_[file].push_back(&namesakes);
        });
        for (std::size_t file = 0; file < files.size(); ++file)
            if (files[file].machine_signs.tell)
                hand_on(file, files[file].code_system == 0 ? mill : files[file].code_system);
    }

    /// Each once.
    [[nodiscard]] const std::string& of(std::size_t file) const { return of_file_[file]; }

  private:
    static bool add(std::string& machines, char machine) {
        const bool is_new = machines.find(machine) == std::string::npos;
        if (is_new) machines += machine;
        return is_new;
    }

    /// Over files that do not show theirs. A list that many files call is gone through once for each machine.
    void hand_on(std::size_t first, char machine) {
        if (!add(of_file_[first], machine)) return;
        std::vector<std::size_t> worklist = {first};
        while (!worklist.empty()) {
            const std::size_t caller = worklist.back();
            worklist.pop_back();
            for (const NamesakeList* namesakes : called_[caller]) {
                if (!add(of_list_[namesakes], machine)) continue;
                for (const ProgramIndex meant : *namesakes) {
                    const std::size_t file = file_of_[meant];
                    if (!files_[file].machine_signs.tell && add(of_file_[file], machine))
                        worklist.push_back(file);
                }
            }
        }
    }

    std::span<const FileOutline> files_;
    CallResolver resolver_;
    std::vector<std::size_t> file_of_; ///< by program
    std::vector<std::vector<const NamesakeList*>> called_;
    std::vector<std::string> of_file_;
    std::unordered_map<const NamesakeList*, std::string> of_list_;
};

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
    const Machines machines(files);
    for (std::size_t file = 0; file < files.size(); ++file)
        if (!files[file].machine_signs.tell)
            lathes[file] = lathe_among(machines.of(file), files[file].machine_signs);
    return lathes;
}

} // namespace maclint
