//! What is known of one value: vacant or not, how large, how exact, and which computation it is the result
//! of.
#pragma once

#include "analyzer/dataflow/few.hpp"
#include "analyzer/program/model.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace maclint::dataflow {

/// `maybe` is known to be possible and has a reason (Value::doubt); `unknown` is ignorance and proves
/// nothing.
enum class Vacancy : std::uint8_t { set, vacant, maybe, unknown };

/// Whether rounding has touched a value. `rounded` has a place (Value::rounding).
enum class Exactness : std::uint8_t { exact, unknown, rounded };

using SymbolId = std::uint32_t; ///< equal symbols at one point of the program are equal values
using OriginId = std::uint32_t; ///< 0: none

/// Where something came from.
struct Origin {
    enum class Kind : std::uint8_t { none, entry, effect, expression, run } kind;
    std::uint32_t id;   ///< effect or expression; entry: the number of the place; run: the modal group that a
                        ///< plain block set
    std::uint32_t node; ///< flow node; entry: the space of the place
    friend bool operator==(const Origin&, const Origin&) = default;
};

/// A computation, as a value number.
struct Symbol {
    enum class Kind : std::uint8_t {
        constant, ///< a: the bits of the number
        vacant,
        entry,       ///< a: key; the value at the program's start
        entry_group, ///< a: group; the code in force when the program was called
        opaque,      ///< a: expression or effect, b: what for; nothing more is known
        joined,      ///< a: key, b: node where ways with different values meet
        result,      ///< a: operation, b, c: operand symbols
    } kind;
    std::uint64_t a;
    std::uint32_t b, c;
    friend bool operator==(const Symbol&, const Symbol&) = default;
};

struct Value {
    SymbolId symbol = 0;
    OriginId origin = 0;   ///< the store that made it the content of its variable
    OriginId doubt = 0;    ///< why it can be vacant, or 0 because something else is vacant
    OriginId rounding = 0; ///< where it was rounded
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    Vacancy vacancy = Vacancy::unknown;
    Exactness exactness = Exactness::unknown;
    bool integer = false;
    bool nonzero = false; ///< known not to be 0 although the range holds it

    [[nodiscard]] std::optional<double> constant() const {
        return low == high && vacancy != Vacancy::vacant && vacancy != Vacancy::maybe ? std::optional(low)
                                                                                      : std::nullopt;
    }
    /// Vacant counts as 0, as it does in arithmetic.
    [[nodiscard]] bool can_be(double number) const {
        const bool may_be_vacant = vacancy == Vacancy::vacant || vacancy == Vacancy::maybe;
        if (number == 0 && may_be_vacant) return true;
        return low <= number && number <= high && !(nonzero && number == 0);
    }
    friend bool operator==(const Value&, const Value&) = default;
};

/// One way a modal group can be: a code, the caller's code, a value.
struct ModalPart {
    SymbolId symbol;
    OriginId origin; ///< what set it; 0: nothing in this program
    friend bool operator==(const ModalPart&, const ModalPart&) = default;
};

/// All ways a modal group can be at a point, sorted by symbol; `unknown` beside them: any other, too.
struct ModalValue {
    Few<ModalPart, 2> parts;
    bool unknown = false;
    friend bool operator==(const ModalValue&, const ModalValue&) = default;
};

constexpr std::size_t most_spaces = 8;

/// For each space: 0, or the opaque symbol of what made all its variables unknown that a state's tree does
/// not hold.
using Forgotten = std::array<SymbolId, most_spaces>;
using ForgottenId = std::uint32_t; ///< 0: nothing is forgotten

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

// A thing has a place near others that are asked for at the same time, which keeps long programs in the
// processor's caches, and one far from them, for where too many things want the same place.

constexpr std::uint64_t near(const Symbol& s) {
    if (s.kind == Symbol::Kind::constant) return mix(0, s.a);
    return s.a + 4 * (std::uint64_t{s.b} + s.c) + static_cast<std::uint64_t>(s.kind);
}
constexpr std::uint64_t far(const Symbol& s) {
    return mix(mix(static_cast<std::uint64_t>(s.kind), s.a), side_by_side(s.b, s.c));
}

constexpr std::uint64_t near(const Origin& o) { return o.id + static_cast<std::uint64_t>(o.kind); }
constexpr std::uint64_t far(const Origin& o) {
    return mix(static_cast<std::uint64_t>(o.kind), side_by_side(o.id, o.node));
}

