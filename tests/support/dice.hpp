//! Chance that is the same everywhere: one engine, no standard distribution.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace maclint::test {

class Dice {
  public:
    explicit Dice(unsigned seed)
        : engine_{seed} {}
    std::size_t below(std::size_t limit) { return static_cast<std::size_t>(engine_()) % limit; }
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
};

} // namespace maclint::test
