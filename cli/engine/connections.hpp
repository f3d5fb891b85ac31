//! What the files of a snapshot are to each other: all that one edit of a block leaves as it is.
#pragma once

#include "analyzer/workspace/outline.hpp"
#include "cli/engine/computed_calls.hpp"
#include "cli/engine/definitions.hpp"
#include "cli/engine/own_macros.hpp"
#include "cli/engine/same_numbers.hpp"
#include "cli/engine/snapshot.hpp"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace maclint::cli {

using Group = std::vector<std::size_t>; ///< places in the snapshot

class Connections {
  public:
    /// One outline a file, in the same order.
    Connections(const Snapshot& snapshot, std::vector<FileOutline> outlines);

    /// Whether they would be the same for these. `outlines` as above.
    [[nodiscard]] bool hold_for(const Snapshot& snapshot, const std::vector<FileOutline>& outlines) const;

    /// Files joined by calls, the largest group first.
    [[nodiscard]] const std::vector<Group>& groups() const { return groups_; }
    [[nodiscard]] const ComputedCalls& computed_calls() const { return computed_calls_; }
    [[nodiscard]] const SameNumbers& same_numbers() const { return same_numbers_; }
    [[nodiscard]] const OwnMacros& own_macros() const { return own_macros_; }
    [[nodiscard]] const Definitions& definitions() const { return definitions_; }
    /// The G code system of the lathes that a file is for as its callers tell; 0: they do not.
    [[nodiscard]] char lathe_of_callers(std::size_t place) const { return lathes_of_callers_[place]; }

  private:
    /// What is asked of a file beside its outline.
    struct FileFacts {
        explicit FileFacts(const SnapshotFile& file);
        friend bool operator==(const FileFacts&, const FileFacts&) = default;

        std::string path;
        bool standard_input, complete;
        std::shared_ptr<const Configuration> configuration;
    };

    std::vector<FileFacts> files_;
    std::vector<FileOutline> outlines_; ///< by which the others are known
    std::vector<Group> groups_;
    ComputedCalls computed_calls_;
    SameNumbers same_numbers_;
    OwnMacros own_macros_;
    Definitions definitions_;
    std::vector<char> lathes_of_callers_;
};

} // namespace maclint::cli
