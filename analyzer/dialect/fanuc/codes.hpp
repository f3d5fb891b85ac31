//! What G and M codes do beyond setting a modal group: the fact table, and the same indexed for the scanner.
#pragma once

#include "analyzer/program/tables.hpp"
#include "analyzer/syntax/plain_tables.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

namespace maclint::fanuc {

/// What a code does, as bits that add up.
enum Trait : std::uint16_t {
    own_effect = 1 << 0,   ///< the model needs an effect of its own: the block goes to the grammar
    synchronises = 1 << 1, ///< look-ahead stops here; such a block goes to the grammar too
    no_axes = 1 << 2,      ///< axis words beside it are no target of a move
    no_words = 1 << 3,     ///< no word beside it means what it usually does: neither axes nor F nor S
    limits_speed = 1 << 4, ///< S beside it is a limit, not the speed
    without_feed = 1 << 5, ///< moves at rapid traverse, whatever the motion mode is
    may_call = 1 << 6,     ///< no table knows it: it may call a macro with the words beside it as arguments
    limits_ahead = 1 << 7, ///< with a P, look-ahead is limited from here on
    to_reference = 1 << 8, ///< moves to or from a reference position, or asks whether it is there
};

/// One row of the code table.
struct CodeFact {
    char letter;
    double code;
    std::string_view machines; ///< M: mills; A, B, C: lathes of that G code system
    std::uint16_t traits;
    std::string_view source;
};

/// A code as the scanner meets it.
struct Code {
    GroupId group;
    std::uint16_t traits;
};
constexpr GroupId no_group = syntax::no_group;

/// The code facts and modal groups of a machine type, indexed.
struct CodeTable {
    static constexpr std::size_t g_codes = 10'000; ///< in tenths: G54.1 is 541
    static constexpr std::size_t m_codes = 10'000;
    std::array<Code, g_codes> g;
    std::array<std::uint16_t, m_codes> m;
    std::array<GroupId, 100> m_groups; ///< of M00 to M99
    GroupId feed;
    GroupId speed;
    GroupId local_offset;
    bool tool_changes_at_once; ///< by T alone, as lathes do: T0101
    bool tool_calls_program;   ///< by a parameter of the machine
    syntax::PlainTables plain; ///< for blocks that need no grammar

    [[nodiscard]] bool is_axis(char letter) const {
        return plain.bytes[static_cast<unsigned char>(letter)].start == syntax::PlainStart::axis;
    }
    /// The row of a literal G code; codes that no table holds set nothing and do nothing.
    [[nodiscard]] Code g_code(double code) const;
    [[nodiscard]] std::uint16_t m_code(double code) const;
    [[nodiscard]] GroupId m_group(double code) const;
};

/// The table of the machine type that the control drives, and of its G code system.
[[nodiscard]] const CodeTable& usual_codes_of(const ControlModel& control);
/// The same with the machine's own codes, where they call programs.
[[nodiscard]] const CodeTable& codes_of(const ControlModel& control);

} // namespace maclint::fanuc
