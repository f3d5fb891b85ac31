//! What git passes over in folders of a repository, as gitignore(5) has it.
#pragma once

#include "analyzer/source/source.hpp"

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace maclint::cli {

/// A line of a .gitignore that says something.
struct IgnoreRule {
    std::vector<std::string> names; ///< a glob for each name of a path; one alone is for names at any depth
    bool anchored = false;          ///< the names begin at the file's folder
    bool folders_only = false;
    bool wanted = false; ///< "!": what earlier lines pass over is wanted after all
};

/// The rules of a .gitignore or info/exclude, in the order of its lines.
[[nodiscard]] std::vector<IgnoreRule> read_ignore_rules(std::string_view text);

/// The rules of one file, those without wildcards found by what they name.
class IndexedRules {
  public:
    explicit IndexedRules(std::vector<IgnoreRule> rules);

    /// Whether the last rule that matches passes over the path, whose names begin at the file's folder.
    [[nodiscard]] std::optional<bool> pass_over(const std::vector<std::string_view>& names,
                                                bool is_folder) const;
    [[nodiscard]] std::size_t wildcards() const { return with_wildcards_.size(); }

  private:
    /// How many rules stand up to the last one of a name; 0: there is none.
    struct Last {
        std::size_t of_all = 0, of_folders = 0;
    };
    using ByText = std::unordered_map<std::string, Last>;

    static std::size_t last_of(const ByText& rules, const std::string& text, bool is_folder);

    std::vector<IgnoreRule> rules_;
    std::vector<std::size_t> with_wildcards_; ///< places in `rules_`, in their order
    ByText by_name_, by_path_;                ///< anchored ones by their path
};

/// Finds the .gitignore files that hold in a folder, and the repository's info/exclude, and remembers them.
/// The ignore file of a user, which git reads too, is not read: what is checked must not depend on it.
class GitIgnore {
  public:
    /// Whether git passes an entry of the folder over. The folder is absolute, without
    /// links, with '/'.
    [[nodiscard]] bool ignores(const std::string& folder, const std::string& name, bool is_folder);
    /// The folder was asked for: if git passes it over, then for what is in it only its own rules count.
    void ask_for(const std::string& folder);
    /// Whether git passes over a file or folder, or a folder above it.
    [[nodiscard]] bool ignores_path(const std::string& path, bool is_folder);
    /// Files that could not be read, are too large, or hold too many wildcards: nothing is passed over by
    /// them, nor by those above them, of which they may take something back.
    [[nodiscard]] const std::vector<InputError>& unread() const { return unread_; }

  private:
    /// A folder with rules of its own, and the next one above it in the repository.
    struct Rules {
        std::shared_ptr<const Rules> above;
        std::string folder;
        IndexedRules rules;
        std::size_t wildcards; ///< of these rules and of all above
    };
    using Chain = std::shared_ptr<const Rules>;
    struct Known {
        Chain rules;
        bool in_repository = false;
    };

    const Known& known_of(const std::string& folder);
    Chain with_file(Chain above, const std::string& folder, const std::filesystem::path& file);

    std::map<std::string, Known, std::less<>> by_folder_;
    std::vector<InputError> unread_;
};

} // namespace maclint::cli
