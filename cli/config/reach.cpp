//! Files are where they are after all links.
#include "cli/config/reach.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/output.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/input/other_server.hpp"
#include "cli/input/repository.hpp"

#include <system_error>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

fs::path place_of(const fs::path& path) {
    return platform::path_of(platform::written_path(platform::text_of(path)));
}

/// Whether all that is on the way can be looked at: else nobody knows where it leads.
bool is_known(const fs::path& path) {
    std::error_code error;
    static_cast<void>(platform::real_path(path, error));
    return !error || error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory ||
           error == std::errc::too_many_symbolic_link_levels;
}

} // namespace

Reach Reach::of_folder(const fs::path& folder) {
    Reach reach;
    reach.folder_ = place_of(folder);
    reach.repository_ = repository_around(*reach.folder_);
    return reach;
}

std::optional<std::string> Reach::objection(std::string_view written, const fs::path& file) const {
    if (!folder_) return std::nullopt;
    const std::string from = platform::text_of(*folder_);
    std::error_code gone;
    const fs::path absolute = fs::absolute(file, gone);
    if (names_other_server(written, from) || leads_to_other_server(absolute, from))
        return "is on another server";
    if (names_other_drive(written, from)) return "is on another drive";
    if (is_known(absolute) && holds(place_of(absolute))) return std::nullopt;
    return repository_ ? "lies outside of this repository" : "lies outside of this folder and those above it";
}

bool Reach::holds(const fs::path& real) const {
    if (platform::lies_in(real, repository_ ? *repository_ : *folder_)) return true;
    return !repository_ && platform::lies_in(*folder_, real.parent_path());
}

bool is_of_stranger(const platform::Ownership& ownership) {
    constexpr std::uint64_t root = 0;
    return ownership.owner != ownership.runner && ownership.owner != root;
}

} // namespace maclint::cli
