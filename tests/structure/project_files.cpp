//! Walks the repository and takes C++ apart as far as the structure tests need it.
#include "tests/structure/project_files.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

namespace maclint::structure {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> source_folders = {"analyzer/", "rules/", "cli/",
                                                            "tests/",    "bench/", "fuzz/"};
constexpr std::array<std::string_view, 5> ignored_names = {".git", ".cache", "node_modules", "__pycache__",
                                                           "compile_commands.json"};

/// `build`, and those that somebody keeps beside it: gigabytes of objects.
bool is_build_folder(const fs::directory_entry& entry) {
    return entry.is_directory() &&
           (entry.path().filename() == "build" || entry.path().filename().string().starts_with("build-"));
}

template<class Names>
bool is_one_of(const Names& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::string read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Length of the comment, string or other single character that `code` begins with.
std::size_t token_length(std::string_view code) {
    const auto up_to = [code](std::string_view end, std::size_t from) {
        const auto found = code.find(end, from);
        return found == std::string_view::npos ? code.size() : found + end.size();
    };
    if (code.starts_with("//")) return std::min(code.find('\n'), code.size());
    if (code.starts_with("/*")) return up_to("*/", 2);
    if (code.starts_with("R\"")) {
        const auto open = std::min(code.find('('), code.size());
        return up_to(")" + std::string(code.substr(2, open - 2)) + "\"", open);
    }
    if (code.front() != '"') return 1;
    std::size_t end = 1;
    while (end < code.size() && code[end] != '"') end += code[end] == '\\' ? 2 : 1;
    return std::min(end + 1, code.size());
}

} // namespace

std::vector<ProjectFile> all_files() {
    const fs::path root = MACLINT_SOURCE_DIR;
    std::vector<ProjectFile> files;
    for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator();
         ++entry) {
        if (is_one_of(ignored_names, entry->path().filename().string()) || is_build_folder(*entry)) {
            entry.disable_recursion_pending();
        } else if (entry->is_regular_file() && !entry->is_symlink()) {
            files.push_back({fs::relative(entry->path(), root).generic_string(), read(entry->path())});
        }
    }
    return files;
}

std::vector<ProjectFile> sources() {
    auto files = all_files();
    std::erase_if(files, [](const ProjectFile& file) {
        const bool is_cpp = file.path.ends_with(".cpp") || file.path.ends_with(".hpp");
        return !is_cpp ||
               std::none_of(source_folders.begin(), source_folders.end(),
                            [&file](std::string_view folder) { return file.path.starts_with(folder); });
    });
    return files;
}

bool is_finder(std::string_view path) {
    return path.starts_with("rules/") && (path.ends_with("_finder.hpp") || path.ends_with("_finder.cpp"));
}

std::string without_comments(std::string_view code) {
    std::string out;
    while (!code.empty()) {
        const auto token = code.substr(0, token_length(code));
        const bool is_comment = token.starts_with("//") || token.starts_with("/*");
        out += is_comment ? " " : token;
        code.remove_prefix(token.size());
    }
    return out;
}

std::vector<std::string> quoted_includes(std::string_view code) {
    constexpr std::string_view directive = "#include \"";
    std::vector<std::string> includes;
    for (auto at = code.find(directive); at != std::string_view::npos; at = code.find(directive, at + 1)) {
        const auto name = code.substr(at + directive.size());
        includes.emplace_back(name.substr(0, name.find('"')));
    }
    return includes;
}

} // namespace maclint::structure
