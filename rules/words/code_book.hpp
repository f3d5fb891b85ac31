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
        return with([&](BookLine& copy) {
            copy.need = Need::likely;
            copy.row.effect = effect;
        });
    }
    /// And the manual says so.
    [[nodiscard]] constexpr BookLine required(std::string_view effect = {}) const {
        return with([&](BookLine& copy) {
            copy.need = Need::sure;
            copy.row.effect = effect;
        });
    }
    [[nodiscard]] constexpr BookLine in_examples() const {
        return with([](BookLine& copy) { copy.need = Need::in_examples; });
    }
    /// What comes of a value that is not taken.
    [[nodiscard]] constexpr BookLine or_else(std::string_view effect) const {
        return with([&](BookLine& copy) { copy.row.effect = effect; });
    }
    [[nodiscard]] constexpr BookLine without(std::string_view what) const {
        return with([&](BookLine& copy) { copy.absent = what; });
    }
    /// Conditions on words of the block: WordRow::when.
    [[nodiscard]] constexpr BookLine when(std::string_view conditions) const {
        return with([&](BookLine& copy) { copy.row.when = conditions; });
    }
    /// Codes of the block after: WordRow::unless_next.
    [[nodiscard]] constexpr BookLine unless_next(std::string_view codes) const {
        return with([&](BookLine& copy) { copy.row.unless_next = codes; });
    }
    /// Codes of the block before: WordRow::after, WordRow::unless_after.
    [[nodiscard]] constexpr BookLine after(std::string_view codes) const {
        return with([&](BookLine& copy) { copy.row.after = codes; });
    }
    [[nodiscard]] constexpr BookLine unless_after(std::string_view codes) const {
        return with([&](BookLine& copy) { copy.row.unless_after = codes; });
    }
    /// Of a code: it stands elsewhere, too, where one of these codes comes later: WordRow::unless_later.
    [[nodiscard]] constexpr BookLine also_before(std::string_view codes) const {
        return with([&](BookLine& copy) { copy.row.unless_later = codes; });
    }
    [[nodiscard]] constexpr BookLine as(Severity severity) const {
        return with([&](BookLine& copy) { copy.row.severity = severity; });
    }
    [[nodiscard]] constexpr BookLine also(std::string_view aliases) const {
        return with([&](BookLine& copy) { copy.row.aliases = aliases; });
    }
    [[nodiscard]] constexpr BookLine off(std::string_view reason) const {
        return with([&](BookLine& copy) { copy.row.off_reason = reason; });
    }

  private:
    template<class Change>
    [[nodiscard]] constexpr BookLine with(Change change) const {
        BookLine copy = *this;
        change(copy);
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
