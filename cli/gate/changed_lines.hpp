//! Lines that differ from a revision of a git repository.
#pragma once

#include "analyzer/source/source.hpp"
#include "cli/input/discover.hpp"
#include "cli/notice.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <variant>
#include <vector>

namespace maclint::cli {

/// Lines of one file as git counts them, ends of lines in between: first and last, from 1.
struct LineRange {
    std::uint32_t first, last;

    friend bool operator==(const LineRange&, const LineRange&) = default;
};

/// Reads `git diff --unified=0` part by part: lines of the new files that were added or changed, and those on
/// both sides of what was taken out.
class DiffReader {
  public:
    void take(std::string_view part);
    /// By the files' names within the repository.
    [[nodiscard]] std::map<std::string, std::vector<LineRange>> finish();

  private:
    void take_line(std::string_view line);

    std::string begun_;               ///< line whose end is still to come; of long ones the beginning
    std::string name_;                ///< of the file that is being told of; empty: it is gone
    std::uint64_t content_lines_ = 0; ///< of the hunk that are still to come
    std::map<std::string, std::vector<LineRange>> ranges_;
};

/// What changed in the repositories of some files.
class ChangedLines {
  public:
    /// Asks git about the repositories that hold the files that were asked for. What is wrong ends the run.
    [[nodiscard]] static std::variant<ChangedLines, Notice> since(const std::string& revision,
                                                                  const std::vector<InputFile>& files);

    /// Whether a line of the place has changed. All of a file that its repository does not hold yet has, and
    /// all of standard input, for git only sees files. Nothing has in a program that others call from where
    /// git knows no such revision: in a library, a submodule, no repository at all.
    [[nodiscard]] bool touch(const Source& source, Span span);

  private:
    /// What has changed in one file.
    struct File {
        bool all = false;
        std::vector<LineRange> ranges = {};
        std::vector<Offset> line_feeds = {}; ///< of its text, where there are ranges
    };
    [[nodiscard]] File look_up(const Source& source);
    /// Whether git knows the revision in the repository.
    [[nodiscard]] bool knows(const std::string& root);
    /// What is wrong, or nothing.
    [[nodiscard]] std::optional<Notice> ask(const std::string& root);

    std::string revision_;
    std::unordered_map<std::string, bool> known_; ///< repositories that were asked, and whether they knew it
    std::map<std::string, std::vector<LineRange>> ranges_; ///< by canonical path, in the order of lines
    std::unordered_set<std::string> tracked_;              ///< canonical paths
    std::unordered_set<std::string> standard_input_;       ///< its name
    std::unordered_map<const Source*, File> files_;
};

} // namespace maclint::cli
