//! Chance that is the same everywhere: one engine, no standard distribution; or bytes that somebody chose.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <span>

namespace maclint::test {

class Dice {
  public:
    explicit Dice(unsigned seed)
        : engine_{seed} {}
    /// Throws what the bytes say while there are any, two bytes where one is not enough.
    explicit Dice(std::span<const std::uint8_t> bytes)
        : engine_{0}
        , bytes_(bytes) {}
    std::size_t below(std::size_t limit) {
        const std::size_t wanted = limit > 256 ? 2 : 1;
        if (bytes_.size() < wanted) return static_cast<std::size_t>(engine_()) % limit;
        std::size_t number = 0;
        for (const std::uint8_t byte : bytes_.first(wanted)) number = number << 8U | byte;
        bytes_ = bytes_.subspan(wanted);
        return number % limit;
    }
    int between(int low, int high) {
        const int values = high - low + 1;
        return low + static_cast<int>(below(static_cast<std::size_t>(values)));
    }
    /// One time in so many.
    bool one_in(std::size_t times) { return below(times) == 0; }
    template<class List>
    auto one_of(const List& list) {
        return list[below(list.size())];
    }

  private:
    std::mt19937 engine_;
    std::span<const std::uint8_t> bytes_;
};

} // namespace maclint::test
