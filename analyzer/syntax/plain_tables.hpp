//! The tables from which the plain scanner reads: what bytes, addresses and codes mean in a dialect.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace maclint::syntax {

/// An address as the scanner knows it: a number that the dialect gives it.
using AddressId = std::uint8_t;

/// Addresses, by their numbers.
class AddressSet {
  public:
    static constexpr std::size_t capacity = 64;

    constexpr AddressSet() = default;
    [[nodiscard]] static constexpr AddressSet of(AddressId id) {
        AddressSet set;
        set.bits_ = bit(id);
        return set;
    }
    [[nodiscard]] static constexpr AddressSet all() {
        AddressSet set;
        set.bits_ = ~std::uint64_t{0};
        return set;
    }
    [[nodiscard]] constexpr AddressSet common(AddressSet other) const {
        other.bits_ &= bits_;
        return other;
    }
    void add(AddressId id) { bits_ |= bit(id); }
    void add(AddressSet other) { bits_ |= other.bits_; }
    [[nodiscard]] constexpr bool contains(AddressId id) const { return (bits_ & bit(id)) != 0; }
    [[nodiscard]] constexpr bool meets(AddressSet other) const { return (bits_ & other.bits_) != 0; }
    [[nodiscard]] constexpr bool empty() const { return bits_ == 0; }
    [[nodiscard]] int size() const { return std::popcount(bits_); }
    [[nodiscard]] constexpr AddressSet without(AddressSet other) const {
        AddressSet rest;
        rest.bits_ = bits_ & ~other.bits_;
        return rest;
    }
    friend constexpr bool operator==(AddressSet, AddressSet) = default;

  private:
    static constexpr std::uint64_t bit(AddressId id) { return std::uint64_t{1} << id; }
    std::uint64_t bits_ = 0;
};

/// Codes, by a number that several may share: what a set does not hold does not stand there.
class CodeSet {
  public:
    using Kind = std::uint8_t; ///< below `capacity`
    static constexpr std::size_t capacity = 128;

    /// The kind of a code of one of two letters (G, M). Codes below 96 of the first have each their own.
    [[nodiscard]] static constexpr Kind kind_of(std::size_t letter, std::uint64_t code) {
        constexpr std::uint64_t of_first = 96;
        return static_cast<Kind>(letter == 0 ? code % of_first : of_first + code % (capacity - of_first));
    }
    constexpr void add(Kind kind) { (kind < 64 ? low_ : high_) |= std::uint64_t{1} << (kind % 64U); }
    constexpr void add(CodeSet other) {
        low_ |= other.low_;
        high_ |= other.high_;
    }
    [[nodiscard]] constexpr bool meets(CodeSet other) const {
        return ((low_ & other.low_) | (high_ & other.high_)) != 0;
    }
    [[nodiscard]] constexpr bool empty() const { return (low_ | high_) == 0; }
    /// Whether `test(kind)` is true of one that both have.
    template<class Test>
    [[nodiscard]] constexpr bool any_common(CodeSet other, const Test& test) const {
        return any_of(low_ & other.low_, 0, test) || any_of(high_ & other.high_, 64, test);
    }
    template<class Visit>
    constexpr void for_each(const Visit& visit) const {
        (void)any_common(*this, [&](Kind kind) {
            visit(kind);
            return false;
        });
    }
    friend constexpr bool operator==(CodeSet, CodeSet) = default;

  private:
    template<class Test>
    [[nodiscard]] static constexpr bool any_of(std::uint64_t bits, int first, const Test& test) {
        for (; bits != 0; bits &= bits - 1)
            if (test(static_cast<Kind>(first + std::countr_zero(bits)))) return true;
        return false;
    }
    std::uint64_t low_ = 0, high_ = 0;
};

/// The last value given to a modal group.
struct Setting {
    std::uint8_t group;
    double value;
};
constexpr std::uint8_t no_group = UINT8_MAX;
/// The plain lane has room for so many groups.
constexpr std::size_t most_groups = 128;

