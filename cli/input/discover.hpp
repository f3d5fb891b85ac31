//! From the paths of the command line to the files that are read.
#pragma once

#include "cli/config/settings.hpp"
#include "cli/input/passed_over.hpp"
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

struct DiscoverOptions {
    bool gitignore = true;         ///< in a repository, what git ignores is passed over in folders
    bool follow_links = false;     ///< in folders, wherever they lead
    bool force_exclude = false;    ///< what folders are searched without is passed over when it is named, too
    bool list_passed_over = false; ///< by name and reason, too, not only in numbers
};

struct Discovered {
    std::vector<InputFile> files; ///< sorted by path, each file once
    std::vector<Notice> notices;
    PassedOver passed_over;
    std::vector<PassedFile> files_passed_over; ///< where they are to be listed
};

/// The files that the paths name: files themselves whatever their name is, in folders NC files in the order
/// of their names. "-" is standard input under the name `stdin_name`, in place of the file of that name.
/// Hidden folders, build folders, what the configuration excludes, what git ignores, and links to what is in
/// none of the paths are passed over.
[[nodiscard]] Discovered discover(const std::vector<std::string>& paths, const std::string& stdin_name,
                                  Settings& settings, DiscoverOptions options = {});

/// The other programs that may call those that were asked for or be called, with `asked` false: for a file
/// that was named, those in the folder of the nearest configuration, else in the repository, else beside the
/// file; for one that was found in one of `paths`, those of a configuration that says they are complete.
/// Links out of these folders are passed over, too.
[[nodiscard]] Discovered discover_context(const std::vector<InputFile>& asked,
                                          const std::vector<std::string>& paths, Settings& settings,
                                          DiscoverOptions options = {});

} // namespace maclint::cli
