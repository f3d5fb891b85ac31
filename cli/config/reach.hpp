//! Which files a configuration may name: one that came with a folder stays in that folder's tree, so that
//! nothing outside is read because a stranger asks for it.
#pragma once

#include "analyzer/source/platform/files.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace maclint::cli {

class Reach {
  public:
    /// Of a configuration that the command line names: whoever writes that knows what he asks for.
    [[nodiscard]] static Reach of_command_line() { return {}; }
    /// Of one that was found in a folder: the repository around it; where there is none, the folder with all
    /// below it, those of the user's `own` folders (after all links) that hold it, and single files of the
    /// folders above it.
    [[nodiscard]] static Reach of_folder(const std::filesystem::path& folder,
                                         const std::vector<std::filesystem::path>& own = {});

    [[nodiscard]] bool is_bounded() const { return folder_.has_value(); }

    /// Whether messages may quote a file that is within reach. Not one of a folder above, which may be
    /// anything and is only there by chance.
    [[nodiscard]] bool may_quote(const std::filesystem::path& file) const;

    /// What is said of a file that must not be opened, "lies outside of this repository", or nothing.
    /// `written` is how it is named, `file` where that is from the working folder.
    [[nodiscard]] std::optional<std::string> objection(std::string_view written,
                                                       const std::filesystem::path& file) const;

  private:
    Reach() = default;
    /// Whether a file lies in the trees that belong to the configuration, as opposed to above them.
    [[nodiscard]] bool has_in_its_trees(const std::filesystem::path& real) const;
    [[nodiscard]] bool holds(const std::filesystem::path& real) const;

    std::optional<std::filesystem::path> folder_; ///< after all links; nothing: no bounds
    std::optional<std::filesystem::path> repository_;
    std::vector<std::filesystem::path> own_; ///< without a repository: that hold the folder
};

/// The folders whose trees are the user's own: those that were named, and the one that maclint was started
/// in, unless that is the home folder or one above it, where strangers' files lie beside everything else.
/// After all links; never a whole disk.
[[nodiscard]] std::vector<std::filesystem::path> own_folders(const std::vector<std::string>& named);

/// Whether a file belongs neither to who runs maclint nor to root, whom everybody has to trust.
[[nodiscard]] bool is_of_stranger(const platform::Ownership& ownership);

} // namespace maclint::cli
