//! Files are where they are after all links.
#include "cli/config/reach.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/output.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/input/other_server.hpp"
#include "cli/input/repository.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;

/// Whether all that is on the way can be looked at: else nobody knows where it leads.
bool is_known(const fs::path& path) {
    std::error_code error;
    static_cast<void>(platform::real_path(path, error));
    return !error || error == std::errc::no_such_file_or_directory || error == std::errc::not_a_directory ||
           error == std::errc::too_many_symbolic_link_levels;
}

} // namespace

Reach Reach::of_folder(const fs::path& folder, const std::vector<fs::path>& own) {
    Reach reach;
    reach.folder_ = platform::place_of(folder);
    reach.repository_ = repository_around(*reach.folder_);
    if (!reach.repository_)
        std::ranges::copy_if(own, std::back_inserter(reach.own_),
                             [&](const fs::path& tree) { return platform::lies_in(*reach.folder_, tree); });
    return reach;
}

bool Reach::may_quote(const fs::path& file) const {
    return !folder_ || has_in_its_trees(platform::place_of(file));
}

std::optional<std::string> Reach::objection(std::string_view written, const fs::path& file) const {
    if (!folder_) return std::nullopt;
    const std::string from = platform::text_of(*folder_);
    std::error_code gone;
    const fs::path absolute = fs::absolute(file, gone);
    if (names_other_server(written, from) || leads_to_other_server(absolute, from))
        return "is on another server";
    if (names_other_drive(written, from)) return "is on another drive";
    if (is_known(absolute) && holds(platform::place_of(absolute))) return std::nullopt;
    return repository_ ? "lies outside of this repository" : "lies outside of this folder and those above it";
}

bool Reach::has_in_its_trees(const fs::path& real) const {
    return platform::lies_in(real, repository_ ? *repository_ : *folder_) ||
           std::ranges::any_of(own_, [&](const fs::path& tree) { return platform::lies_in(real, tree); });
}

bool Reach::holds(const fs::path& real) const {
    return has_in_its_trees(real) || (!repository_ && platform::lies_in(*folder_, real.parent_path()));
}

std::vector<fs::path> own_folders(const std::vector<std::string>& named) {
    std::vector<fs::path> own;
    const auto add = [&](fs::path place) {
        if (place.has_relative_path()) own.push_back(std::move(place));
    };
    for (const std::string& path : named)
        if (platform::kind_of(platform::path_of(path)) == platform::FileKind::folder)
            add(platform::place_of(platform::path_of(path)));
    std::error_code gone;
    fs::path working = fs::current_path(gone);
    if (gone) return own;
    working = platform::place_of(working);
    const auto home = platform::home_folder();
    if (!home || !platform::lies_in(platform::place_of(*home), working)) add(std::move(working));
    return own;
}

bool is_of_stranger(const platform::Ownership& ownership) {
    constexpr std::uint64_t root = 0;
    return ownership.owner != ownership.runner && ownership.owner != root;
}

} // namespace maclint::cli
