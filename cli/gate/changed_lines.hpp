//! Lines that differ from a revision of a git repository.
#pragma once

#include "analyzer/source/source.hpp"
#include "cli/gate/line_difference.hpp"
#include "cli/gate/repository_history.hpp"
#include "cli/input/discover.hpp"
#include "cli/notice.hpp"

#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <variant>
#include <vector>

namespace maclint::cli {

/// What changed in the repositories of some files.
class ChangedLines {
  public:
    /// Asks git about the repositories that hold the files that were asked for. What is wrong ends the run.
    [[nodiscard]] static std::variant<ChangedLines, Notice> since(const std::string& revision,
                                                                  const std::vector<InputFile>& files);

    /// Compares the files that findings show with what they were. `checked` are all that take part when it is
    /// told which gone file a new one was. What went wrong, and what is worth telling.
    [[nodiscard]] std::vector<Notice> compare(const std::unordered_set<const Source*>& shown,
                                              const std::vector<const Source*>& checked);

    /// Whether a line of the place has changed, in a file that was compared. All of a file that its
    /// repository did not hold has, and all of standard input, for git only knows files. Nothing has in a
    /// program that others call from where git knows no such revision: in a library, a submodule, no
    /// repository at all.
    [[nodiscard]] bool touch(const Source& source, Span span) const;
    /// The same of all lines of a file together.
    [[nodiscard]] bool touch_any_line(const Source& source) const;

  private:
    /// What has changed in one file.
    struct File {
        std::vector<LineRange> ranges;
        std::vector<Offset> line_feeds; ///< of its text, where there are ranges
    };

    [[nodiscard]] const std::optional<std::string>& root_of(const std::string& path);
    [[nodiscard]] GitPlace place_of(const std::string& root) const;
    /// Nothing where git does not tell of the revision.
    [[nodiscard]] const RepositoryHistory* history_of(const std::string& root, std::vector<Notice>& notices);
    void keep(const Source& source, std::vector<LineRange> ranges);

    std::string revision_;
    std::unordered_map<std::string, std::optional<std::string>> roots_; ///< by folder
    std::map<std::string, std::optional<RepositoryHistory>> histories_; ///< by root
    std::unordered_set<std::string> standard_input_;                    ///< its name
    std::unordered_map<const Source*, File> files_;                     ///< of others all lines have changed
};

} // namespace maclint::cli
