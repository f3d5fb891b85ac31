//! Rows about the parts of a program, and words that name blocks of them.
#pragma once

#include <cstdint>
#include <string_view>

namespace maclint {

/// One row of the section table: a part of a program that a word of its own begins.
struct SectionKind {
    std::string_view name; ///< "MACHINING"
    enum class Role : std::uint8_t {
        information, ///< what the control reads when the program is loaded: head, tools, names
        contour,     ///< describes shapes; its blocks are what references mean
        machining,   ///< runs
        subprogram,
        end, ///< nothing may follow
    } role;
    bool required; ///< a main program must have it
    std::string_view source;
};

/// One row of the reference table: words that name blocks of certain sections.
struct ReferenceKind {
    std::string_view name;    ///< "contour block"
    SectionKind::Role target; ///< where the block must stand
    std::string_view source;
};

} // namespace maclint
