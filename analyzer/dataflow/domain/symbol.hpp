//! Computations as value numbers: equal numbers at one point of a program are equal values.
#pragma once

#include "analyzer/dataflow/domain/interner.hpp"
#include "analyzer/program/model.hpp"

#include <bit>
#include <cassert>
#include <cstdint>
#include <optional>

namespace maclint::dataflow {

using SymbolId = std::uint32_t; ///< equal symbols at one point of the program are equal values

/// A computation, as a value number.
class Symbol {
  public:
    enum class Kind : std::uint8_t {
        constant, ///< a number
        vacant,
        entry,       ///< the value of a variable at the program's start
        entry_group, ///< the code in force when the program was called
        opaque,      ///< nothing more is known than what made it
        machine,     ///< a machine's variable since two nodes; on one path only
        joined,      ///< a variable where paths with different values meet
        result,      ///< of an operation, of one operand or two
        skip_switch, ///< of a level; on one path only
        if_set,      ///< a word's value, or what was in force before where that is vacant
    };

    [[nodiscard]] static constexpr Symbol of_number(double number) {
        return {Kind::constant, std::bit_cast<std::uint64_t>(number)};
    }
    [[nodiscard]] static constexpr Symbol of_vacancy() { return Symbol(Kind::vacant); }
    [[nodiscard]] static constexpr Symbol at_entry(std::uint64_t key) { return {Kind::entry, key}; }
    [[nodiscard]] static constexpr Symbol group_at_entry(std::uint64_t group) {
        return {Kind::entry_group, group};
    }
    /// An expression's value at a node of which nothing more is known.
    [[nodiscard]] static constexpr Symbol of_expression(std::uint32_t expression, std::uint32_t node) {
        return {Kind::opaque, expression, 0, node};
    }
    /// What something leaves of which nothing is known: equal numbers, equal value.
    [[nodiscard]] static constexpr Symbol opaque(std::uint64_t what = 0, std::uint32_t why = 0,
                                                 std::uint32_t where = 0) {
        return {Kind::opaque, what, why, where};
    }
    /// A machine's variable while nothing has acted, and nothing was stored in it, since the two nodes.
    [[nodiscard]] static constexpr Symbol of_machine(std::uint64_t name, std::uint32_t acted,
                                                     std::uint32_t stored) {
        return {Kind::machine, name, acted, stored};
    }
    /// `round`: 0, or which of several values one path gives the variable there.
    [[nodiscard]] static constexpr Symbol joined_at(std::uint64_t key, std::uint32_t node,
                                                    std::uint32_t round = 0) {
        return {Kind::joined, key, node, round};
    }
    /// `second`: 0 where the operation has one operand.
    [[nodiscard]] static constexpr Symbol result_of(Operation operation, SymbolId first, SymbolId second) {
        return {Kind::result, static_cast<std::uint64_t>(operation), first, second};
    }
    [[nodiscard]] static constexpr Symbol switch_of(std::uint64_t level) {
        return {Kind::skip_switch, level};
    }
    [[nodiscard]] static constexpr Symbol value_if_set(SymbolId value, std::uint32_t effect,
                                                       std::uint32_t node) {
        return {Kind::if_set, value, effect, node};
    }

    [[nodiscard]] constexpr Kind kind() const { return kind_; }
    /// Of a constant.
    [[nodiscard]] constexpr double number() const { return std::bit_cast<double>(of(Kind::constant).a_); }
    /// Of a value at the program's start, or where paths meet.
    [[nodiscard]] constexpr std::uint64_t key() const {
        assert(kind_ == Kind::entry || kind_ == Kind::joined);
        return a_;
    }
    /// Whether it is what that variable holds at the program's start.
    [[nodiscard]] constexpr bool is_entry_of(std::uint64_t key) const {
        return kind_ == Kind::entry && a_ == key;
    }
    /// Of a group at the program's start.
    [[nodiscard]] constexpr GroupId group() const { return static_cast<GroupId>(of(Kind::entry_group).a_); }
    /// The expression that it is the value of; nothing for others.
    [[nodiscard]] constexpr std::optional<std::uint64_t> expression() const {
        return kind_ == Kind::opaque && b_ == 0 ? std::optional(a_) : std::nullopt;
    }
    /// Where an expression was evaluated.
    [[nodiscard]] constexpr std::uint32_t evaluated_at() const { return of(Kind::opaque).c_; }
    /// Where paths meet.
    [[nodiscard]] constexpr std::uint32_t met_at() const { return of(Kind::joined).b_; }
    /// Of a result.
    [[nodiscard]] constexpr Operation operation() const {
        return static_cast<Operation>(of(Kind::result).a_);
    }
    [[nodiscard]] constexpr SymbolId first() const { return of(Kind::result).b_; }
    /// 0: the operation has one operand.
    [[nodiscard]] constexpr SymbolId second() const { return of(Kind::result).c_; }
    /// Of a word that counts if it is set.
    [[nodiscard]] constexpr SymbolId word_value() const { return static_cast<SymbolId>(of(Kind::if_set).a_); }

    friend bool operator==(const Symbol&, const Symbol&) = default;
    friend constexpr std::uint64_t hash_local(const Symbol& s) {
        if (s.kind_ == Kind::constant) return mix(0, s.a_);
        // Of a few variables at very many nodes, and the other way round.
        if (s.kind_ == Kind::joined) return mix(0, s.b_) + s.a_;
        return s.a_ + 4 * (std::uint64_t{s.b_} + s.c_) + static_cast<std::uint64_t>(s.kind_);
    }
    friend constexpr std::uint64_t hash_mixed(const Symbol& s) {
        return mix(mix(static_cast<std::uint64_t>(s.kind_), s.a_), side_by_side(s.b_, s.c_));
    }

  private:
    constexpr explicit Symbol(Kind kind)
        : kind_(kind) {}
    constexpr Symbol(Kind kind, std::uint64_t a, std::uint32_t b = 0, std::uint32_t c = 0)
        : kind_(kind)
        , a_(a)
        , b_(b)
        , c_(c) {}
    [[nodiscard]] constexpr const Symbol& of([[maybe_unused]] Kind kind) const {
        assert(kind_ == kind);
        return *this;
    }

    Kind kind_;
    std::uint64_t a_ = 0;         ///< bits of the number, key, group, expression, operation, level, value
    std::uint32_t b_ = 0, c_ = 0; ///< operands, nodes, what for
};

} // namespace maclint::dataflow
