//! What git passes over in folders of a repository, as gitignore(5) has it.
#pragma once

#include "analyzer/source/source.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
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
    /// Files that could not be read, or are too large.
    [[nodiscard]] const std::vector<InputError>& unread() const { return unread_; }

  private:
    /// A folder with rules of its own, and the next one above it in the repository.
    struct Rules {
        std::shared_ptr<const Rules> above;
        std::string folder;
        std::vector<IgnoreRule> rules;
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
