//! How the numbers of addresses are written, whatever codes stand beside them: a line an address.
#pragma once

#include "rules/words/word_row.hpp"

#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

/// One address, or several that say the same. What a field does not say is not looked at.
struct AddressLine {
    TableText addresses;   ///< "H D", blanks between them
    TableText means;       ///< "offset number"
    bool whole = false;    ///< without a decimal point
    bool positive = false; ///< without a minus
    int most_digits = 0;   ///< before the point; 0: nobody knows
    TableText controls;    ///< WordRow::controls
    TableText systems = {};
    Severity severity;
    TableText source;
};

/// The lines of one language, and the alarms of its controls.
struct AddressBook {
    std::string_view language;
    std::optional<Machine> machine = {}; ///< nothing: mills and lathes
    TableText assumed; ///< the control that is taken where nobody has named one; there they warn.
                       ///< Empty: there nothing is said
    std::span<const RowAlarm> point, minus, digits; ///< raised where a line is not kept
    std::span<const AddressLine> lines;
};

[[nodiscard]] std::span<const AddressBook* const> all_address_books();
/// What an address is where no code says more: "tool"; empty: nobody says it.
[[nodiscard]] TableText meaning_of_address(std::string_view language, std::string_view address);
/// A row for each address and each thing that is said of it; they point into the book, and to the addresses,
/// which are put into `texts`.
[[nodiscard]] std::vector<WordRow> rows_of(const AddressBook& book, std::deque<std::string>& texts);

} // namespace maclint
