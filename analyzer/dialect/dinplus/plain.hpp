//! What the plain scanner has to know of the dialect.
#pragma once

#include "analyzer/syntax/plain_tables.hpp"

#include <cstdint>

namespace maclint::dinplus {

/// What plain blocks of a section do: Program::plain_tables has a row for each.
namespace plain_sections {
constexpr std::uint8_t commands = 0, ///< codes are commands
    descriptions = 1;                ///< words do nothing: contours, lists for the operator
} // namespace plain_sections

[[nodiscard]] const syntax::PlainTables& plain_tables(std::uint8_t section);

} // namespace maclint::dinplus
