//! Rows about the words of a language that are neither addresses of one letter nor codes.
#pragma once

#include "analyzer/program/model.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace maclint {

/// What a word is in its language.
enum class WordUse : std::uint8_t {
    keyword,
    function,
    comparison, ///< or logic: stands between two operands
    statement,  ///< acts by itself: STOPRE, POPEN
    cycle,      ///< a program that the control brings
    address,    ///< stands before a value: CR=12.5
    attribute,  ///< of a program
    constant,
    part, ///< names what an index or an argument is about
};

struct LanguageWord {
    std::string_view word; ///< capitals
    WordUse use;
    std::string_view what;   ///< "sine of an angle"; empty: no more is known than its use
    std::string_view source; ///< key of docs/sources.md of `what`
};

/// Where a name stands in a block: behind `before`, where the block also has `word`. Capitals.
struct NamePlace {
    enum class Names : std::uint8_t { program, block } names;
    std::string_view word;   ///< "G65"
    std::string_view before; ///< "P"
};

/// A program that the control brings.
struct BroughtCycle {
    std::string_view name;                    ///< capitals
    std::vector<std::string_view> parameters; ///< in their order; empty: not known
    bool wants_no_compensation; ///< it stops with an alarm while radius compensation is in force
};

/// What the words of a language mean, where its names stand, and which programs its controls bring.
struct LanguageTables {
    std::span<const LanguageWord> words;
    std::span<const NamePlace> name_places;
    std::span<const BroughtCycle> cycles = {};
    /// What a variable of the control is that has a name: "REAL, with 1 index; can only be read"; empty where
    /// it has none of that name. Capitals. nullptr: such variables have numbers.
    std::string (*about_variable)(std::string_view name) = nullptr;
    /// Codes of other controls that the language lacks, "G43", sorted.
    std::span<const std::string_view> foreign_codes = {};
};

/// "keyword", "function".
[[nodiscard]] std::string_view name_of(WordUse use);
/// What an operation computes, in words: "square root"; empty where nobody knows.
[[nodiscard]] std::string_view what_it_computes(Operation operation);

} // namespace maclint
