//! The scanner: one pass over the bytes, numbers converted only where their value matters.
#include "analyzer/dialect/fanuc/plain.hpp"

#include "analyzer/dialect/ascii.hpp"
#include "analyzer/dialect/fanuc/lexer.hpp"
#include "analyzer/dialect/numbers.hpp"

#include <cassert>

namespace maclint::fanuc {
namespace {

constexpr bool is_space(char c) { return c == ' ' || c == '\t'; }

/// Reads one block; every function returns false when the block is not plain.
class Scanner {
  public:
    Scanner(std::string_view text, Offset begin, const CodeTable& codes, ScannedBlock& block)
        : start_(text.data())
        , at_(text.data() + begin)
        , end_(text.data() + text.size())
        , codes_(codes)
        , block_(block) {}

    Lane run() {
        block_.sequence_span = {};
        block_.settings_count = 0;
        while (at_ != end_) {
            const Letter letter = codes_.letters[static_cast<unsigned char>(*at_)];
            if (letter == Letter::blank) {
                ++at_;
                continue;
            }
            if (letter == Letter::end) return finish(offset(at_) + 1);
            if (first_ == nullptr) first_ = at_;
            if (!item(letter)) return Lane::grammar;
            last_ = at_;
        }
        return finish(offset(at_));
    }

  private:
    [[nodiscard]] Offset offset(const char* variable) const { return static_cast<Offset>(variable - start_); }

    Lane finish(Offset next) {
        block_.next = next;
        block_.span =
            first_ == nullptr ? Span{offset(at_), offset(at_)} : Span{offset(first_), offset(last_)};
        block_.moves = axes_ && (traits_ & (no_axes | no_words)) == 0;
        if (!words_ && block_.sequence_span.empty()) return Lane::blank;
        if (speed_ && (traits_ & limits_speed) != 0) return Lane::grammar; // the S sets nothing
        return Lane::plain;
    }

    bool item(Letter letter) {
        switch (letter) {
        case Letter::comment: return comment();
        case Letter::axis: axes_ = true; [[fallthrough]];
        case Letter::other: words_ = true; return address() && skip_number();
        case Letter::g: words_ = true; return address() && g_code();
        case Letter::m: words_ = true; return address() && m_code();
        case Letter::f: words_ = true; return address() && value_of(codes_.feed);
        case Letter::s: words_ = true; return address() && value_of(codes_.speed);
        case Letter::n: return address() && sequence_number();
        default: return false;
        }
    }

    /// A comment must be closed on its line; one that speaks to maclint is for the other lane to record.
    bool comment() {
        const std::string_view text(start_, static_cast<std::size_t>(end_ - start_));
        const Offset open = offset(at_);
        const Offset end = after_comment(text, open);
        at_ = start_ + end;
        const std::string_view comment = text.substr(open, end - open);
        return is_closed(comment) && !addresses_maclint(comment);
    }

    bool address() {
        ++at_;
        while (at_ != end_ && is_space(*at_)) ++at_;
        return at_ != end_;
    }

    void sign() {
        if (*at_ != '-' && *at_ != '+') return;
        negative_ = *at_ == '-';
        ++at_;
        while (at_ != end_ && is_space(*at_)) ++at_;
    }

    bool skip_number() {
        sign();
        const char* const digits = at_;
        while (at_ != end_ && is_digit(*at_)) ++at_;
        std::ptrdiff_t count = at_ - digits;
        if (at_ != end_ && *at_ == '.') {
            const char* const decimals = ++at_;
            while (at_ != end_ && is_digit(*at_)) ++at_;
            count += at_ - decimals;
        }
        return count != 0;
    }

    /// A number of at most 15 digits into `mantissa_` and `decimals_`.
    bool number() {
        mantissa_ = 0;
        decimals_ = 0;
        unsigned digits = 0;
        for (; at_ != end_ && is_digit(*at_); ++at_, ++digits)
            mantissa_ = mantissa_ * 10 + static_cast<std::uint64_t>(*at_ - '0');
        if (at_ != end_ && *at_ == '.') {
            ++at_;
            for (; at_ != end_ && is_digit(*at_); ++at_, ++decimals_)
                mantissa_ = mantissa_ * 10 + static_cast<std::uint64_t>(*at_ - '0');
        }
        return digits + decimals_ != 0 && digits + decimals_ <= 15;
    }

