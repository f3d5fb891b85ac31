//! The calls of all files, and the programs that they may mean.
#pragma once

#include "analyzer/workspace/resolve.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace maclint {

/// The file of each program: places in `files`, by ProgramIndex.
[[nodiscard]] inline std::vector<std::size_t> files_of_programs(std::span<const FileOutline> files) {
    std::vector<std::size_t> file_of;
    for (std::size_t file = 0; file < files.size(); ++file)
        file_of.insert(file_of.end(), files[file].programs.size(), file);
    return file_of;
}

/// Visits (place of the file, `const NamesakeList&`) for every list of programs that a call may mean. Calls
/// share the lists, which live as long as the resolver.
template<class Visit>
void for_each_called_list(const CallResolver& resolver, std::span<const FileOutline> files,
                          const Visit& visit) {
    for (std::size_t file = 0; file < files.size(); ++file)
        for (const ProgramOutline& program : files[file].programs)
            for (const CallOutline& call : program.calls)
                for (const auto& namesakes : resolver.resolve(file, program, call).nearest)
                    visit(file, *namesakes);
}

} // namespace maclint
