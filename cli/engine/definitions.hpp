//! What files of definitions give to all programs of their language.
#pragma once

#include "analyzer/workspace/names_elsewhere.hpp"
#include "analyzer/workspace/outline.hpp"
#include "cli/engine/folders.hpp"
#include "cli/engine/snapshot.hpp"

#include <map>
#include <memory>
#include <span>
#include <string_view>

namespace maclint::cli {

class Definitions {
  public:
    Definitions() = default;
    /// One outline a file, in the same order.
    Definitions(const Snapshot& snapshot, std::span<const FileOutline> outlines);

    /// Of the names of the language that a file's programs may use without defining them, those that are
    /// known. They are all where the configuration says so, or where files of definitions lie by the file.
    [[nodiscard]] NamesElsewhere names_for(const SnapshotFile& file, std::string_view language) const;

  private:
    struct Given {
        std::shared_ptr<TextSet> names = std::make_shared<TextSet>();
        std::shared_ptr<GivenByName<GivenWord>> words = std::make_shared<GivenByName<GivenWord>>();
        std::shared_ptr<GivenByName<ArrayDefinition>> arrays =
            std::make_shared<GivenByName<ArrayDefinition>>();
    };
    std::map<std::string_view, Given> given_; ///< by language
    Folders folders_;                         ///< with such files
};

} // namespace maclint::cli
