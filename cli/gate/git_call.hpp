//! How git is called: nothing that a repository's settings name is run, nothing is written, nothing fetched.
#pragma once

#include "analyzer/source/platform/process.hpp"
#include "cli/notice.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

/// A folder that holds a .git, absolute and without links.
struct GitPlace {
    std::string root;
    std::vector<std::string> checked_roots = {}; ///< others that are checked: no git of theirs is run, either
};

/// What git is asked there. Only words that read no index, no attributes and no working file may be asked:
/// these are what filters, hooks, fsmonitor and textconv hang on.
struct GitQuestion {
    GitPlace place;
    std::vector<std::string> words;
    std::string_view input = {};
};

[[nodiscard]] platform::ProcessEnd ask_git(const GitQuestion& question, const platform::TakeOutput& take);

/// The same for what is short.
struct GitAnswer {
    platform::ProcessEnd end;
    std::string text; ///< without the line's end behind it
};
[[nodiscard]] GitAnswer ask_git(const GitQuestion& question);

/// Lists the settings of a file, "key\nvalue" with a null behind each, and follows nothing that it names.
[[nodiscard]] GitAnswer list_settings(const GitPlace& place, const std::string& file);

/// --since cannot do its work.
[[nodiscard]] Notice refusal_of_since(const std::string& message);
/// What became of a call that did not succeed, in words for the user.
[[nodiscard]] Notice git_failed(const std::string& root, const platform::ProcessEnd& end);

} // namespace maclint::cli
