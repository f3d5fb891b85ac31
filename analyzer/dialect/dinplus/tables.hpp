//! HEIDENHAIN DIN PLUS (CNC PILOT, MANUALplus): sections, variables, modal groups, calls and codes, as rows
//! of facts. Sources are lines of the seed "smart.Turn and DIN programming", edition 01/2022 (l.NNN).
#pragma once

#include "analyzer/program/tables.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace maclint::dinplus {

/// Rows of ControlModel::spaces.
namespace spaces {
constexpr SpaceId local = 0, ///< #l
    local_text = 1,          ///< #x
    channel = 2,             ///< #c
    global = 3,              ///< #g
    transfer = 4,            ///< #__la: the number is the row of `transfer_letters`
    named = 5,               ///< #_name of VAR: the number is the index in Program::names
    constant = 6,            ///< _name of CONST: the number is the index in Program::names
    machine = 7;             ///< #i #n #m #d #e #w #t #a
} // namespace spaces

/// Rows of ControlModel::families, one for each letter after `#`.
namespace families {
constexpr FamilyId l = 0, x = 1, c = 2, g = 3, i = 4, n = 5, m = 6, d = 7, e = 8, w = 9, t = 10, a = 11;
}
/// The family of `#l…`, any case; nothing for a letter that begins no variable.
[[nodiscard]] std::optional<FamilyId> family_of(char letter);

/// Rows of ControlModel::calls.
namespace calls {
constexpr CallKindId local = 0, ///< L"name" without V1: a SUBPROGRAM section of the same file
    external = 1;               ///< L"name" V1: a file
}

/// Rows of ControlModel::references.
namespace references {
constexpr ReferenceKindId contour = 0;
}

/// The words that hand a value to a subprogram, without the leading `L` of `LA` … `LZ`: "la" is read as
/// `#__la`. Row n is Variable{spaces::transfer, n}.
// clang-format off
inline constexpr auto transfer_letters = std::to_array<std::string_view>({
    "la", "lb", "lc", "ld", "le", "lf", "lh", "li", "lj", "lk", "ln", "lo", "lp", "lr", "ls", "lu", "lw", "lx", "ly",
    "lz", "bs", "be", "ws", "ac", "wc", "rc", "ic", "kc", "jc", "id", "at"});
// clang-format on
/// The variable `#__name`; `name` without the underscores, any case: "la", and "id1" for "id". The bare
/// letters that some lists print ("i" for "li") are taken too.
[[nodiscard]] std::optional<Variable> transfer_variable(std::string_view name);

/// Section words; `kind` is the row of ControlModel::sections that they begin.
struct SectionWord {
    std::string_view word; ///< capitals, as the control spells it: FACE_C, PROGRAM HEAD
    std::string_view kind; ///< English word of today: name of a row of ControlModel::sections
    enum class Use : std::uint8_t {
        english,
        german,
        older,      ///< of predecessor controls
        translated, ///< printed in translated manuals, known to no control: to be reported with the real word
    } use;
    std::string_view source;
};
[[nodiscard]] std::span<const SectionWord> section_words();
/// The row of a word as it stands in the text: any blanks or underscores between its parts, capitals.
[[nodiscard]] const SectionWord* find_section_word(std::string_view word);

/// What a code does to the model, as bits that add up. A code that no row holds sets its modal group, if it
/// has one, and does nothing else that the model knows of.
enum Trait : std::uint16_t {
    moves = 1 << 0,        ///< axes move, with or without words: motion codes, cycles, approaches
    sets_group = 1 << 1,   ///< the code is a member of a modal group (ControlModel::group_of)
    off_by_word = 1 << 2,  ///< sets the group's `cancel` when the word `off_letter` is there with `off_value`
    feed_word = 1 << 4,    ///< F is the feed
    speed_word = 1 << 5,   ///< S is the speed
    approaches = 1 << 6,   ///< goes to the tool change position: lower as ToolChange::Kind::approach
    synchronises = 1 << 7, ///< look-ahead stops
    pauses = 1 << 8,       ///< Stop::Kind::pause
    ends = 1 << 9,         ///< Stop::Kind::end
    restarts = 1 << 10,    ///< Stop::Kind::restart, its number the word NS
    block_words = 1 << 11, ///< NS and NE name blocks of a contour: lower as Reference
};

/// One row of the code table. It tells of the command; many numbers exist as a contour element too.
struct CodeFact {
    char letter;              ///< 'G' or 'M'
    std::int32_t first, last; ///< codes that the row holds
    std::uint16_t traits;
    std::string_view source;
    std::string_view off_letter = {}; ///< of off_by_word: "Q"
    double off_value = 0;
};
/// The row of a code, or nullptr.
[[nodiscard]] const CodeFact* find_code(char letter, double code);

/// The group that `#n<number>(<selector>)` reads, or nothing.
[[nodiscard]] std::optional<GroupId> group_read(std::int32_t number, std::string_view selector);

/// The one control of the language: "dinplus".
[[nodiscard]] const ControlModel& control();

} // namespace maclint::dinplus
