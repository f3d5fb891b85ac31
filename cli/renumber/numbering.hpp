//! How blocks are to be numbered.
#pragma once

#include <cstdint>

namespace maclint::cli {

/// Of the first block, and from one to the next; both 1 at least.
struct Numbering {
    std::int64_t start = 10, step = 10;
};

} // namespace maclint::cli
