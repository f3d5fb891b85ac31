//! What variables, functions and internal constants of DIN PLUS hold and take, as rows of facts. Sources are
//! lines of the seed, as in tables.hpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace maclint::dinplus {

/// What a value is; `either`: the program alone does not tell.
enum class Holds : std::uint8_t { number, whole, text, either };
/// Whether one is surely a text and the other surely a number.
[[nodiscard]] bool contradict(Holds a, Holds b);

/// What a program may do with a variable.
enum class Access : std::uint8_t {
    any,
    read_only,
    reserved, ///< kept for somebody else, who stores in it
};

/// ASCII capitals become small letters: names are compared so.
[[nodiscard]] std::string in_small_letters(std::string_view text);

/// Variables of one letter, from the first number to the last.
struct VariableRow {
    char letter;
    std::int32_t first, last;
    Holds holds;
    Access access;
    std::string_view what; ///< "information of the control"; of reserved ones for whom
    std::string_view source;
};
/// The row of the variable; nullptr where no row has the number.
[[nodiscard]] const VariableRow* find_variable(char letter, std::int64_t number);
/// Whether the manual's list is whole: a number that it lacks does not exist.
[[nodiscard]] bool knows_all_numbers(char letter);
/// "#l1 to #l99"; of several ranges all of them, those that are reserved left out.
[[nodiscard]] std::string numbers_of(char letter);

/// The selectors of `#<letter><number>(<selector>)`.
struct SelectorRow {
    char letter;
    std::int32_t number;        ///< any_number: of all
    std::string_view selectors; ///< capitals, blanks between them
    std::string_view source;
    static constexpr std::int32_t any_number = -1;
};
/// The row that says which selectors the variable has; nullptr where none does.
[[nodiscard]] const SelectorRow* selectors_of(char letter, std::int64_t number);
/// Whether one of the words, which blanks separate, is this one.
[[nodiscard]] bool holds_word(std::string_view words, std::string_view word);

/// Whether the name without its underscores, small letters, is in the list of internal constants: "n0_x".
[[nodiscard]] bool is_listed_constant(std::string_view name);

/// A function: how many arguments it has, what they are, what it gives.
struct FunctionRow {
    std::string_view name; ///< capitals
    std::size_t least, most;
    Holds takes, gives;
    std::string_view source;
};
[[nodiscard]] const FunctionRow* find_function(std::string_view capitals);
/// "one argument", "two arguments", "one or two arguments".
[[nodiscard]] std::string arguments_of(const FunctionRow& function);

/// Counts and bounds that the manual prints.
namespace limits {
constexpr std::size_t conditions = 2;          ///< linked by AND and OR [l.19669, l.19800]
constexpr std::size_t arguments = 29;          ///< transfer values of a call [l.19936]
constexpr std::size_t whole_figures = 10;      ///< before the point of a number [l.18889]
constexpr std::size_t decimals = 7;            ///< behind it [l.18889]
constexpr std::size_t name = 20;               ///< characters of a constant or variable [l.2957, l.19450]
constexpr std::size_t external_name = 16;      ///< characters of the name that L calls [l.19927]
constexpr std::size_t local_name = 40;         ///< characters of a SUBPROGRAM [l.2945]
constexpr std::size_t descriptions = 30;       ///< of transfer values [l.19954]
constexpr std::size_t description_text = 25;   ///< characters [l.19961]
constexpr int last_unit = 7;                   ///< of a description [l.19963-19971]
constexpr double least_bit = 0, last_bit = 15; ///< of BITSET [l.19653]
constexpr double last_bit_value = 65'535;      ///< of BITSET [l.19654]
constexpr double window_lines = 20;            ///< [l.19568]
/// The manual prints -32767 … +32768 [l.18888]; what lies beyond both readings is wrong.
constexpr double least_integer = -32'768, last_integer = 32'768;
} // namespace limits

} // namespace maclint::dinplus
