//! Files that are the same first, by a map; of the rest every pair, within a bound.
#include "cli/gate/renamed_files.hpp"

#include "cli/gate/line_difference.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <tuple>

namespace maclint::cli {
namespace {

constexpr double least_share = 0.5;
/// Pairs, and lines that are looked at in all of them: less than a second.
constexpr std::size_t most_pairs = 10'000'000;
constexpr std::size_t most_lines = 100'000'000;

using Files = std::vector<const NamedLines*>;

std::string_view name_of(std::string_view path) {
    const auto slash = path.rfind('/');
    return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

struct Pair {
    double share;
    const NamedLines* gone;
    const NamedLines* added;

    /// Of two that share alike, the one that has kept its name.
    [[nodiscard]] auto rank() const {
        const bool has_other_name = name_of(gone->path) != name_of(added->path);
        return std::tuple(-share, has_other_name, std::string_view(added->path),
                          std::string_view(gone->path));
    }
};

/// Of files that are all the same as many as are gone; those that have kept a name come first.
void pair_same(const Files& gone, Files added, Renames& renames) {
    std::set<std::string_view> names;
    for (const NamedLines* file : gone) names.insert(name_of(file->path));
    std::ranges::stable_partition(
        added, [&](const NamedLines* file) { return names.contains(name_of(file->path)); });
    for (std::size_t i = 0; i < std::min(gone.size(), added.size()); ++i)
        renames.gone_by_new[added[i]->path] = gone[i]->path;
}

/// Pairs that have half in common, of all pairs; nothing where that is too much work.
std::optional<std::vector<Pair>> similar_pairs(const Files& gone, const Files& added) {
    if (gone.size() * added.size() > most_pairs) return std::nullopt;
    std::vector<Pair> pairs;
    std::size_t lines = 0;
    for (const NamedLines* newer : added) {
        for (const NamedLines* older : gone) {
            if (!older->lines.may_share_half_with(newer->lines)) continue;
            lines += older->lines.lines() + newer->lines.lines();
            if (lines > most_lines) return std::nullopt;
            const double share = older->lines.share_with(newer->lines);
            if (share >= least_share) pairs.push_back({share, older, newer});
        }
    }
    std::ranges::sort(pairs, {}, &Pair::rank);
    return pairs;
}

/// Of those alone that bear the same name, which only one that is gone had.
std::vector<Pair> similar_namesakes(const Files& gone, const Files& added) {
    std::map<std::string_view, Files> by_name;
    for (const NamedLines* file : gone) by_name[name_of(file->path)].push_back(file);
    std::vector<Pair> pairs;
    for (const NamedLines* file : added) {
        const auto same = by_name.find(name_of(file->path));
        if (same == by_name.end() || same->second.size() > 1) continue;
        const double share = same->second.front()->lines.share_with(file->lines);
        if (share >= least_share) pairs.push_back({share, same->second.front(), file});
    }
    std::ranges::sort(pairs, {}, &Pair::rank);
    return pairs;
}

Files without(std::span<const NamedLines> files, const std::set<std::string_view>& paths) {
    Files rest;
    for (const NamedLines& file : files)
        if (!paths.contains(file.path)) rest.push_back(&file);
    return rest;
}

} // namespace

std::size_t LineBag::count_lines(std::string_view text) {
    return static_cast<std::size_t>(std::ranges::count(text, '\n')) + 1;
}

LineBag::LineBag(std::string_view text) {
    lines_.reserve(count_lines(text));
    while (!text.empty()) {
        const FirstLine line(text);
        text.remove_prefix(line.size);
        lines_.push_back({std::hash<std::string_view>{}(line.words), line.words.size() + 1});
        bytes_ += lines_.back().size;
    }
    std::ranges::sort(lines_);
}

double LineBag::share_with(const LineBag& other) const {
    std::size_t both = 0;
    for (auto one = lines_.begin(), two = other.lines_.begin();
         one != lines_.end() && two != other.lines_.end();) {
        if (*one == *two) both += one->size;
        const bool one_goes_on = *one <= *two;
        if (*two <= *one) ++two;
        if (one_goes_on) ++one;
    }
    const std::size_t larger = std::max(bytes_, other.bytes_);
    return larger == 0 ? 1 : static_cast<double>(both) / static_cast<double>(larger);
}

bool LineBag::may_share_half_with(const LineBag& other) const {
    return bytes_ <= 2 * other.bytes_ && other.bytes_ <= 2 * bytes_;
}

Renames find_renames(const std::vector<NamedLines>& gone, const std::vector<NamedLines>& added) {
    Renames renames;
    std::map<std::reference_wrapper<const LineBag>, std::pair<Files, Files>, std::less<LineBag>> same;
    for (const NamedLines& file : gone) same[file.lines].first.push_back(&file);
    for (const NamedLines& file : added) same[file.lines].second.push_back(&file);
    for (const auto& [lines, files] : same) pair_same(files.first, files.second, renames);
    std::set<std::string_view> gone_before;
    std::set<std::string_view> added_before;
    for (const auto& [newer, older] : renames.gone_by_new) {
        added_before.insert(newer);
        gone_before.insert(older);
    }
    const Files rest_gone = without(gone, gone_before);
    const Files rest_added = without(added, added_before);
    auto pairs = similar_pairs(rest_gone, rest_added);
    renames.bound_was_met = !pairs;
    if (!pairs) pairs = similar_namesakes(rest_gone, rest_added);
    std::set<const NamedLines*> paired;
    for (const Pair& pair : *pairs)
        if (!paired.contains(pair.gone) && !paired.contains(pair.added)) {
            paired.insert({pair.gone, pair.added});
            renames.gone_by_new[pair.added->path] = pair.gone->path;
        }
    return renames;
}

} // namespace maclint::cli
