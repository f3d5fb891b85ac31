//! Programs of several files that have one number on one control.
#pragma once

#include "analyzer/workspace/outline.hpp"
#include "cli/engine/snapshot.hpp"
#include "rules/finding.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace maclint::cli {

/// A folder is the memory of one control where the configuration says so, or where a number or two stand
/// twice among files that bear their numbers as names. In any other, files of one number are versions, copies
/// or programs of several machines.
class SameNumbers {
  public:
    SameNumbers() = default;
    /// One outline a file, in the same order.
    SameNumbers(const Snapshot& snapshot, std::span<const FileOutline> outlines);

    /// Those of the file at the place in the snapshot.
    [[nodiscard]] std::vector<Finding> findings_in(std::size_t place, const ProgramFile& file) const;

  private:
    struct Taken {
        std::int64_t number;
        std::string by; ///< name of the file that has the number, too
    };
    std::map<std::size_t, std::vector<Taken>> taken_; ///< by place of the file
};

} // namespace maclint::cli