/// Modal groups, by their numbers below `most_groups`.
class GroupSet {
  public:
    /// Whether the group was there before.
    constexpr bool add(std::uint8_t group) {
        std::uint64_t& half = halves_[group / half_size];
        const std::uint64_t bit = std::uint64_t{1} << group % half_size;
        const bool was_there = (half & bit) != 0;
        half |= bit;
        return was_there;
    }
    [[nodiscard]] constexpr std::size_t size() const {
        return static_cast<std::size_t>(std::popcount(halves_[0])) +
               static_cast<std::size_t>(std::popcount(halves_[1]));
    }
    /// From the lowest number on.
    template<class Visit>
    constexpr void for_each(const Visit& visit) const {
        for (std::size_t i = 0; i < halves_.size(); ++i)
            for (std::uint64_t left = halves_[i]; left != 0; left &= left - 1)
                visit(static_cast<std::uint8_t>(i * half_size +
                                                static_cast<std::size_t>(std::countr_zero(left))));
    }

  private:
    static constexpr std::size_t half_size = 64;
    std::array<std::uint64_t, most_groups / half_size> halves_{};
};

/// What codes mean for the words beside them, as bits that add up; the upper ones belong to the dialect: a
/// block in which a code and a value have one in common is not plain.
namespace plain_traits {
constexpr std::uint8_t not_plain = 1 << 0, ///< the block needs the grammar
    no_axes = 1 << 1,                      ///< axis words beside it are no target of a move
    moves = 1 << 2,                        ///< axes move, with or without words
    first_own = 1 << 3;
} // namespace plain_traits

/// How the number of an address is written where nothing is to be said of it; a block with another one is not
/// plain.
struct PlainForm {
    bool unsigned_only = false; ///< no minus
    bool without_point = false;
    std::uint8_t most_digits = UINT8_MAX; ///< before the point
};

/// What a byte, or the address that begins with it, is in a plain block.
enum class PlainStart : std::uint8_t {
    not_plain,
    blank,
    end,     ///< of the block
    comment, ///< up to PlainTables::comment_end, on one line
    number,  ///< a word whose number means nothing to the scanner
    axis,    ///< as `number`; the block moves if nothing speaks against it
    value,   ///< a word whose number is the value of a modal group
    code,    ///< a word whose number is a row of a code table
    block_number,
};

struct PlainCode {
    std::uint8_t group = no_group; ///< that it sets
    std::uint8_t traits = 0;
    CodeSet::Kind kind = 0;
    /// A bit for codes of which a block may hold one, whatever they set; 0: it may hold any number.
    std::uint32_t exclusive = 0;
    std::uint8_t member = 0; ///< what the group holds then; 0: the code as it is written
};

/// The codes of an address.
struct PlainCodes {
    std::vector<PlainCode> rows;
    unsigned decimals = 0; ///< at most so many are written; the index of a row is the code without its point
};

/// The tables of a dialect, or of one kind of section.
struct PlainTables {
    struct Row {
        PlainStart start = PlainStart::not_plain;
        AddressId id = 0;
        std::uint8_t which = 0;  ///< value: the group; code: the table in `codes`
        std::uint8_t traits = 0; ///< a code that has one of these, too, makes the block not plain
        PlainForm form = {};     ///< of a number, axis, value or block number
    };
    std::array<Row, 256> bytes;
    std::vector<Row> pairs; ///< addresses of two capitals, see pair(); empty where there are none
    std::array<PlainCodes, 2> codes;
    std::array<std::string_view, AddressSet::capacity> names; ///< of addresses; empty: as written
    AddressSet may_repeat; ///< addresses that may stand in a block more than once
    char comment_end = 0;
    char incremental = 0;              ///< may stand after an address; 0: nothing may
    bool blanks_after_address = false; ///< blanks may stand between address and number
    char not_after_number = 0;         ///< no word begins with it directly after a number; 0: any may
    std::uint32_t longest = 0;         ///< a longer block is not plain
    /// Whether a comment speaks to the analyser; the block is not plain then. Asked where it holds an `m`.
    bool (*is_directive)(std::string_view comment) = nullptr;

    static constexpr std::size_t letters = 26;
    [[nodiscard]] static std::size_t pair(char first, char second) {
        return static_cast<std::size_t>(first - 'A') * letters + static_cast<std::size_t>(second - 'A');
    }
};

} // namespace maclint::syntax
