//! The project's own files as the structure tests read them.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::structure {

struct ProjectFile {
    std::string path; ///< from the root of the repository, with '/'
    std::string text;
};

/// Every file under the root but what git ignores: build folders and caches.
std::vector<ProjectFile> all_files();

/// The C++ sources and headers of the layers, the tests and the benchmarks.
std::vector<ProjectFile> sources();

/// `rules/<room>/<rule>_finder.hpp` or `.cpp`: what one rule alone asks of a program.
bool is_finder(std::string_view path);

/// The code with comments blanked out; strings stay.
std::string without_comments(std::string_view code);

/// The quoted names of a file's #include lines.
std::vector<std::string> quoted_includes(std::string_view code);

} // namespace maclint::structure
