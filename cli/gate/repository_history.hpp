//! The files of a git repository as they were at one revision.
#pragma once

#include "cli/gate/git_call.hpp"
#include "cli/notice.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace maclint::cli {

/// Why a repository does not tell of a revision.
struct HistoryRefusal {
    enum class Why : std::uint8_t {
        revision_unknown, ///< git knows the repository, and no such revision in it
        unusable,         ///< git does not take it for a repository, or may not be asked about it
    };
    Why why;
    Notice notice;
};

class RepositoryHistory {
  public:
    [[nodiscard]] static std::variant<RepositoryHistory, HistoryRefusal> open(const GitPlace& place,
                                                                              const std::string& revision);

    struct File {
        std::string_view path; ///< from the root, with '/'
        std::string_view id;   ///< of its text, as git names it
    };
    /// Sorted by path; no links, and nothing of submodules. The texts live as long as this.
    [[nodiscard]] std::vector<File> files() const;
    /// The id of a file's text, or nothing when there was none.
    [[nodiscard]] std::optional<std::string_view> id_of(std::string_view path) const;

    /// The bytes of each text, or nothing for one that the repository lacks.
    [[nodiscard]] std::variant<std::vector<std::optional<std::uint64_t>>, Notice>
    sizes_of(const std::vector<std::string_view>& ids) const;

    /// Bytes; larger ones are not read.
    static constexpr std::uint64_t largest_text = std::uint64_t{1} << 30U;

    /// Gives the texts one by one in the order of their ids, with the place of each among these. What is
    /// wrong, or nothing.
    using TakeText = std::function<void(std::size_t index, std::string text)>;
    [[nodiscard]] std::optional<Notice> read(const std::vector<std::string_view>& ids,
                                             const TakeText& take) const;

    [[nodiscard]] const std::string& root() const { return place_.root; }

  private:
    struct Entry {
        std::uint32_t id, path, path_size; ///< where they begin in the listing
    };
    void read_listing();
    [[nodiscard]] std::string_view path_of(const Entry& entry) const;
    [[nodiscard]] std::string_view id_of(const Entry& entry) const;

    GitPlace place_;
    std::string listing_;        ///< as `git ls-tree -r -z` writes it
    std::vector<Entry> entries_; ///< sorted by path
    std::uint32_t id_size_ = 0;
};

} // namespace maclint::cli
