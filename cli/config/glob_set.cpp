//! Globs with a slash are a tree of names, walked along all its branches at once.
#include "cli/config/glob_set.hpp"

#include "analyzer/source/platform/paths.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <utility>

namespace maclint::cli {
namespace {

constexpr std::string_view wildcards = "*?[]";

/// A tree of the patterns that have a slash, name by name.
class PathPatterns {
  public:
    /// `names` is not empty.
    void add(const std::vector<std::string_view>& names, std::size_t glob) {
        std::uint32_t at = 0;
        for (const std::string_view name : names) at = name == "**" ? across(at) : below(at, name);
        nodes_[at].ends.push_back(glob);
    }

    void find(const std::vector<std::string_view>& names, std::vector<std::size_t>& globs) const {
        std::vector<std::uint32_t> places;
        std::vector<std::uint32_t> next = {0};
        for (const std::string_view name : names) {
            enter(next, true, globs);
            places.swap(next);
            next.clear();
            for (const std::uint32_t place : places) {
                nodes_[place].names.find(name, next);
                if (nodes_[place].crosses) next.push_back(place);
            }
        }
        enter(next, false, globs);
    }

  private:
    struct Node {
        NamePatterns names; ///< to the nodes below
        std::optional<std::uint32_t> across;
        bool crosses = false; ///< it is the one of "**", which any number of names leads to
        std::vector<std::size_t> ends;
    };

    std::uint32_t add_node() {
        nodes_.emplace_back();
        return static_cast<std::uint32_t>(nodes_.size() - 1);
    }

    std::uint32_t below(std::uint32_t at, std::string_view name) {
        const auto next = static_cast<std::uint32_t>(nodes_.size());
        const std::uint32_t node = nodes_[at].names.add(std::string(name), next);
        return node == next ? add_node() : node;
    }

    /// "**" behind "**" is one.
    std::uint32_t across(std::uint32_t at) {
        if (nodes_[at].crosses) return at;
        if (!nodes_[at].across) {
            const std::uint32_t node = add_node();
            nodes_[node].crosses = true;
            nodes_[at].across = node;
        }
        return *nodes_[at].across;
    }

    /// Adds the nodes that no name leads to, and takes the globs that end there: in a folder that has what
    /// was asked for in it, or at that itself. "**" at the end stands for one name at least.
    void enter(std::vector<std::uint32_t>& places, bool more_names, std::vector<std::size_t>& globs) const {
        for (std::size_t i = 0, count = places.size(); i < count; ++i)
            if (const auto node = nodes_[places[i]].across) places.push_back(*node);
        std::ranges::sort(places);
        places.erase(std::unique(places.begin(), places.end()), places.end());
        for (const std::uint32_t place : places) {
            const Node& node = nodes_[place];
            if (more_names || !node.crosses) globs.insert(globs.end(), node.ends.begin(), node.ends.end());
        }
    }

    std::vector<Node> nodes_ = std::vector<Node>(1);
};

bool has_slash(std::string_view pattern) {
    if (pattern.ends_with('/')) pattern.remove_suffix(1);
    return pattern.find('/') != std::string_view::npos;
}

} // namespace

std::uint32_t NamePatterns::add(const std::string& pattern, std::uint32_t next) {
    const auto [known, is_new] = known_.try_emplace(pattern, next);
    if (!is_new) return known->second;
    const auto first = pattern.find_first_of(wildcards);
    if (first == std::string::npos) return next;
    const std::size_t tail = pattern.size() - pattern.find_last_of(wildcards) - 1;
    if (first == 0 && tail == 0)
        others_.push_back({pattern, next});
    else if (first >= tail)
        put(by_head_, std::string_view(pattern).substr(0, first), {pattern, next});
    else
        put(by_tail_, std::string_view(pattern).substr(pattern.size() - tail), {pattern, next});
    return next;
}

void NamePatterns::put(ByEnd& index, std::string_view end, Pattern pattern) {
    if (std::ranges::find(index.lengths, end.size()) == index.lengths.end())
        index.lengths.push_back(end.size());
    index.patterns[std::string(end)].push_back(std::move(pattern));
}

void NamePatterns::try_all(const std::vector<Pattern>& patterns, std::string_view name,
                           std::vector<std::uint32_t>& numbers) {
    for (const Pattern& pattern : patterns)
        if (matches_name(pattern.text, name)) numbers.push_back(pattern.number);
}

void NamePatterns::find(std::string_view name, std::vector<std::uint32_t>& numbers) const {
    // A pattern without wildcards that is the name; one with wildcards is among those below.
    const bool plain = name.find_first_of(wildcards) == std::string_view::npos;
    if (const auto known = known_.find(name); plain && known != known_.end())
        numbers.push_back(known->second);
    for (const std::size_t length : by_head_.lengths)
        if (length <= name.size())
            if (const auto at = by_head_.patterns.find(name.substr(0, length)); at != by_head_.patterns.end())
                try_all(at->second, name, numbers);
    for (const std::size_t length : by_tail_.lengths)
        if (length <= name.size())
            if (const auto at = by_tail_.patterns.find(name.substr(name.size() - length));
                at != by_tail_.patterns.end())
                try_all(at->second, name, numbers);
    try_all(others_, name, numbers);
}

struct GlobSet::OfFolder {
    explicit OfFolder(const std::string& of)
        : folder(platform::path_of(of)) {}

    std::filesystem::path folder;
    NamePatterns names; ///< of globs without a slash
    std::vector<std::vector<std::size_t>> globs_of_name;
    PathPatterns paths;
};

GlobSet::GlobSet() = default;

GlobSet::GlobSet(const std::vector<Glob>& globs) {
    std::map<std::string, std::shared_ptr<OfFolder>> folders;
    for (std::size_t i = 0; i < globs.size(); ++i) {
        auto& of = folders[globs[i].folder];
        if (!of) of = std::make_shared<OfFolder>(globs[i].folder);
        const auto names = names_of(globs[i].pattern);
        if (names.empty()) continue;
        if (has_slash(globs[i].pattern)) {
            of->paths.add(names, i);
            continue;
        }
        const auto next = static_cast<std::uint32_t>(of->globs_of_name.size());
        const std::uint32_t number = of->names.add(std::string(names.front()), next);
        if (number == next) of->globs_of_name.emplace_back();
        of->globs_of_name[number].push_back(i);
    }
    for (auto& [folder, of] : folders) folders_.push_back(std::move(of));
}

std::vector<std::size_t> GlobSet::that_take(const std::string& path) const {
    std::vector<std::size_t> globs;
    if (folders_.empty()) return globs;
    std::error_code ignored;
    const auto whole = std::filesystem::absolute(platform::path_of(path), ignored).lexically_normal();
    for (const auto& of : folders_) {
        const std::string relative = platform::text_of(whole.lexically_relative(of->folder));
        const auto names = names_of(relative);
        std::vector<std::uint32_t> numbers;
        for (const std::string_view name : names) of->names.find(name, numbers);
        for (const std::uint32_t number : numbers)
            globs.insert(globs.end(), of->globs_of_name[number].begin(), of->globs_of_name[number].end());
        of->paths.find(names, globs);
    }
    std::ranges::sort(globs);
    globs.erase(std::unique(globs.begin(), globs.end()), globs.end());
    return globs;
}

} // namespace maclint::cli
