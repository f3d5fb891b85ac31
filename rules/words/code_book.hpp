//! Chapters of a language's codes: each code, its words, and what is said of them, a line each.
#pragma once

#include "rules/words/book_line.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace maclint {

/// The lines of one chapter; one page for each code of a section.
struct CodeBook {
    std::string_view language;           ///< of the control: "dinplus"
    std::string_view chapter;            ///< "turning cycles"
    std::string_view source;             ///< key of docs/sources.md that the lines count in: "SEED-003"
    TableText sections;                  ///< where a code names none
    std::optional<Machine> machine = {}; ///< nothing: of mills and lathes
    TableText controls = {};             ///< names or models, where a code names none; empty: any
    /// Pages of the manual are missing: nothing is said of codes and words that it does not name.
    bool partial = false;
    std::span<const BookLine> lines;

    /// For its rows.
    [[nodiscard]] constexpr WordTable without_rows() const {
        return {
            .language = language, .machine = machine, .sections = sections, .controls = controls, .rows = {}};
    }
    /// Whether it is of the control's language and kind of machine.
    [[nodiscard]] bool is_of_machine(const ControlModel& control) const;
    /// Whether its codes are those of the control.
    [[nodiscard]] bool is_of(const ControlModel& control) const;
};

/// All chapters: the one place that lists them.
[[nodiscard]] std::span<const CodeBook* const> all_code_books();

} // namespace maclint
