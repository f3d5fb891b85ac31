//! Which codes contradict each other in one block.
#pragma once

#include "analyzer/program/tables.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace maclint::rules {

/// Codes of which a block may hold one.
struct ExclusiveKind {
    std::size_t row; ///< the same for all codes of the kind
    std::string_view name;
};

/// The kind of a code: the row of the control's table or, where it has none, the modal group of a G code.
[[nodiscard]] std::optional<ExclusiveKind> exclusive_kind(const ControlModel& control, char letter,
                                                          double code);

} // namespace maclint::rules
