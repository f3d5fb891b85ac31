//! Reads a .git that is a file, and `commondir`.
#include "cli/input/git_folders.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "analyzer/source/read.hpp"
#include "cli/input/links.hpp"
#include "cli/input/size_limits.hpp"

#include <algorithm>
#include <string>
#include <string_view>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

std::string named_in(const fs::path& file, std::string_view word) {
    if (platform::kind_of(file) != platform::FileKind::regular) return {};
    const auto read = read_file(platform::text_of(file), git_pointer_limit);
    const auto* const source = std::get_if<Source>(&read);
    return path_named_in(source == nullptr ? std::string_view() : source->bytes(), word);
}

} // namespace

std::string path_named_in(std::string_view text, std::string_view word) {
    text = text.substr(0, text.find_last_not_of("\r\n") + 1);
    text = text.substr(0, text.find('\0')); // git is written in C
    return text.starts_with(word) ? std::string(text.substr(word.size())) : std::string();
}

GitFolders git_folders_of(const fs::path& root) {
    const fs::path git = root / ".git";
    if (leaves_drive(git, root)) return {git, git};
    const fs::path named = platform::path_of(named_in(git, "gitdir: "));
    if (leaves_drive(named, root)) return {git, git};
    const fs::path own = named.empty() ? git : root / named;
    if (leaves_drive("commondir", own)) return {own, own};
    const fs::path common = platform::path_of(named_in(own / "commondir", ""));
    return {own, common.empty() || leaves_drive(common, own) ? own : own / common};
}

bool is_sparse(const fs::path& root) {
    return platform::kind_of(git_folders_of(root).own / "info" / "sparse-checkout") ==
           platform::FileKind::regular;
}

} // namespace maclint::cli
