//! Tells line noise from a program with mistakes.
#pragma once

#include <algorithm>

namespace maclint {

/// Whether the reader is inside line noise: nearly every block has an error, dozens in a row. There only
/// blocks without an evident cause of an error are parsed. Some good blocks, and it is quiet again.
class ErrorThrottle {
  public:
    [[nodiscard]] bool is_throttling() const { return level_ >= throttling; }
    void record(bool error) {
        if (error)
            level_ = std::min(level_ + 1, highest);
        else
            level_ -= std::min(level_, good_block);
    }

  private:
    static constexpr unsigned throttling = 32;
    static constexpr unsigned highest = 40;
    static constexpr unsigned good_block = 4; ///< up to four errors for one good block stay quiet
    unsigned level_ = 0;
};

} // namespace maclint
