//! Chapters of a language's codes: each code, its words, and what is said of them, a line each.
#pragma once

#include "rules/words/word_row.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace maclint {

/// How surely a code needs a word, by what its manual says and shows.
enum class Need : std::uint8_t {
    none,
    in_examples, ///< every example of the manual has it; no more is known
    likely,      ///< nothing could be done without it
    sure,        ///< the manual says so
};

/// A code, a word of the code above it, or a statement on words of that code.
struct BookLine {
    enum class Kind : std::uint8_t { code, word, statement } kind;
    /// Of a code: its codes, sections and `means`; of a word: `words`, `means` and the values that it takes;
    /// of a statement: all but the code.
    WordRow row;
    std::uint32_t line = 0; ///< of the manual
    Need need = Need::none;
    std::string_view absent = {}; ///< what holds where the word is not written: "0", "feed in force"

    /// The word is needed; `effect` is what comes of a block without it.
    [[nodiscard]] constexpr BookLine needed(std::string_view effect = {}) const {
        BookLine copy = *this;
        copy.need = Need::likely;
        copy.row.effect = effect;
        return copy;
    }
    /// And the manual says so.
    [[nodiscard]] constexpr BookLine required(std::string_view effect = {}) const {
        BookLine copy = *this;
        copy.need = Need::sure;
        copy.row.effect = effect;
        return copy;
    }
    [[nodiscard]] constexpr BookLine in_examples() const {
        BookLine copy = *this;
        copy.need = Need::in_examples;
        return copy;
    }
    /// What comes of a value that is not taken.
    [[nodiscard]] constexpr BookLine or_else(std::string_view effect) const {
        BookLine copy = *this;
        copy.row.effect = effect;
        return copy;
    }
    [[nodiscard]] constexpr BookLine without(std::string_view what) const {
        BookLine copy = *this;
        copy.absent = what;
        return copy;
    }
    /// Conditions on words of the block: WordRow::when.
    [[nodiscard]] constexpr BookLine when(std::string_view conditions) const {
        BookLine copy = *this;
        copy.row.when = conditions;
        return copy;
    }
    /// Codes of the block after: WordRow::unless_next.
    [[nodiscard]] constexpr BookLine unless_next(std::string_view codes) const {
        BookLine copy = *this;
        copy.row.unless_next = codes;
        return copy;
    }
    /// Codes of the block before: WordRow::after, WordRow::unless_after.
    [[nodiscard]] constexpr BookLine after(std::string_view codes) const {
        BookLine copy = *this;
        copy.row.after = codes;
        return copy;
    }
    [[nodiscard]] constexpr BookLine unless_after(std::string_view codes) const {
        BookLine copy = *this;
        copy.row.unless_after = codes;
        return copy;
    }
    /// Of a code: it stands elsewhere, too, where one of these codes comes later: WordRow::unless_later.
    [[nodiscard]] constexpr BookLine also_before(std::string_view codes) const {
        BookLine copy = *this;
        copy.row.unless_later = codes;
        return copy;
    }
    [[nodiscard]] constexpr BookLine as(Severity severity) const {
        BookLine copy = *this;
        copy.row.severity = severity;
        return copy;
    }
    [[nodiscard]] constexpr BookLine also(std::string_view aliases) const {
        BookLine copy = *this;
        copy.row.aliases = aliases;
        return copy;
    }
    [[nodiscard]] constexpr BookLine off(std::string_view reason) const {
        BookLine copy = *this;
        copy.row.off_reason = reason;
        return copy;
    }
};

/// The lines of one chapter; one page for each code of a section.
struct CodeBook {
    std::string_view language; ///< of the control: "dinplus"
    std::string_view chapter;  ///< "turning cycles"
    std::string_view source;   ///< key of docs/sources.md that the lines count in: "SEED-003"
    std::string_view sections; ///< where a code names none
    std::span<const BookLine> lines;
};

/// All chapters: the one place that lists them.
[[nodiscard]] std::span<const CodeBook* const> all_code_books();

} // namespace maclint
