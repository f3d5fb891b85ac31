//! The rows of each dialect.
#pragma once

#include "analyzer/dialect/spacing.hpp"

namespace maclint {

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