constexpr std::uint64_t near(const Value& v) { return 4 * std::uint64_t{v.symbol} + v.origin; }
constexpr std::uint64_t far(const Value& v) {
    const auto flags = (static_cast<std::uint64_t>(v.vacancy) << 16U) |
                       (static_cast<std::uint64_t>(v.exactness) << 8U) | (v.integer ? 1U : 0U) |
                       (v.nonzero ? 2U : 0U);
    std::uint64_t hash = mix(flags, side_by_side(v.symbol, v.origin));
    hash = mix(hash, side_by_side(v.doubt, v.rounding));
    hash = mix(hash, std::bit_cast<std::uint64_t>(v.low));
    return mix(hash, std::bit_cast<std::uint64_t>(v.high));
}

inline std::uint64_t near(const ModalValue& v) {
    return v.parts.empty() ? 0 : 4 * std::uint64_t{v.parts.front().symbol} + v.parts.front().origin;
}
inline std::uint64_t far(const ModalValue& v) {
    std::uint64_t hash = v.unknown ? 1 : 0;
    for (const ModalPart& part : v.parts) hash = mix(hash, side_by_side(part.symbol, part.origin));
    return hash;
}

constexpr std::uint64_t far(const Forgotten& symbols) {
    std::uint64_t hash = 0;
    for (const SymbolId symbol : symbols) hash = mix(hash, symbol);
    return hash;
}
constexpr std::uint64_t near(const Forgotten& symbols) { return far(symbols); }

/// Stores equal things once and names them by number. Open addressing: most programs are small, and every one
/// has four.
template<class T>
class Interner {
  public:
    std::uint32_t operator()(const T& thing) {
        if (2 * things_.size() >= slots_.size()) grow();
        std::uint32_t& slot = slots_[place_of(thing)];
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
        slots_ = {};
    }

  private:
    /// So many slots are looked at near the thing's first place before the search goes on far from it.
    static constexpr int most_near = 8;

    /// The slot that holds the thing, or the free one where it belongs.
    [[nodiscard]] std::size_t place_of(const T& thing) const {
        const std::size_t mask = slots_.size() - 1;
        std::size_t place = near(thing) & mask;
        for (int i = 0; i < most_near; ++i) {
            if (is_place_of(thing, place)) return place;
            place = (place + 1) & mask;
        }
        place = far(thing) & mask;
        while (!is_place_of(thing, place)) place = (place + 1) & mask;
        return place;
    }
    [[nodiscard]] bool is_place_of(const T& thing, std::size_t place) const {
        return slots_[place] == 0 || things_[slots_[place] - 1] == thing;
    }

    void grow() {
        constexpr std::size_t fewest = 64;
        slots_.assign(std::max(fewest, std::bit_ceil(4 * things_.size())), 0);
        things_.reserve(slots_.size() / 2);
        for (std::size_t i = 0; i < things_.size(); ++i)
            slots_[place_of(things_[i])] = static_cast<std::uint32_t>(i + 1);
    }

    std::vector<T> things_;
    std::vector<std::uint32_t> slots_; ///< 0: free; otherwise one more than the thing's number
};

/// The tables of one program's analysis.
struct Pool {
    Interner<Symbol> symbols;
    Interner<Origin> origins;
    Interner<Value> values;
    Interner<ModalValue> modals;
    Interner<Forgotten> forgotten_sets; ///< most programs have none

    [[nodiscard]] ForgottenId remember(const Forgotten& forgotten) { return forgotten_sets(forgotten) + 1; }
    [[nodiscard]] Forgotten forgotten(ForgottenId id) const {
        return id == 0 ? Forgotten{} : forgotten_sets[id - 1];
    }

    Pool();
    void fit();
    [[nodiscard]] SymbolId constant(double number);
    [[nodiscard]] std::optional<double> number_of(SymbolId symbol) const;
    /// The group whose code at the program's start the symbol stands for.
    [[nodiscard]] std::optional<GroupId> entry_group_of(SymbolId symbol) const;
};

[[nodiscard]] Value number_value(Pool& pool, double number);
/// The same for a number whose symbol is known.
[[nodiscard]] Value number_value(SymbolId symbol, double number);
[[nodiscard]] Value vacant_value(Pool& pool, OriginId doubt);

} // namespace maclint::dataflow
