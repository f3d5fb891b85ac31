//! A line of a chapter of codes: a code, a word of it, or a statement on its words.
#pragma once

#include "rules/words/word_row.hpp"

#include <cstdint>

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
    TableText absent = {}; ///< what holds where the word is not written: "0", "feed in force"
    TableText source = {}; ///< key of docs/sources.md, where it is not the book's with `line`: "GH-ALM"

    template<class Value>
    [[nodiscard]] constexpr BookLine with(Value WordRow::*field, Value value) const {
        BookLine copy = *this;
        copy.row.*field = value;
        return copy;
    }

    /// The word is needed; `effect` is what comes of a block without it.
    [[nodiscard]] constexpr BookLine needed(TableText effect = {}) const {
        BookLine copy = *this;
        copy.need = Need::likely;
        copy.row.effect = effect;
        return copy;
    }
    /// And the manual says so.
    [[nodiscard]] constexpr BookLine required(TableText effect = {}) const {
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
    [[nodiscard]] constexpr BookLine or_else(TableText effect) const {
        return with(&WordRow::effect, effect);
    }
    [[nodiscard]] constexpr BookLine without(TableText what) const {
        BookLine copy = *this;
        copy.absent = what;
        return copy;
    }
    [[nodiscard]] constexpr BookLine when(TableText conditions) const {
        return with(&WordRow::when, conditions);
    }
    [[nodiscard]] constexpr BookLine unless_next(TableText codes) const {
        return with(&WordRow::unless_next, codes);
    }
    [[nodiscard]] constexpr BookLine after(TableText codes) const { return with(&WordRow::after, codes); }
    [[nodiscard]] constexpr BookLine unless_after(TableText codes) const {
        return with(&WordRow::unless_after, codes);
    }
    /// Of a code: it stands elsewhere, too, where one of these codes comes later: WordRow::unless_later.
    [[nodiscard]] constexpr BookLine also_before(TableText codes) const {
        return with(&WordRow::unless_later, codes);
    }
    [[nodiscard]] constexpr BookLine as(Severity severity) const {
        return with(&WordRow::severity, severity);
    }
    [[nodiscard]] constexpr BookLine also(TableText aliases) const {
        return with(&WordRow::aliases, aliases);
    }
    /// Only on these controls, of lathes with these systems.
    [[nodiscard]] constexpr BookLine on(TableText controls) const {
        return with(&WordRow::controls, controls);
    }
    [[nodiscard]] constexpr BookLine in_systems(TableText systems) const {
        return with(&WordRow::systems, systems);
    }
    /// What a value leaves when it is divided by the number counts: WordRow::modulo.
    [[nodiscard]] constexpr BookLine rest_of(int number) const { return with(&WordRow::modulo, number); }
    [[nodiscard]] constexpr BookLine under(TableText codes) const { return with(&WordRow::under, codes); }
    /// The words stay while the code's group is in force: WordRow::kept.
    [[nodiscard]] constexpr BookLine kept() const { return with(&WordRow::kept, true); }
    /// Of what is off again at the end: also at the next tool.
    [[nodiscard]] constexpr BookLine at_tool() const { return with(&WordRow::others, TableText("T")); }
    /// Only while that switch is on, or off: WordRow::while_on.
    [[nodiscard]] constexpr BookLine while_on(TableText name) const { return with(&WordRow::while_on, name); }
    [[nodiscard]] constexpr BookLine while_off(TableText name) const {
        return with(&WordRow::while_off, name);
    }
    /// Also in a block that calls a program: WordRow::in_calls.
    [[nodiscard]] constexpr BookLine in_calls() const { return with(&WordRow::in_calls, true); }
    /// The alarm that the control raises where the line is not kept, by its list.
    [[nodiscard]] constexpr BookLine alarm(TableText list, TableText number) const {
        BookLine copy = *this;
        for (RowAlarm& place : copy.row.alarms)
            if (place.number.empty()) {
                place = {list, number};
                return copy;
            }
        throw "there is no room for another alarm";
    }
    [[nodiscard]] constexpr BookLine from(TableText key) const {
        BookLine copy = *this;
        copy.source = key;
        return copy;
    }
    [[nodiscard]] constexpr BookLine off(TableText reason) const {
        return with(&WordRow::off_reason, reason);
    }
};

} // namespace maclint
