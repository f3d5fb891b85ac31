//! At which block a called program begins.
#pragma once

#include "analyzer/program/model.hpp"

#include <cstdint>
#include <optional>

namespace maclint::queries {

/// The number that a subprogram call names: 50 for `M98 P1002 Q50`. Nothing where the program begins at its
/// first block, and for macro calls, to which Q is an argument.
[[nodiscard]] std::optional<std::int64_t> first_block_called(const Program& program, const Effect& call);

/// Whether a block of the program has the number.
[[nodiscard]] bool has_block(const Program& program, std::int64_t number);

} // namespace maclint::queries
