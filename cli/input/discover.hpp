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
/// of their names. "-" is standard input under the name `stdin_name`. Hidden folders, build folders and what
/// the configuration excludes are passed over.
[[nodiscard]] Discovered discover(const std::vector<std::string>& paths, const std::string& stdin_name,
                                  Settings& settings);

/// When only single files were named: the other programs that may call them or be called, with `asked` false.
/// Those in the folder of the nearest configuration, else in the repository, else beside the file.
[[nodiscard]] Discovered discover_context(const std::vector<InputFile>& asked, Settings& settings);

} // namespace maclint::cli
