//! Five questions: where the working tree lies, which commit is meant, what it holds, how large texts are,
//! and the texts.
#include "cli/gate/repository_history.hpp"

#include "analyzer/source/platform/files.hpp"
#include "analyzer/source/platform/paths.hpp"
#include "cli/gate/git_refusals.hpp"
#include "cli/text/shown.hpp"

#include <algorithm>
#include <charconv>
#include <span>
#include <utility>

namespace maclint::cli {
namespace {

using platform::EndedBy;
using Why = HistoryRefusal::Why;

/// Some three million files. A few trees that hold each other can have more than any disk.
constexpr std::size_t longest_listing = std::size_t{1} << 28U;

std::optional<Notice> refuse_repository(const GitPlace& place) {
    const std::string& root = place.root;
    if (platform::paths_may_name_servers())
        if (auto refused = refuse_other_servers(place)) return refused;
    if (auto refused = refuse_special_files(root)) return refused;
    const GitAnswer top = ask_git({place, {"rev-parse", "--show-toplevel"}});
    if (!top.end.succeeded()) return git_failed(root, top.end);
    if (platform::are_same_file(platform::path_of(top.text), platform::path_of(root))) return std::nullopt;
    return refusal_of_since("--since cannot compare '" + shown(root) + "': by its .git its files lie in '" +
                            shown(top.text) + "'. Take 'core.worktree' out there, or leave --since out.");
}

/// "^HEAD" and ranges give more than one.
bool is_id(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::variant<std::string, HistoryRefusal> commit_of(const GitPlace& place, const std::string& revision) {
    // Behind ":/" all is text that a commit's message holds, and what is found is a commit.
    const std::string named = revision.starts_with(":/") ? revision : revision + "^{commit}";
    GitAnswer answer = ask_git({place, {"rev-parse", "--verify", "--quiet", named}});
    if (answer.end.succeeded() && is_id(answer.text)) return std::move(answer.text);
    if (answer.end.by != EndedBy::itself)
        return HistoryRefusal{Why::unusable, git_failed(place.root, answer.end)};
    if (answer.end.errors.empty() && answer.text.empty())
        return HistoryRefusal{Why::revision_unknown,
                              refusal_of_since("--since names no revision that git knows in '" +
                                               shown(place.root) + "': '" + shown(revision) +
                                               "'. Write a commit, a branch or a tag; where only a part of "
                                               "the history was fetched, fetch the rest.")};
    // Git has answered before about this repository: it is the revision that is not right.
    const std::string words = answer.end.errors.substr(0, answer.end.errors.find('\n'));
    return HistoryRefusal{Why::unusable,
                          refusal_of_since("--since names no commit in '" + shown(place.root) + "': '" +
                                           shown(revision) + "'" +
                                           (words.empty() ? "" : ", git says '" + shown(words) + "'") +
                                           ". Write a commit, a branch or a tag.")};
}

/// Reads what `git cat-file` writes for each id: "ID KIND SIZE" or "ID missing" on a line, then perhaps the
/// text and a line feed.
class BatchReader {
  public:
    enum class Holds : std::uint8_t { sizes, texts };
    /// Size and text of a blob; no size when the repository lacks it.
    using Take = std::function<void(std::size_t index, std::optional<std::uint64_t> size, std::string text)>;

    BatchReader(Holds holds, const Take& take)
        : holds_(holds)
        , take_(take) {}

    /// False: it is not what git writes.
    bool take(std::string_view part) {
        while (!part.empty() && is_well_) {
            if (text_left_) {
                take_text(part);
            } else {
                take_header(part);
            }
        }
        return is_well_;
    }
    [[nodiscard]] std::size_t count() const { return count_; }

  private:
    void take_text(std::string_view& part) {
        const std::string_view piece = part.substr(0, *text_left_);
        text_ += piece;
        *text_left_ -= piece.size();
        part.remove_prefix(piece.size());
        if (*text_left_ > 0) return;
        text_left_.reset();
        text_.pop_back(); // the line feed behind it
        const auto size = text_.size();
        take_(count_++, size, std::exchange(text_, {}));
    }

    void take_header(std::string_view& part) {
        constexpr std::size_t longest = 4096;
        const std::string_view piece = part.substr(0, part.find('\n'));
        header_ += piece;
        is_well_ = header_.size() <= longest;
        part.remove_prefix(piece.size());
        if (part.empty()) return;
        part.remove_prefix(1);
        const std::string header = std::exchange(header_, {});
        if (header.ends_with(" missing")) return take_(count_++, std::nullopt, {});
        const auto kind = header.find(" blob ");
        std::uint64_t size = 0;
        is_well_ = kind != std::string::npos &&
                   std::from_chars(header.data() + kind + 6, header.data() + header.size(), size).ec ==
                       std::errc{} &&
                   (holds_ == Holds::sizes || size <= RepositoryHistory::largest_text);
        if (!is_well_) return;
        if (holds_ == Holds::sizes) return take_(count_++, size, {});
        text_left_ = size + 1;
        text_.reserve(size + 1);
    }

    Holds holds_;
    const Take& take_;
    std::string header_, text_;
    std::optional<std::uint64_t> text_left_; ///< bytes to come, in the middle of a text
    std::size_t count_ = 0;
    bool is_well_ = true;
};

/// Whether git ended because a partial clone lacks what it was asked for. Newer ones than 2.39 say that it is
/// missing, and go on.
bool ended_for_lack(const platform::ProcessEnd& end) {
    return end.by == EndedBy::itself && end.status != 0 &&
           end.errors.find("from promisor remote") != std::string::npos;
}

std::optional<Notice> ask_for_texts(const GitPlace& place, std::span<const std::string_view> ids,
                                    BatchReader::Holds holds, const BatchReader::Take& take) {
    constexpr int most_calls = 100; // a few seconds
    const char* const how = holds == BatchReader::Holds::sizes ? "--batch-check" : "--batch";
    std::size_t done = 0;
    for (int calls = 0; done < ids.size() && calls < most_calls; ++calls) {
        std::string input;
        for (const std::string_view id : ids.subspan(done)) input.append(id).push_back('\n');
        const BatchReader::Take take_of_all = [&](std::size_t index, std::optional<std::uint64_t> size,
                                                  std::string text) {
            take(done + index, size, std::move(text));
        };
        BatchReader reader(holds, take_of_all);
        const auto end = ask_git({place, {"cat-file", how}, input},
                                 [&](std::string_view part) { return reader.take(part); });
        const std::size_t asked = ids.size() - done;
        if (end.succeeded() && reader.count() == asked) return std::nullopt;
        if (!ended_for_lack(end) || reader.count() >= asked) return git_failed(place.root, end);
        done += reader.count();
        take(done++, std::nullopt, {});
    }
    for (; done < ids.size(); ++done) take(done, std::nullopt, {});
    return std::nullopt;
}

} // namespace

std::variant<RepositoryHistory, HistoryRefusal> RepositoryHistory::open(const GitPlace& place,
                                                                        const std::string& revision) {
    const std::string& root = place.root;
    if (auto refused = refuse_repository(place)) return HistoryRefusal{Why::unusable, *std::move(refused)};
    auto commit = commit_of(place, revision);
    if (auto* const refused = std::get_if<HistoryRefusal>(&commit)) return std::move(*refused);
    RepositoryHistory history;
    history.place_ = place;
    const auto end = ask_git({place, {"ls-tree", "-r", "-z", "--full-tree", std::get<std::string>(commit)}},
                             [&](std::string_view part) {
                                 history.listing_ += part;
                                 return history.listing_.size() <= longest_listing;
                             });
    if (end.by == EndedBy::taker)
        return HistoryRefusal{Why::unusable,
                              refusal_of_since("--since cannot compare '" + shown(root) + "': '" +
                                               shown(revision) +
                                               "' has more files than it can hold. Leave --since out.")};
    if (!end.succeeded()) return HistoryRefusal{Why::unusable, git_failed(root, end)};
    history.read_listing();
    return history;
}

/// "100644 blob ID\tPATH", with a null behind each. Links are 120000, submodules 160000 commits.
void RepositoryHistory::read_listing() {
    constexpr std::string_view file = "100";
    const std::string_view all = listing_;
    for (std::size_t begin = 0; begin < all.size();) {
        const std::size_t end = std::min(all.find('\0', begin), all.size());
        const std::string_view row = all.substr(begin, end - begin);
        const auto tab = row.find('\t');
        const auto id = row.substr(0, tab).rfind(' ') + 1;
        if (row.starts_with(file) && tab != std::string_view::npos) {
            id_size_ = static_cast<std::uint32_t>(tab - id);
            entries_.push_back({static_cast<std::uint32_t>(begin + id),
                                static_cast<std::uint32_t>(begin + tab + 1),
                                static_cast<std::uint32_t>(row.size() - tab - 1)});
        }
        begin = end + 1;
    }
    std::ranges::stable_sort(entries_, {}, [this](const Entry& entry) { return path_of(entry); });
}

std::string_view RepositoryHistory::path_of(const Entry& entry) const {
    return std::string_view(listing_).substr(entry.path, entry.path_size);
}

std::string_view RepositoryHistory::id_of(const Entry& entry) const {
    return std::string_view(listing_).substr(entry.id, id_size_);
}

std::vector<RepositoryHistory::File> RepositoryHistory::files() const {
    std::vector<File> files;
    files.reserve(entries_.size());
    for (const Entry& entry : entries_) files.push_back({path_of(entry), id_of(entry)});
    return files;
}

std::optional<std::string_view> RepositoryHistory::id_of(std::string_view path) const {
    const auto found =
        std::ranges::lower_bound(entries_, path, {}, [this](const Entry& entry) { return path_of(entry); });
    if (found == entries_.end() || path_of(*found) != path) return std::nullopt;
    return id_of(*found);
}

std::variant<std::vector<std::optional<std::uint64_t>>, Notice>
RepositoryHistory::sizes_of(const std::vector<std::string_view>& ids) const {
    std::vector<std::optional<std::uint64_t>> sizes(ids.size());
    auto failure =
        ask_for_texts(place_, ids, BatchReader::Holds::sizes,
                      [&](std::size_t index, std::optional<std::uint64_t> size, const std::string&) {
                          if (index < sizes.size()) sizes[index] = size;
                      });
    if (failure) return *std::move(failure);
    return sizes;
}

std::optional<Notice> RepositoryHistory::read(const std::vector<std::string_view>& ids,
                                              const TakeText& take) const {
    return ask_for_texts(place_, ids, BatchReader::Holds::texts,
                         [&](std::size_t index, std::optional<std::uint64_t> size, std::string text) {
                             if (size && index < ids.size()) take(index, std::move(text));
                         });
}

} // namespace maclint::cli