    bool g_code() {
        if (!number() || decimals_ > 1) return false;
        const std::uint64_t index = decimals_ == 1 ? mantissa_ : mantissa_ * 10;
        if (index >= CodeTable::g_codes) return false;
        const Code code = codes_.g[index];
        if ((code.traits & (own_effect | synchronises)) != 0) return false;
        traits_ |= code.traits;
        return code.group == no_group || set(code.group, scaled(index, 1));
    }

    bool m_code() {
        if (!number() || decimals_ != 0 || mantissa_ >= CodeTable::m_codes) return false;
        if ((codes_.m[mantissa_] & (own_effect | synchronises)) != 0) return false;
        const GroupId group = mantissa_ < codes_.m_groups.size() ? codes_.m_groups[mantissa_] : no_group;
        return group == no_group || set(group, scaled(mantissa_, 0));
    }

    bool value_of(GroupId group) {
        negative_ = false;
        sign();
        if (!number()) return false;
        const double value = scaled(mantissa_, decimals_);
        return set(group, negative_ && value != 0 ? -value : value);
    }

    bool sequence_number() {
        if (last_ != nullptr) return false; // not at the head
        const char* const digits = at_;
        if (!number() || decimals_ != 0 || at_[-1] == '.' || at_ - digits > 9) return false;
        block_.sequence_number = static_cast<std::int64_t>(mantissa_);
        block_.sequence_span = {offset(first_), offset(at_)};
        return true;
    }

    bool set(GroupId group, double value) {
        if (block_.settings_count == ScannedBlock::most_settings) return false;
        block_.settings[block_.settings_count++] = {group, value};
        speed_ |= group == codes_.speed;
        return true;
    }

    const char* start_;
    const char* at_;
    const char* end_;
    const CodeTable& codes_;
    ScannedBlock& block_;
    const char* first_ = nullptr;
    const char* last_ = nullptr;
    std::uint64_t mantissa_ = 0;
    unsigned decimals_ = 0;
    bool negative_ = false;
    bool axes_ = false;
    bool words_ = false;
    bool speed_ = false;
    std::uint8_t traits_ = 0;
};

} // namespace

Lane scan_block(std::string_view text, Offset begin, const CodeTable& codes, ScannedBlock& block) {
    return Scanner(text, begin, codes, block).run();
}

void RunTotals::add(const ScannedBlock& block) {
    span_ = blocks_ == 0 ? block.span : Span{span_.begin, block.span.end};
    ++blocks_;
    moves_ |= block.moves;
    has_sequence_numbers_ |= !block.sequence_span.empty();
    for (std::size_t i = 0; i < block.settings_count; ++i) {
        const ModalSetting& setting = block.settings[i];
        assert(setting.group < last_.size());
        last_[setting.group] = setting.value;
        touched_ |= std::uint64_t{1} << setting.group;
    }
}

void RunTotals::close(ProgramBuilder& program) {
    if (blocks_ == 0) return;
    std::array<ModalSetting, std::tuple_size_v<decltype(last_)>> net; // of the groups that were set
    std::size_t count = 0;
    for (std::size_t group = 0; group < last_.size(); ++group)
        if ((touched_ >> group & 1) != 0) net[count++] = {static_cast<GroupId>(group), last_[group]};
    program.add_run(PlainRun{.span = span_,
                             .blocks = blocks_,
                             .moves = moves_,
                             .has_sequence_numbers = has_sequence_numbers_,
                             .net = {}},
                    std::span(net).first(count));
    *this = {};
}

void decode_run(const Program& program, Span part, const std::function<bool(const PlainBlock&)>& visit) {
    const CodeTable& codes = codes_of(*program.control);
    const std::string_view text = program.text.substr(0, part.end);
    ScannedBlock scanned;
    PlainBlock block{};
    for (Offset at = part.begin; at < part.end; at = scanned.next) {
        const Lane lane = scan_block(text, at, codes, scanned);
        assert(lane != Lane::grammar && "the reader ends a run before such a block");
        if (lane == Lane::grammar) return;
        if (lane == Lane::blank) continue;
        block.span = scanned.span;
        block.sequence_number.reset();
        if (!scanned.sequence_span.empty()) block.sequence_number = scanned.sequence_number;
        block.sequence_number_span = scanned.sequence_span;
        block.moves = scanned.moves;
        block.settings.assign(scanned.settings.begin(), scanned.settings.begin() + scanned.settings_count);
        if (!visit(block)) return;
    }
}

} // namespace maclint::fanuc
