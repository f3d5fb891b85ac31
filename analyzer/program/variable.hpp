//! A variable of a program, and what it can hold.
#pragma once

#include "analyzer/program/ids.hpp"

#include <cstdint>

namespace maclint {

/// What a variable can hold. What is stored in an integer is rounded, in a truth it becomes 0 or 1.
enum class VariableType : std::uint8_t { number, integer, text, truth };

/// One variable: a space and a number (for named variables the index of the name in its program).
struct Variable {
    SpaceId space;
    std::int32_t number;
    friend bool operator==(const Variable&, const Variable&) = default;
};

} // namespace maclint
