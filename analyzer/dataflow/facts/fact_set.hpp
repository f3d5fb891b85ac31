//! Which types of facts there are, and sets of them: what a rule asks for, what an analysis records.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace maclint::dataflow {

struct Application;
struct BeforeToolChange;
struct BeforeWatchedWord;
struct CallMade;
struct Clobber;
struct Comparison;
struct ComputedJump;
struct Condition;
struct ExitState;
struct ModalRead;
struct ModalWrite;
struct Read;
struct Store;

/// Every type of fact, as arguments of `Of`: what stands here can be recorded and asked for.
template<template<class...> class Of>
using OfEveryFact = Of<Application, Comparison, Condition, Read, ModalRead, Store, Clobber, CallMade,
                       ModalWrite, ComputedJump, BeforeToolChange, BeforeWatchedWord, ExitState>;

template<class... Types>
struct FactTypes {
    static constexpr std::size_t count = sizeof...(Types);
    /// The place of T among the types.
    template<class T>
    [[nodiscard]] static constexpr std::size_t index() {
        static_assert((std::is_same_v<T, Types> || ...), "T stands in OfEveryFact");
        std::size_t index = 0;
        (void)((std::is_same_v<T, Types> || (++index, false)) || ...);
        return index;
    }
};
using EveryFact = OfEveryFact<FactTypes>;

/// A set of types of facts.
class FactSet {
  public:
    constexpr FactSet() = default;
    [[nodiscard]] static constexpr FactSet all() { return FactSet((Bits{1} << EveryFact::count) - 1); }
    template<class... Types>
    [[nodiscard]] static constexpr FactSet of() {
        return FactSet((Bits{0} | ... | (Bits{1} << EveryFact::index<Types>())));
    }

    template<class T>
    [[nodiscard]] constexpr bool has() const {
        return (bits_ >> EveryFact::index<T>() & 1U) != 0;
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

template<class... Types>
[[nodiscard]] constexpr FactSet facts() {
    return FactSet::of<Types...>();
}

} // namespace maclint::dataflow
