//! Choice points of a path on which a failure rests, by their number from its start.
#pragma once

#include "analyzer/dataflow/domain/small_vector.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace maclint::execution {

class ConflictSet {
  public:
    void add(std::size_t point) {
        while (words_.size() <= point / bits) words_.push_back(0);
        words_[point / bits] |= std::uint64_t{1} << point % bits;
    }
    void remove(std::size_t point) {
        if (point / bits < words_.size()) words_[point / bits] &= ~(std::uint64_t{1} << point % bits);
    }
    void add_all(const ConflictSet& more) {
        while (words_.size() < more.words_.size()) words_.push_back(0);
        for (std::size_t i = 0; i < more.words_.size(); ++i) words_[i] |= more.words_[i];
    }
    /// The one that is furthest from the start; nothing where the set is empty.
    [[nodiscard]] std::optional<std::size_t> last() const {
        for (std::size_t i = words_.size(); i-- > 0;)
            if (const std::uint64_t word = words_[i]; word != 0)
                return i * bits + static_cast<std::size_t>(std::bit_width(word) - 1);
        return std::nullopt;
    }

  private:
    static constexpr std::size_t bits = 64;
    dataflow::SmallVector<std::uint64_t, 2> words_;
};

} // namespace maclint::execution
