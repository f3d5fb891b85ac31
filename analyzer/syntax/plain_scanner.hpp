//! The plain scanner: reads a block of nothing but addresses and literal numbers straight from its bytes, in
//! one pass; numbers are converted only where somebody wants their value.
#pragma once

#include "analyzer/source/span.hpp"
#include "analyzer/syntax/plain_tables.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace maclint::syntax {

enum class Lane : std::uint8_t {
    blank,   ///< no words: blanks and comments only
    plain,   ///< everything is known
    grammar, ///< the block must be parsed
};

/// A block as the scanner leaves it. For Lane::grammar only the lane is known.
struct PlainBlock {
    static constexpr std::size_t most_settings = 24; ///< a block with more goes to the grammar
    Span span;        ///< from its first byte to after the last one that is no blank
    Offset next;      ///< after its end
    Span number_span; ///< of the block number; empty without one
    std::int64_t number;
    AddressSet addresses;
    AddressSet repeated; ///< those that stand there more than once
    CodeSet codes;
    bool conflicts; ///< one group is set more than once, or exclusive codes stand there
    bool moves;
    std::uint8_t settings_count;
    std::array<Setting, most_settings> settings_memory;

    [[nodiscard]] std::span<const Setting> settings() const {
        return std::span(settings_memory).first(settings_count);
    }
};

/// A word of a plain block.
struct PlainWord {
    AddressId id;
    bool incremental;
    bool decimal_point;
    double value;
    Span address;
    Span span; ///< address and number
};

