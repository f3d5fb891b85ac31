//! Numbers for things of which many are equal.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace maclint::dataflow {

/// The finaliser of splitmix64: cheap, and every bit of the input reaches every bit of the result.
constexpr std::uint64_t mix(std::uint64_t hash, std::uint64_t value) {
    value += 0x9E3779B97F4A7C15ULL + hash;
    value = (value ^ (value >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    value = (value ^ (value >> 27U)) * 0x94D049BB133111EBULL;
    return value ^ (value >> 31U);
}
constexpr std::uint64_t side_by_side(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t{a} << 32U) | b;
}

/// Stores equal things once and names them by number. Open addressing: most programs are small, and every one
/// has several.
///
/// hash_local(thing) is a slot near others that are asked for at the same time, which keeps long programs in
/// the processor's caches; hash_mixed(thing) is one far from them, for where too many things want the same
/// slot.
template<class T>
class Interner {
  public:
    /// The number of the thing, which may be one of those that are stored.
    std::uint32_t operator()(const T& thing) {
        if (2 * things_.size() >= slots_.size()) grow();
        std::uint32_t& slot = slots_[slot_of(thing)];
        if (slot == 0) {
            things_.push_back(thing);
            slot = static_cast<std::uint32_t>(things_.size());
        }
        return slot - 1;
    }
    [[nodiscard]] const T& operator[](std::uint32_t id) const { return things_[id]; }
    /// Gives back all memory that serves to add things.
    void fit() {
        things_.shrink_to_fit();
        slots_ = std::vector<std::uint32_t>(); // braces alone would keep the memory
    }

  private:
    /// How many slots near the thing's first place are looked at before the search goes on far from it.
    static constexpr int most_near = 8;

    /// The slot that holds the thing, or the free one where it belongs.
    [[nodiscard]] std::size_t slot_of(const T& thing) const {
        const std::size_t mask = slots_.size() - 1;
        std::size_t slot = hash_local(thing) & mask;
        for (int i = 0; i < most_near; ++i) {
            if (is_slot_of(thing, slot)) return slot;
            slot = (slot + 1) & mask;
        }
        // Steps of its own size take it past the rows that things side by side have filled.
        const std::uint64_t far = hash_mixed(thing);
        const std::size_t step = (far >> 32U) | 1U;
        slot = far & mask;
        while (!is_slot_of(thing, slot)) slot = (slot + step) & mask;
        return slot;
    }
    [[nodiscard]] bool is_slot_of(const T& thing, std::size_t slot) const {
        return slots_[slot] == 0 || things_[slots_[slot] - 1] == thing;
    }

    void grow() {
        constexpr std::size_t fewest = 64;
        slots_.assign(std::max(fewest, std::bit_ceil(4 * things_.size())), 0);
        for (std::size_t i = 0; i < things_.size(); ++i)
            slots_[slot_of(things_[i])] = static_cast<std::uint32_t>(i + 1);
    }

    std::vector<T> things_;
    std::vector<std::uint32_t> slots_; ///< 0: free; otherwise one more than the thing's number
};

} // namespace maclint::dataflow
