//! Sets of types of facts: what a rule asks for, what an analysis records.
#pragma once

#include <cstddef>
#include <cstdint>

namespace maclint::dataflow {

/// The place of a type of fact among all: each has one of its own, which its struct names as `place`. No list
/// of the types stands here, so that a new one makes nothing compile again but what asks for it.
struct FactPlace {
    static constexpr std::size_t most = 32; ///< there are no more
    std::size_t number;
};

/// A set of types of facts.
class FactSet {
  public:
    constexpr FactSet() = default;
    [[nodiscard]] static constexpr FactSet all() { return FactSet(~Bits{0}); }
    template<class... Types>
    [[nodiscard]] static constexpr FactSet of() {
        return FactSet((Bits{0} | ... | (Bits{1} << Types::place.number)));
    }

    template<class T>
    [[nodiscard]] constexpr bool has() const {
        return (bits_ >> T::place.number & 1U) != 0;
    }
    constexpr FactSet& operator|=(FactSet other) {
        bits_ |= other.bits_;
        return *this;
    }
    friend constexpr FactSet operator|(FactSet a, FactSet b) { return a |= b; }
    /// Those of `a` that `b` lacks.
    friend constexpr FactSet operator-(FactSet a, FactSet b) { return FactSet(a.bits_ & ~b.bits_); }
    friend constexpr bool operator==(FactSet, FactSet) = default;

  private:
    using Bits = std::uint32_t;
    constexpr explicit FactSet(Bits bits)
        : bits_(bits) {}
    Bits bits_ = 0;
};

/// The types of facts, whose headers a file includes that names them.
template<class... Types>
[[nodiscard]] constexpr FactSet facts() {
    return FactSet::of<Types...>();
}

} // namespace maclint::dataflow
