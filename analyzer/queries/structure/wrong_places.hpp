//! Numbers of blocks that words name in vain.
#pragma once

#include "analyzer/program/numbered_blocks.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>

namespace maclint::queries {

/// Looks in one file for the blocks that words name; each number once.
class WrongPlaces {
  public:
    using IsTarget = std::function<bool(const NumberedBlock&)>;
    /// The file must be indexed, and outlive it.
    WrongPlaces(const ProgramFile& file, IsTarget is_target);

    /// The section of a block that bears the number and is no target, empty where no block bears it. Nothing
    /// where a target does.
    [[nodiscard]] const std::optional<std::string>& of(std::int64_t number);

  private:
    const ProgramFile& file_;
    IsTarget is_target_;
    std::map<std::int64_t, std::optional<std::string>> known_;
};

} // namespace maclint::queries
