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
struct RowOfBlock;
struct MachineStep;

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

/// Looks at one block after another with what the machine is doing there: rules/machine_check.hpp. All such
/// checks share a pass over the blocks of a program that paths lead to.
struct MachineCheck {
    void (*check)(const MachineStep&, Reporter&);
    /// Whether it is shown also what they do for the numbers that single calls pass.
    bool with_numbers_of_calls = false;
};

/// What a row of the table of words says of the words that it names, in a block that holds its code.
enum class RowStatement : std::uint8_t {
    needs,      ///< one of them stands there
    takes_not,  ///< none of them does
    takes_only, ///< no others do, but those that another code of the block takes
    excludes,   ///< none of them stands beside one of the others
    only_with,  ///< they stand beside one of the others only
    values,     ///< their values lie within the bounds, or in the list
    whole,      ///< their values are written without a point
    digits,     ///< they have at most so many digits before the point
    at_most,    ///< at most so many of them stand there
    until,      ///< none but they stand in the blocks up to one of the other codes
    encloses,   ///< two of them number the first and the last block of a part of the program
    alone,      ///< no word but them stands beside the code
    apart,      ///< the code stands beside none of the other codes
    precedes,   ///< the next block holds one of the other codes
    refused,    ///< the code does not stand at all where the row holds: under another code, in a section
    names_none, ///< they number no block with one of the other codes
    left_on,    ///< what the code switches on is off again when the program ends
};

/// Looks at the rows that say the same, one at a time, in the blocks where it holds;
/// rules/words/word_row.hpp.
struct RowCheck {
    RowStatement says;
    void (*check)(const RowOfBlock&, Reporter&);
};

} // namespace maclint
