//! From the paths of the command line to the files that are read.
#pragma once

#include "cli/config/settings.hpp"
#include "cli/notice.hpp"

#include <string>
#include <vector>

namespace maclint::cli {

/// A file to be read.
struct InputFile {
    std::string path;            ///< as it is shown
    bool named = false;          ///< by the user, not found in a folder
    bool asked = true;           ///< findings are wanted
    bool standard_input = false; ///< its bytes come from there; `path` is only its name
};

struct Discovered {
    std::vector<InputFile> files; ///< sorted by path, each file once
    std::vector<Notice> notices;
};

/// The files that the paths name: files themselves whatever their name is, in folders NC files in the order
/// of their names. "-" is standard input under the name `stdin_name`, in place of the file of that name.
/// Hidden folders, build folders and what the configuration excludes are passed over.
[[nodiscard]] Discovered discover(const std::vector<std::string>& paths, const std::string& stdin_name,
                                  Settings& settings);

/// The other programs that may call those that were asked for or be called, with `asked` false: for a file
/// that was named, those in the folder of the nearest configuration, else in the repository, else beside the
/// file; for one that was found in one of `paths`, those of a configuration that says they are complete.
[[nodiscard]] Discovered discover_context(const std::vector<InputFile>& asked,
                                          const std::vector<std::string>& paths, Settings& settings);

} // namespace maclint::cli
