//! Words and arrays that a text defines; files of definitions give theirs to all programs.
#pragma once

#include "analyzer/program/ids.hpp"
#include "analyzer/source/span.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maclint {

/// A name that stands for a piece of a block, and what a block does in which it stands alone.
struct GivenWord {
    std::string name; ///< capitals
    bool is_known;    ///< that it does what follows, and nothing else
    std::vector<std::pair<GroupId, double>> sets = {};
    bool moves = false;        ///< to wherever
    bool changes_tool = false; ///< or prepares one

    /// It only switches something of the machine.
    [[nodiscard]] bool only_switches() const { return is_known && sets.empty() && !moves && !changes_tool; }
    friend bool operator==(const GivenWord&, const GivenWord&) = default;
};

/// A variable with its dimensions, if it has any.
struct ArrayDefinition {
    std::string name;      ///< capitals
    std::string_view type; ///< "REAL", of static lifetime
    /// Of each dimension; nothing: calculated, or as passed. None at all: a single variable.
    std::vector<std::optional<std::int32_t>> sizes;
    friend bool operator==(const ArrayDefinition&, const ArrayDefinition&) = default;
};

} // namespace maclint
