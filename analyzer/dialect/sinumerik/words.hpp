//! The words of the language that are no codes of a group: procedures, functions, addresses, cycles.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace maclint::sinumerik {

enum class WordKind : std::uint8_t {
    keyword,   ///< shapes its block
    procedure, ///< that the control brings: STOPRE, MSG(…)
    cycle,     ///< a program that the control brings
    function,  ///< has a value
    address,   ///< stands before a value: CR=12.5
    command,   ///< acts by itself
    attribute, ///< stands behind PROC
    constant,  ///< a value: TRUE
    part,      ///< names what an index or an argument is about: `$P_UIFR[1,X,TR]`
};

struct WordRow {
    std::string_view name; ///< capitals
    WordKind kind;         ///< of a word of several kinds the first one above: SBLOF is a procedure
};

/// Nothing for a word that is none of the language, and for codes of G groups.
[[nodiscard]] const WordRow* find_word(std::string_view capitals);
/// Sorted by name.
[[nodiscard]] std::span<const WordRow> words();
/// Whether it may stand behind PROC; some procedures may, too.
[[nodiscard]] bool is_attribute(std::string_view capitals);

} // namespace maclint::sinumerik