/// `mantissa` with the decimal point moved `decimals` places; both exact up to 15 digits.
[[nodiscard]] inline double scaled(std::uint64_t mantissa, unsigned decimals) {
    static constexpr std::array<double, 16> powers{1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                   1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const auto whole = static_cast<double>(mantissa);
    return decimals == 0 ? whole : whole / powers[decimals];
}
/// A number of more digits; only digits and the point are looked at.
[[nodiscard]] double read_long_number(std::string_view text);

/// Passes words over.
struct NoWords {
    static constexpr bool wanted = false;
};

/// Hands every word on, its value read.
template<class Visit>
struct EachWord {
    static constexpr bool wanted = true;
    const Visit& visit;
};

/// Reads one block; every function returns false when the block is not plain.
template<class Words>
class PlainScanner {
  public:
    PlainScanner(std::string_view text, Offset begin, const PlainTables& tables, PlainBlock& block,
                 Words words)
        : start_(text.data())
        , begin_(text.data() + begin)
        , at_(begin_)
        , end_(text.data() + text.size())
        , tables_(tables)
        , block_(block)
        , words_(words) {}

    Lane run() {
        block_.number_span = {};
        block_.settings_count = 0;
        while (at_ != end_) {
            const PlainTables::Row row = tables_.bytes[static_cast<unsigned char>(*at_)];
            if (row.start == PlainStart::blank) {
                ++at_;
                continue;
            }
            if (row.start == PlainStart::end) return finish(offset(at_) + 1);
            if (first_ == nullptr) first_ = at_;
            if (!item(row)) return Lane::grammar;
            last_ = at_;
        }
        return finish(offset(at_));
    }

  private:
    using Row = PlainTables::Row;

    static constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
    static constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }
    static constexpr bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
    [[nodiscard]] Offset offset(const char* at) const { return static_cast<Offset>(at - start_); }

    Lane finish(Offset next) {
        using namespace plain_traits;
        block_.next = next;
        block_.span =
            first_ == nullptr ? Span{offset(at_), offset(at_)} : Span{offset(first_), offset(last_)};
        block_.moves = (traits_ & moves) != 0 || (axes_ && (traits_ & no_axes) == 0);
        block_.addresses = addresses_;
        block_.repeated = repeated_.without(tables_.may_repeat);
        block_.codes = codes_;
        block_.conflicts = conflicts_;
        if (block_.span.length() > tables_.longest) return Lane::grammar;
        if (addresses_.empty() && block_.number_span.empty()) return Lane::blank;
        return (traits_ & of_values_) == 0 ? Lane::plain : Lane::grammar;
    }

    bool item(Row row) {
        if (row.start == PlainStart::comment) return comment();
        const char* const address = at_++;
        if (at_ == end_) return false;
        bool incremental = false;
        const char* after_address = at_;
        if (!may_begin_number(*at_)) { // rarely: a second letter, an increment, blanks
            if (!tables_.pairs.empty() && is_capital(*at_) && is_capital(*address)) {
                row = tables_.pairs[PlainTables::pair(*address, *at_)];
                after_address = ++at_;
            }
            incremental = takes_incremental(row);
            if (tables_.blanks_after_address || row.start == PlainStart::block_number)
                while (at_ != end_ && is_blank(*at_)) ++at_;
            if (at_ == end_) return false;
        }
        const char* const digits = at_;
        if (row.start == PlainStart::block_number) return block_number(row.form);
        if (!number_of(row)) return false;
        if (tables_.not_after_number != 0 && at_ != end_ && *at_ == tables_.not_after_number) return false;
        of_values_ |= row.traits;
        const AddressSet own = AddressSet::of(row.id);
        repeated_.add(addresses_.common(own));
        addresses_.add(own);
        if constexpr (Words::wanted)
            words_.visit(PlainWord{row.id,
                                   incremental,
                                   point_,
                                   value_of(digits),
                                   {offset(address), offset(after_address)},
                                   {offset(address), offset(at_)}});
        return true;
    }

    /// Digits, signs and the point; what else is among them is no number either.
    static constexpr bool may_begin_number(char c) { return c >= '+' && c <= '9'; }

    bool takes_incremental(Row row) {
        if (tables_.incremental == 0 || at_ == end_ || *at_ != tables_.incremental) return false;
        if (row.start == PlainStart::code || row.start == PlainStart::block_number) return false;
        ++at_;
        return true;
    }

    bool number_of(Row row) {
        switch (row.start) {
        case PlainStart::axis: axes_ = true; [[fallthrough]];
        case PlainStart::number: return any_number(row.form);
        case PlainStart::value: return group_value(row);
        case PlainStart::code: return code(row);
        default: return false;
        }
    }

    /// A comment must be closed on its line.
    bool comment() {
        const char* const open = at_;
        bool suspicious = false;
        while (++at_ != end_ && *at_ != tables_.comment_end) {
            if (*at_ == '\n' || *at_ == '\r') return false;
            suspicious |= (*at_ | 0x20) == 'm';
        }
        if (at_ == end_) return false;
        ++at_;
        return !suspicious || !tables_.is_directive({open, static_cast<std::size_t>(at_ - open)});
    }

    void sign() {
        negative_ = false;
        if (*at_ != '-' && *at_ != '+') return;
        negative_ = *at_ == '-';
        ++at_;
        while (at_ != end_ && is_blank(*at_)) ++at_;
    }

    bool any_number(PlainForm form) {
        sign();
        if (negative_ && form.unsigned_only) return false;
        if constexpr (Words::wanted) {
            read_number();
            return digits_ != 0 && has_form(form);
        }
        const char* const digits = at_;
        while (at_ != end_ && is_digit(*at_)) ++at_;
        std::ptrdiff_t count = at_ - digits;
        if (count > form.most_digits) return false;
        if (at_ != end_ && *at_ == '.') {
            if (form.without_point) return false;
            const char* const decimals = ++at_;
            while (at_ != end_ && is_digit(*at_)) ++at_;
            count += at_ - decimals;
        }
        return count != 0;
    }

    /// A number into `mantissa_`, `decimals_` and `digits_`; the mantissa is good for up to 15 digits.
    void read_number() {
        mantissa_ = 0;
        const char* const digits = at_;
        for (; at_ != end_ && is_digit(*at_); ++at_)
            mantissa_ = mantissa_ * 10 + static_cast<unsigned char>(*at_ - '0');
        digits_ = static_cast<std::size_t>(at_ - digits);
        decimals_ = 0;
        point_ = at_ != end_ && *at_ == '.';
        if (!point_) return;
        const char* const decimals = ++at_;
        for (; at_ != end_ && is_digit(*at_); ++at_)
            mantissa_ = mantissa_ * 10 + static_cast<unsigned char>(*at_ - '0');
        decimals_ = static_cast<unsigned>(at_ - decimals);
        digits_ += decimals_;
    }

    /// Of the number that was read.
    [[nodiscard]] bool has_form(PlainForm form) const {
        return digits_ - decimals_ <= form.most_digits && !(point_ && form.without_point) &&
               !(negative_ && form.unsigned_only);
    }

    bool exact_number() {
        read_number();
        return digits_ != 0 && digits_ <= exact_digits;
    }

    [[nodiscard]] double value_of(const char* digits) const {
        const double value = digits_ <= exact_digits
                                 ? scaled(mantissa_, decimals_)
                                 : read_long_number({digits, static_cast<std::size_t>(at_ - digits)});
        return negative_ && value != 0 ? -value : value;
    }

    bool code(Row row) {
        const PlainCodes& codes = tables_.codes[row.which];
        negative_ = false;
        if (!exact_number() || decimals_ > codes.decimals || (point_ && row.form.without_point)) return false;
        std::uint64_t index = mantissa_;
        for (unsigned i = decimals_; i < codes.decimals; ++i) index *= 10;
        if (index >= codes.rows.size()) return false;
        const PlainCode found = codes.rows[index];
        if ((found.traits & plain_traits::not_plain) != 0) return false;
        traits_ |= found.traits;
        codes_.add(found.kind);
        conflicts_ |= (exclusive_ & found.exclusive) != 0;
        exclusive_ |= found.exclusive;
        if (found.group == no_group) return true;
        return set(found.group, found.member != 0 ? found.member : scaled(mantissa_, decimals_));
    }

    bool group_value(Row row) {
        sign();
        if (at_ == end_ || !exact_number() || !has_form(row.form)) return false;
        const double value = scaled(mantissa_, decimals_);
        return set(row.which, negative_ && value != 0 ? -value : value);
    }

    /// Only at the head of a block.
    bool block_number(PlainForm form) {
        constexpr std::size_t longest = 9;
        if (last_ != nullptr) return false;
        if (!exact_number() || point_ || digits_ > longest || digits_ > form.most_digits) return false;
        block_.number = static_cast<std::int64_t>(mantissa_);
        block_.number_span = {offset(first_), offset(at_)};
        return true;
    }

    bool set(std::uint8_t group, double value) {
        if (block_.settings_count == PlainBlock::most_settings) return false;
        conflicts_ |= groups_.add(group);
        block_.settings_memory[block_.settings_count++] = {group, value};
        return true;
    }

    static constexpr std::size_t exact_digits = 15;

    const char* start_;
    const char* begin_;
    const char* at_;
    const char* end_;
    const PlainTables& tables_;
    PlainBlock& block_;
    Words words_;
    const char* first_ = nullptr;
    const char* last_ = nullptr;
    std::uint64_t mantissa_ = 0;
    GroupSet groups_;
    std::uint32_t exclusive_ = 0;
    AddressSet addresses_;
    AddressSet repeated_;
    CodeSet codes_;
    std::size_t digits_ = 0;
    unsigned decimals_ = 0;
    bool point_ = false;
    bool negative_ = false;
    bool axes_ = false;
    bool conflicts_ = false;
    std::uint8_t traits_ = 0;
    std::uint8_t of_values_ = 0;
};

/// Scans the block that begins at `begin` in `text`.
[[nodiscard]] Lane scan_block(std::string_view text, Offset begin, const PlainTables& tables,
                              PlainBlock& block);

/// The same, and calls `visit(PlainWord)` for its words, the block number left out.
template<class Visit>
Lane scan_words(std::string_view text, Offset begin, const PlainTables& tables, PlainBlock& block,
                const Visit& visit) {
    return PlainScanner<EachWord<Visit>>(text, begin, tables, block, {visit}).run();
}

} // namespace maclint::syntax
