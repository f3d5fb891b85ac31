//! How the numbers of addresses are written, whatever codes stand beside them: a line an address.
#pragma once

#include "rules/words/word_row.hpp"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace maclint {

/// One address, or several that say the same. What a field does not say is not looked at.
struct AddressLine {
    std::string_view addresses; ///< "H D", blanks between them
    std::string_view means;     ///< "offset number"
    bool whole = false;         ///< without a decimal point
    bool positive = false;      ///< without a minus
    int most_digits = 0;        ///< before the point; 0: nobody knows
    std::string_view controls;  ///< WordRow::controls
    std::string_view systems = {};
    Severity severity;
    std::string_view source;
};

/// The lines of one language, and the alarms of its controls.
struct AddressBook {
    std::string_view language;
    std::optional<Machine> machine = {}; ///< nothing: mills and lathes
    std::string_view assumed; ///< the control that is taken where nobody has named one; there they warn.
                              ///< Empty: there nothing is said
    std::span<const RowAlarm> point, minus, digits; ///< raised where a line is not kept
    std::span<const AddressLine> lines;
};

[[nodiscard]] std::span<const AddressBook* const> all_address_books();
/// What an address is where no code says more: "tool"; empty: nobody says it.
[[nodiscard]] std::string_view meaning_of_address(std::string_view language, std::string_view address);
/// A row for each address and each thing that is said of it; they point into the book.
[[nodiscard]] std::vector<WordRow> rows_of(const AddressBook& book);

} // namespace maclint
