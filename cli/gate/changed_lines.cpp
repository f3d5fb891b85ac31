//! Three questions to git: which commit is meant, what differs from it, and which files it knows at all.
#include "cli/gate/changed_lines.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/output.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "analyzer/source/platform/process.hpp"
#include "cli/input/repository.hpp"
#include "cli/suggest.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

namespace maclint::cli {
namespace {

/// The repository of a file, which is named after all links.
std::optional<std::string> repository_of(const std::string& path) {
    const auto root = repository_around(platform::path_of(path).parent_path());
    return root ? std::optional(platform::text_of(*root)) : std::nullopt;
}

/// Names with quotes, line ends and the like stand in quotes, as C writes them.
std::string unquoted(std::string_view name) {
    if (!name.starts_with('"')) return std::string(name);
    name.remove_prefix(1);
    if (name.ends_with('"')) name.remove_suffix(1);
    constexpr std::string_view letters = "abtnvfr";
    constexpr std::string_view meant = "\a\b\t\n\v\f\r";
    std::string out;
    for (std::size_t i = 0; i < name.size(); ++i) {
        if (name[i] != '\\' || i + 1 == name.size()) {
            out += name[i];
            continue;
        }
        const char escaped = name[++i];
        if (const auto letter = letters.find(escaped); letter != std::string_view::npos) {
            out += meant[letter];
        } else if (unsigned code = 0;
                   std::from_chars(&name[i], &name[i] + std::min<std::size_t>(3, name.size() - i), code, 8)
                       .ec == std::errc{}) {
            out += static_cast<char>(code);
            i += 2;
        } else {
            out += escaped;
        }
    }
    return out;
}

/// "12,3" behind a sign: where a hunk begins, and how many lines it has. One when nothing is said.
std::pair<std::uint32_t, std::uint32_t> range_at(std::string_view header, char sign) {
    const auto at = header.find(std::string{' ', sign});
    if (at == std::string_view::npos) return {0, 0};
    std::uint32_t first = 0;
    std::uint32_t count = 1;
    const char* const end = header.data() + header.size();
    const auto begin = std::from_chars(header.data() + at + 2, end, first);
    if (begin.ptr != end && *begin.ptr == ',') std::from_chars(begin.ptr + 1, end, count);
    return {first, count};
}

Notice refusal(const std::string& message) { return {NoticeKind::configuration, "", message}; }

/// The first line of what git says.
std::string words_of(const platform::ProcessEnd& end) {
    const std::string line = end.errors.substr(0, end.errors.find('\n'));
    return line.empty() ? "it ended with status " + std::to_string(end.status)
                        : "it says '" + shown(line) + "'";
}

Notice git_failed(const std::string& root, const platform::ProcessEnd& end) {
    if (!end.started)
        return refusal("--since runs git, and no git is found here. Install it, or leave --since out.");
    return refusal("--since cannot ask git about '" + shown(root) + "': " + words_of(end) +
                   ". Try 'git status' there, or leave --since out.");
}

std::vector<std::string> git(const std::string& root, std::initializer_list<std::string> words) {
    std::vector<std::string> all = {"git", "--no-optional-locks", "-C", root, "-c", "core.quotePath=false"};
    all.insert(all.end(), words);
    return all;
}

} // namespace

void DiffReader::take(std::string_view part) {
    constexpr std::size_t longest = 65536; // longer than any name in quotes
    while (!part.empty()) {
        const auto end = part.find('\n');
        const std::string_view piece = part.substr(0, end);
        begun_ += piece.substr(0, longest - std::min(longest, begun_.size()));
        if (end == std::string_view::npos) return;
        take_line(begun_);
        begun_.clear();
        part.remove_prefix(end + 1);
    }
}

/// Programs may hold lines that look like headers: lines of a hunk are counted.
void DiffReader::take_line(std::string_view line) {
    if (line.starts_with('\\')) return; // no line end at the end of the file
    if (content_lines_ > 0) {
        --content_lines_;
        return;
    }
    if (line.starts_with("+++ ")) {
        line.remove_prefix(4);
        if (line.ends_with('\t')) line.remove_suffix(1); // behind names with blanks
        const std::string name = unquoted(line);
        name_ = name.starts_with("b/") ? name.substr(2) : "";
    } else if (line.starts_with("@@ ")) {
        const auto [old_first, removed] = range_at(line, '-');
        const auto [first, added] = range_at(line, '+');
        content_lines_ = std::uint64_t{removed} + added;
        if (!name_.empty())
            ranges_[name_].push_back(added > 0 ? LineRange{first, first + added - 1}
                                               : LineRange{std::max(first, 1U), first + 1});
    }
}

std::map<std::string, std::vector<LineRange>> DiffReader::finish() {
    if (!begun_.empty()) take_line(begun_);
    begun_.clear();
    return std::move(ranges_);
}

std::variant<ChangedLines, Notice> ChangedLines::since(const std::string& revision,
                                                       const std::vector<InputFile>& files) {
    ChangedLines changed;
    changed.revision_ = revision;
    std::set<std::string> roots;
    for (const InputFile& file : files) {
        if (!file.asked) continue;
        if (file.standard_input) changed.standard_input_.insert(file.path);
        if (file.standard_input ||
            platform::kind_of(platform::path_of(file.path)) == platform::FileKind::missing)
            continue;
        auto root = repository_of(platform::written_path(file.path));
        if (!root)
            return refusal("--since wants files of a git repository, and '" + shown(file.path) +
                           "' lies in none. Leave --since out, or this file.");
        roots.insert(*std::move(root));
    }
    for (const std::string& root : roots) {
        if (auto failure = changed.ask(root)) return *std::move(failure);
        changed.known_[root] = true;
    }
    return changed;
}

bool ChangedLines::knows(const std::string& root) {
    const auto [known, is_new] = known_.try_emplace(root, false);
    if (is_new) known->second = !ask(root);
    return known->second;
}

std::optional<Notice> ChangedLines::ask(const std::string& root) {
    std::string commit;
    const auto named =
        platform::run_process(git(root, {"rev-parse", "--verify", "--quiet", revision_ + "^{commit}"}),
                              [&](std::string_view part) { commit += part; });
    commit.erase(std::min(commit.find('\n'), commit.size()));
    if (!named.started || (named.status != 0 && !named.errors.empty())) return git_failed(root, named);
    if (named.status != 0 || commit.empty())
        return refusal("--since names no revision that git knows in '" + shown(root) + "': '" +
                       shown(revision_) +
                       "'. Write a commit, a branch or a tag; where only a part of the history was fetched, "
                       "fetch the rest.");
    DiffReader reader;
    const auto compared = platform::run_process(
        git(root, {"diff", "--unified=0", "--inter-hunk-context=0", "--no-color", "--no-ext-diff",
                   "--no-textconv", "--text", "--find-renames", "--ignore-cr-at-eol", "--ignore-submodules",
                   "--src-prefix=a/", "--dst-prefix=b/", commit, "--"}),
        [&](std::string_view part) { reader.take(part); });
    if (!compared.started || compared.status != 0) return git_failed(root, compared);
    std::string names;
    const auto listed =
        platform::run_process(git(root, {"ls-files", "-z"}), [&](std::string_view part) { names += part; });
    if (!listed.started || listed.status != 0) return git_failed(root, listed);
    const auto place_of = [&](std::string_view name) {
        return platform::text_of(platform::path_of(root) / platform::path_of(name));
    };
    for (auto& [name, ranges] : reader.finish()) ranges_[place_of(name)] = std::move(ranges);
    for (std::string_view rest = names; !rest.empty();) {
        const std::string_view name = rest.substr(0, rest.find('\0'));
        tracked_.insert(place_of(name));
        rest.remove_prefix(std::min(rest.size(), name.size() + 1));
    }
    return std::nullopt;
}

ChangedLines::File ChangedLines::look_up(const Source& source) {
    if (standard_input_.contains(source.path())) return {.all = true};
    const std::string path = platform::written_path(source.path());
    const auto root = repository_of(path);
    if (!root || !knows(*root)) return {};
    const auto found = ranges_.find(path);
    if (found == ranges_.end()) return {.all = !tracked_.contains(path)};
    File file{.ranges = found->second};
    const std::string_view bytes = source.bytes();
    for (auto at = bytes.find('\n'); at != std::string_view::npos; at = bytes.find('\n', at + 1))
        file.line_feeds.push_back(static_cast<Offset>(at));
    return file;
}

bool ChangedLines::touch(const Source& source, Span span) {
    const auto [entry, is_new] = files_.try_emplace(&source);
    if (is_new) entry->second = look_up(source);
    const File& file = entry->second;
    if (file.all || file.ranges.empty()) return file.all;
    const auto line_of = [&](Offset offset) {
        const auto before = std::ranges::lower_bound(file.line_feeds, offset) - file.line_feeds.begin();
        return static_cast<std::uint32_t>(before) + 1;
    };
    const std::uint32_t first = line_of(span.begin);
    const std::uint32_t last = line_of(span.empty() ? span.end : span.end - 1);
    const auto range = std::ranges::lower_bound(file.ranges, first, {}, &LineRange::last);
    return range != file.ranges.end() && range->first <= last;
}

} // namespace maclint::cli
