//! Names for the places of a program's parts, and of rows in the tables of its control.
#pragma once

#include <cstddef>
#include <cstdint>

namespace maclint {

using Id = std::uint32_t; ///< index into one of a program's arenas
using ExpressionId = Id;
using EffectId = Id;

using SpaceId = std::uint8_t;         ///< row of ControlModel::spaces
using GroupId = std::uint8_t;         ///< row of ControlModel::groups
using FamilyId = std::uint8_t;        ///< row of ControlModel::families
using CallKindId = std::uint8_t;      ///< row of ControlModel::calls
using ReferenceKindId = std::uint8_t; ///< row of ControlModel::references

/// The analysis keeps a table with an entry for each space of a control: no control has more.
inline constexpr std::size_t most_spaces = 16;

} // namespace maclint
