//! Chapters of a language's codes: each code, its words, and what is said of them, a line each.
#pragma once

#include "rules/words/word_row.hpp"

#include <cstdint>
#include <limits>
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

/// What the lines of chapters are written with.
namespace book {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// Reads a number and takes it off the text.
constexpr double take_number(std::string_view& text) {
    const bool negative = text.starts_with('-');
    if (negative) text.remove_prefix(1);
    double value = 0;
    double place = 0;
    std::size_t read = 0;
    for (; read < text.size() && ((text[read] >= '0' && text[read] <= '9') || text[read] == '.'); ++read) {
        if (text[read] == '.' && !text.substr(read).starts_with("..")) {
            place = 1;
            continue;
        }
        if (text[read] == '.') break;
        value = value * 10 + (text[read] - '0');
        place *= 10;
    }
    if (read == 0) throw "a number belongs here";
    text.remove_prefix(read);
    return (negative ? -value : value) / (place > 0 ? place : 1);
}

/// Sets the values that a word takes: "0 1 2", "1..127", ">0", ">=0", ">-60 <60". Anything else does not
/// compile.
constexpr void set_values(WordRow& row, std::string_view takes) {
    if (takes.empty()) return;
    if (takes.find("..") == std::string_view::npos && takes.front() != '<' && takes.front() != '>') {
        row.values = takes;
        return;
    }
    while (!takes.empty()) {
        const char sign = takes.front();
        if (sign == ' ') {
            takes.remove_prefix(1);
        } else if (sign == '<' || sign == '>') {
            takes.remove_prefix(1);
            const bool itself = takes.starts_with('=');
            if (itself) takes.remove_prefix(1);
            const double bound = take_number(takes);
            (sign == '>' ? row.least : row.most) = bound;
            (sign == '>' ? row.above_least : row.below_most) = !itself;
        } else {
            row.least = take_number(takes);
            if (!takes.starts_with("..")) throw "two full stops belong between bounds";
            takes.remove_prefix(2);
            row.most = take_number(takes);
        }
    }
}

/// `codes`: "G83", or several that say the same.
constexpr BookLine code(std::string_view codes, std::uint32_t line, std::string_view means,
                        std::string_view sections = {}) {
    return {BookLine::Kind::code,
            {.says = RowStatement::takes_only,
             .code = codes,
             .sections = sections,
             .means = means,
             .effect = {},
             .severity = Severity::warning,
             .source = {}},
            line};
}

/// `takes`: see set_values(); empty: any value.
constexpr BookLine word(std::string_view address, std::uint32_t line, std::string_view means,
                        std::string_view takes = {}) {
    BookLine result{BookLine::Kind::word,
                    {.says = RowStatement::values,
                     .code = {},
                     .words = address,
                     .means = means,
                     .effect = {},
                     .severity = Severity::warning,
                     .source = {}},
                    line};
    set_values(result.row, takes);
    return result;
}

constexpr BookLine statement(RowStatement says, std::string_view words, std::string_view others,
                             std::uint32_t line, std::string_view means, std::string_view effect,
                             Severity severity = Severity::warning) {
    return {BookLine::Kind::statement,
            {.says = says,
             .code = {},
             .words = words,
             .others = others,
             .means = means,
             .effect = effect,
             .severity = severity,
             .source = {}},
            line};
}

/// One of the words at least; `means`: what they are together.
constexpr BookLine needs(std::string_view words, std::uint32_t line, std::string_view means,
                         std::string_view effect) {
    return statement(RowStatement::needs, words, {}, line, means, effect);
}
/// None of the words.
constexpr BookLine takes_not(std::string_view words, std::uint32_t line, std::string_view effect) {
    return statement(RowStatement::takes_not, words, {}, line, {}, effect);
}
/// One of the words or of the others, not both.
constexpr BookLine excludes(std::string_view words, std::string_view others, std::uint32_t line,
                            std::string_view effect) {
    return statement(RowStatement::excludes, words, others, line, {}, effect);
}
/// The words beside one of the others only; "O=1" is one with that value, "Q=1|2" with one of several.
constexpr BookLine only_with(std::string_view words, std::string_view others, std::uint32_t line,
                             std::string_view effect) {
    return statement(RowStatement::only_with, words, others, line, {}, effect);
}
/// A value under a condition (BookLine::when).
constexpr BookLine value(std::string_view word, std::string_view takes, std::uint32_t line,
                         std::string_view effect) {
    BookLine result = statement(RowStatement::values, word, {}, line, {}, effect);
    set_values(result.row, takes);
    return result;
}
/// No word beside the code but these.
constexpr BookLine alone(std::string_view words, std::uint32_t line, std::string_view effect) {
    return statement(RowStatement::alone, words, {}, line, {}, effect);
}
/// Not in a block with one of these codes.
constexpr BookLine apart(std::string_view codes, std::uint32_t line, std::string_view effect) {
    return statement(RowStatement::apart, {}, codes, line, {}, effect);
}
/// The next block with a code of the same letter holds one of these.
constexpr BookLine precedes(std::string_view codes, std::uint32_t line, std::string_view effect) {
    return statement(RowStatement::precedes, {}, codes, line, {}, effect);
}
/// The next block with a code of the same letter holds another one than these.
constexpr BookLine not_before(std::string_view codes, std::uint32_t line, std::string_view effect) {
    return statement(RowStatement::precedes, codes, {}, line, {}, effect);
}

} // namespace book
} // namespace maclint
