//! The kinds of check that a rule can have.
#pragma once

#include <cstdint>
#include <string_view>

namespace maclint::queries {
struct WordsOfBlock;
}

namespace maclint {

class ProgramAnalysis;
struct ProgramFile;
class Reporter;

/// Raised by the command itself: while files are read, or when suppressions are matched.
struct RaisedByCommand {};
/// Looks at the text of a file, and at its programs without what is known of them.
using FileCheck = void (*)(const ProgramFile&, Reporter&);
using ProgramCheck = void (*)(const ProgramAnalysis&, Reporter&);

/// Looks at the words of one block after another. All such checks share one pass over the words of a program;
/// none is shown a plain block that it cannot want.
struct WordCheck {
    std::string_view addresses; ///< of words that it looks at, separated by blanks; "": any
    enum class Blocks : std::uint8_t {
        all,        ///< that hold one of the addresses
        repeated,   ///< in which one of the addresses stands more than once
        conflicting ///< in which one modal group is set more than once
    } blocks;
    void (*check)(const queries::WordsOfBlock&, Reporter&);
};

} // namespace maclint
