//! What is known of one value: vacant or not, how large, how exact, and which computation it is the result
//! of.
#pragma once

#include "analyzer/dataflow/domain/interner.hpp"
#include "analyzer/dataflow/domain/small_vector.hpp"
#include "analyzer/dataflow/domain/symbol.hpp"
#include "analyzer/program/model.hpp"
#include "analyzer/semantics/abstract.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <span>
#include <vector>

namespace maclint::dataflow {

using semantics::Exactness;
using semantics::Vacancy;

using OriginId = std::uint32_t;  ///< 0: none
using ChoicesId = std::uint32_t; ///< 0: none are known
using ModalId = std::uint32_t;   ///< of a ModalValue

/// Where something came from.
struct Origin {
    enum class Kind : std::uint8_t { none, entry, effect, expression, run } kind;
    std::uint32_t id; ///< effect or expression; entry: the number of the variable; run: the modal group that
                      ///< a plain block set
    std::uint32_t node; ///< flow node; entry: the space of the variable

    [[nodiscard]] static constexpr Origin at_entry(Variable variable) {
        return {Kind::entry, static_cast<std::uint32_t>(variable.number), variable.space};
    }
    /// The variable whose value at the program's start is meant; nothing for other kinds.
    [[nodiscard]] constexpr std::optional<Variable> entry_variable() const {
        if (kind != Kind::entry) return std::nullopt;
        return Variable{static_cast<SpaceId>(node), static_cast<std::int32_t>(id)};
    }
    friend bool operator==(const Origin&, const Origin&) = default;
};

/// What a value can be, which computation it is the result of, and where that comes from.
struct Value : semantics::AbstractValue {
    SymbolId symbol = 0;
    OriginId origin = 0;         ///< the store that made it the content of its variable
    OriginId vacancy_origin = 0; ///< why it can be vacant, or 0 because something else is vacant
    OriginId rounding = 0;       ///< where it was rounded
    ChoicesId choices = 0; ///< the only numbers that it can be, where paths with different constants meet

    /// From now on that is known of it; symbol and origins stay.
    void know(const semantics::AbstractValue& now) { AbstractValue::operator=(now); }
    friend bool operator==(const Value&, const Value&) = default;
};

/// One thing that a modal group can be: a code, the caller's code, a value. Two origins of one symbol both
/// count.
struct ModalPart {
    SymbolId symbol;
    OriginId origin; ///< what set it; 0: nothing in this program
    friend auto operator<=>(const ModalPart&, const ModalPart&) = default;
};

/// All that a modal group can be at a point, sorted; `unknown` beside them: any other, too.
struct ModalValue {
    SmallVector<ModalPart, 2> parts;
    bool unknown = false;

    /// The parts sorted, each once.
    void put_in_order();
    /// Whether it can be everything that the other can be.
    [[nodiscard]] bool includes(const ModalValue& other) const;
    friend bool operator==(const ModalValue&, const ModalValue&) = default;
};

/// A few numbers, sorted.
struct Choices {
    SmallVector<double, 4> numbers;
    friend bool operator==(const Choices&, const Choices&) = default;
};

/// For each space: 0, or the opaque symbol of what made all its variables unknown that a state's tree does
/// not hold.
struct HavocSet {
    std::array<SymbolId, most_spaces> by_space{};
    friend bool operator==(const HavocSet&, const HavocSet&) = default;
};
using HavocId = std::uint32_t; ///< 0: nothing is forgotten

constexpr std::uint64_t hash_local(const Origin& o) { return o.id + static_cast<std::uint64_t>(o.kind); }
constexpr std::uint64_t hash_mixed(const Origin& o) {
    return mix(static_cast<std::uint64_t>(o.kind), side_by_side(o.id, o.node));
}

constexpr std::uint64_t hash_local(const Value& v) { return 4 * std::uint64_t{v.symbol} + v.origin; }
constexpr std::uint64_t hash_mixed(const Value& v) {
    const auto flags = (static_cast<std::uint64_t>(v.vacancy) << 16U) |
                       (static_cast<std::uint64_t>(v.exactness) << 8U) | (v.integer ? 1U : 0U) |
                       (v.nonzero ? 2U : 0U);
    std::uint64_t hash = mix(flags, side_by_side(v.symbol, v.origin));
    hash = mix(hash, side_by_side(v.vacancy_origin, v.rounding));
    hash = mix(hash, v.choices);
    hash = mix(hash, std::bit_cast<std::uint64_t>(v.low));
    return mix(hash, std::bit_cast<std::uint64_t>(v.high));
}

inline std::uint64_t hash_local(const ModalValue& v) {
    // In a row of blocks that may be skipped the first part stays the same.
    if (v.parts.empty()) return 0;
    const ModalPart& last = *std::prev(v.parts.end());
    return 4 * std::uint64_t{v.parts.front().symbol} + v.parts.front().origin + last.origin;
}
inline std::uint64_t hash_mixed(const ModalValue& v) {
    std::uint64_t hash = v.unknown ? 1 : 0;
    for (const ModalPart& part : v.parts) hash = mix(hash, side_by_side(part.symbol, part.origin));
    return hash;
}

inline std::uint64_t hash_mixed(const Choices& choices) {
    std::uint64_t hash = 0;
    for (const double number : choices.numbers) hash = mix(hash, std::bit_cast<std::uint64_t>(number));
    return hash;
}
inline std::uint64_t hash_local(const Choices& choices) { return hash_mixed(choices); }

constexpr std::uint64_t hash_mixed(const HavocSet& havoc) {
    std::uint64_t hash = 0;
    for (const SymbolId symbol : havoc.by_space) hash = mix(hash, symbol);
    return hash;
}
constexpr std::uint64_t hash_local(const HavocSet& havoc) { return hash_mixed(havoc); }

/// The tables of one program's analysis.
struct ValueTable {
    Interner<Symbol> symbols;
    Interner<Origin> origins;
    Interner<Value> values;
    Interner<ModalValue> modals;
    Interner<HavocSet> havoc_sets; ///< most programs have none
    Interner<Choices> choice_sets;

    [[nodiscard]] HavocId remember(const HavocSet& havoc);
    [[nodiscard]] const HavocSet& havoc(HavocId id) const {
        static constexpr HavocSet nothing;
        return id == 0 ? nothing : havoc_sets[id - 1];
    }

    /// The numbers of a value that is one of a few; none where it is one number or any.
    [[nodiscard]] std::span<const double> choices_of(const Value& value) const;
    /// Whether the value can be the number.
    [[nodiscard]] bool can_be(const Value& value, double number) const;
    /// What a value is that is one of the two; 0 when that is one number, or too many.
    [[nodiscard]] ChoicesId either(const Value& a, const Value& b);
    /// What is left of a value of which only these numbers are left, at least one.
    void narrow(Value& value, std::span<const double> numbers);

    ValueTable();
    void fit();
    [[nodiscard]] SymbolId constant(double number);
    [[nodiscard]] std::optional<double> number_of(SymbolId symbol) const;
    /// What a word asks for: the symbol itself, or that of its value where the word may have been ignored.
    [[nodiscard]] SymbolId asked_for(SymbolId symbol) const;
    /// The group whose code at the program's start the symbol stands for.
    [[nodiscard]] std::optional<GroupId> entry_group_of(SymbolId symbol) const;
};

[[nodiscard]] Value number_value(ValueTable& table, double number);
/// The same for a number whose symbol is known.
[[nodiscard]] Value number_value(SymbolId symbol, double number);
[[nodiscard]] Value vacant_value(ValueTable& table, OriginId vacancy_origin);

} // namespace maclint::dataflow
