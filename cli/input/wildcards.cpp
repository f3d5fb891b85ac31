//! Goes down name by name, with all folders that fit so far.
#include "cli/input/wildcards.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/config/glob.hpp"
#include "cli/text/letters.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <system_error>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

bool has_wildcard(std::string_view text) { return text.find_first_of("*?") != std::string_view::npos; }

/// The same as a glob, where '[' is a wildcard, too.
std::string glob_of(std::string_view name) {
    if (name == "*.*") return "*";
    std::string glob;
    for (const char c : in_lower_case(name)) glob += c == '[' ? "[[]" : std::string(1, c);
    return glob;
}

std::vector<fs::path> entries_that_fit(const fs::path& folder, const std::string& name) {
    std::error_code unreadable;
    std::vector<fs::path> found;
    const std::string glob = glob_of(name);
    for (const auto& entry : platform::entries_of(folder.empty() ? "." : folder, unreadable)) {
        const std::string there = platform::text_of(entry.path.filename());
        const bool hidden = there.starts_with('.') && !name.starts_with('.');
        if (!hidden && matches_name(glob, in_lower_case(there)))
            found.push_back(folder / entry.path.filename());
    }
    std::ranges::sort(found);
    return found;
}

std::vector<fs::path> paths_that_fit(const fs::path& pattern) {
    std::vector<fs::path> found = {pattern.root_path()};
    for (const fs::path& part : pattern.relative_path()) {
        const std::string name = platform::text_of(part);
        std::vector<fs::path> longer;
        for (const fs::path& folder : found) {
            if (has_wildcard(name))
                std::ranges::move(entries_that_fit(folder, name), std::back_inserter(longer));
            else if (platform::kind_of(folder / part) != platform::FileKind::missing)
                longer.push_back(folder / part);
        }
        found = std::move(longer);
    }
    return found;
}

} // namespace

std::vector<std::string> with_wildcards_expanded(const std::vector<std::string>& paths) {
    std::vector<std::string> expanded;
    for (const std::string& path : paths) {
        const auto found =
            has_wildcard(path) ? paths_that_fit(platform::path_of(path)) : std::vector<fs::path>();
        for (const fs::path& one : found) expanded.push_back(platform::text_of(one));
        if (found.empty()) expanded.push_back(path);
    }
    return expanded;
}

} // namespace maclint::cli
