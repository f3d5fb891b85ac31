//! The rows of each dialect.
#pragma once

#include "analyzer/dialect/spacing.hpp"

namespace maclint {

/// What rows say, in short.
namespace spacing_words {
using enum SpacingRow::Parts;
inline constexpr auto apart = SpacingRow::Beside::apart;
inline constexpr auto touches = SpacingRow::Beside::touches;
} // namespace spacing_words

namespace fanuc {
extern const SpacingTable spacing;
}
namespace dinplus {
extern const SpacingTable spacing;
}
namespace sinumerik {
extern const SpacingTable spacing;
}

} // namespace maclint
