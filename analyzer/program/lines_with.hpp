//! The lines of a text that hold one of a few codes, found without reading the others.
#pragma once

#include "analyzer/source/span.hpp"

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <span>
#include <string_view>

namespace maclint {

/// Whole codes of one letter below a thousand, and whether others are meant, too.
class CodeNumbers {
  public:
    static constexpr std::size_t capacity = 1000;

    void add(double code) {
        if (code >= 0 && code < capacity) codes_.set(static_cast<std::size_t>(code)); // 54 for 54.1
    }
    void add_beyond() { beyond_ = true; }

    /// Whether the number that the text begins with, after blanks, is one of them; false where none stands.
    [[nodiscard]] bool may_begin(std::string_view text) const {
        std::size_t at = 0;
        while (at < text.size() && (text[at] == ' ' || text[at] == '\t')) ++at;
        std::size_t code = 0;
        const std::size_t first = at;
        for (; at < text.size() && text[at] >= '0' && text[at] <= '9' && code < capacity; ++at)
            code = code * 10 + static_cast<std::size_t>(text[at] - '0');
        if (at == first) return false;
        return code < capacity ? codes_[code] : beyond_;
    }

  private:
    std::bitset<capacity> codes_;
    bool beyond_ = false; ///< those of a thousand and more
};

/// A letter and the codes that are looked for behind it.
struct LetterCodes {
    char letter; ///< a capital; small ones count, too
    CodeNumbers codes;
};

/// `visit(Span)` for each line of the part, its end left out, that holds one of the codes, in a comment or
/// not; lines end at LF or CR.
template<class Visit>
void for_each_line_with(std::span<const LetterCodes> wanted, std::string_view text, Span part,
                        const Visit& visit) {
    std::array<const CodeNumbers*, 256> codes{};
    for (const LetterCodes& one : wanted) {
        codes[static_cast<unsigned char>(one.letter)] = &one.codes;
        codes[static_cast<unsigned char>(one.letter - 'A' + 'a')] = &one.codes;
    }
    const std::string_view whole = text.substr(0, part.end);
    std::size_t begin = part.begin;
    for (std::size_t at = part.begin; at < whole.size(); ++at) {
        const char c = whole[at];
        if (c == '\n' || c == '\r') begin = at + 1;
        const CodeNumbers* of_letter = codes[static_cast<unsigned char>(c)];
        if (of_letter == nullptr || !of_letter->may_begin(whole.substr(at + 1))) continue;
        const std::size_t end = std::min(whole.find_first_of("\n\r", at), whole.size());
        visit(Span{static_cast<Offset>(begin), static_cast<Offset>(end)});
        at = end;
        begin = end + 1;
    }
}

} // namespace maclint
