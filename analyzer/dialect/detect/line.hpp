//! A line of a text of unknown language, cut into what the signatures of languages look at.
#pragma once

#include "analyzer/dialect/characters.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace maclint::detect {

constexpr bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\0'; }

/// Which characters a text holds, as bits of their last six bits: what a text lacks it does not hold, and
/// that is cheap to ask. Capitals, digits and signs differ in these bits.
constexpr unsigned last_bits_of(char c) { return static_cast<unsigned char>(c) & 63U; }
constexpr std::uint64_t character_bit(char c) { return std::uint64_t{1} << last_bits_of(c); }
constexpr std::uint64_t characters_of(std::string_view text) {
    std::uint64_t bits = 0;
    for (const char c : text) bits |= character_bit(c);
    return bits;
}

[[nodiscard]] std::string_view trim(std::string_view text);
[[nodiscard]] bool starts_with_any(std::string_view text, std::span<const std::string_view> heads);

/// The line ends of a text from front to back. Each kind is looked for alone, which is quicker than looking
/// for both, and only once as far as it is away.
class LineEnds {
  public:
    explicit LineEnds(std::string_view text)
        : text_(text)
        , feed_(first_from('\n', 0))
        , carriage_return_(first_from('\r', 0)) {}

    /// The first one at or after `at`, or the end of the text. `at` never goes back.
    [[nodiscard]] std::size_t from(std::size_t at) {
        if (feed_ < at) feed_ = first_from('\n', at);
        if (carriage_return_ < at) carriage_return_ = first_from('\r', at);
        return std::min(feed_, carriage_return_);
    }

  private:
    [[nodiscard]] std::size_t first_from(char c, std::size_t at) const {
        return std::min(text_.find(c, at), text_.size());
    }

    std::string_view text_;
    std::size_t feed_;
    std::size_t carriage_return_;
};

/// A letter and its number, as they stand in plain G-code.
struct Word {
    char letter;
    std::int32_t tenths; ///< ten times the number, for G38.2; bounded
    std::uint8_t digits; ///< before the point
};

/// Everything but `as_written` is in capitals. Good until the next call of `read`.
class Line {
  public:
    /// Takes the line apart; `text` has no line end.
    void read(std::string_view text);

    [[nodiscard]] std::string_view as_written() const { return as_written_; }
    [[nodiscard]] std::string_view whole() const { return whole_; }
    /// Those of the whole line.
    [[nodiscard]] std::uint64_t characters() const { return characters_; }
    /// Without its number, its comments in round brackets, and what stands after `;`.
    [[nodiscard]] std::string_view code() const { return code_; }
    /// Of the first comment in round brackets, without the bracket.
    [[nodiscard]] std::string_view comment() const { return comment_; }
    /// After the first `;`.
    [[nodiscard]] std::string_view remark() const { return remark_; }
    /// Of a line that holds nothing but letters with numbers; `is_plain` says whether it does.
    [[nodiscard]] std::span<const Word> words() const { return {words_.data(), word_count_}; }
    [[nodiscard]] bool is_plain() const { return plain_; }

    [[nodiscard]] const Word* word(char letter) const;
    [[nodiscard]] bool has(char letter, std::int32_t first_tenths, std::int32_t last_tenths) const;

  private:
    void split();
    void read_words();

    std::string_view as_written_, code_, comment_, remark_;
    std::string whole_, without_comments_;
    std::uint64_t characters_ = 0;
    std::array<Word, 24> words_{};
    std::size_t word_count_ = 0;
    bool plain_ = false;
};

/// `visit(line, end)` for each line that is not empty, and the byte at which it ends, until it answers false.
template<class Visit>
void for_each_filled_line(std::string_view text, const Visit& visit) {
    Line line;
    LineEnds ends(text);
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = ends.from(at);
        line.read(text.substr(at, end - at));
        at = end + 1;
        if (!line.whole().empty() && !visit(line, end)) return;
    }
}

/// `line` without a sequence number `N10` or the bare number of a Klartext line.
[[nodiscard]] std::string_view after_number(std::string_view line);

/// Whether a control of the Fanuc family could mean this: a word, a variable, a keyword, a comment, a mark.
[[nodiscard]] bool looks_like_block(std::string_view whole);

} // namespace maclint::detect
