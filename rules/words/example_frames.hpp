//! What stands around the block of an example, a row a language and machine.
#pragma once

#include "analyzer/program/tables.hpp"
#include "rules/words/rule_row.hpp"

#include <array>
#include <string_view>

namespace maclint {

/// How a language writes the program around a block.
struct ExampleFrame {
    std::string_view language;
    Machine machine;
    char code_system; ///< of a lathe's G codes; 0: there are none
    std::string_view head, tail;
    std::string_view main_section;       ///< that a program must have; empty: there are no sections
    std::string_view with_point;         ///< addresses whose numbers have one
    std::string_view straight;           ///< words of a move
    std::string_view arc;                ///< a block that is none, without the end of its line
    std::string_view first_section = {}; ///< of a whole program
};
inline constexpr std::array example_frames = {
    ExampleFrame{"fanuc", Machine::mill, 0, "O1(EXAMPLE)\nG17 G90 G54 G0 X0 Y0\n", "G40 G80\nM30\n", "",
                 "A B C F I J K Q R U V W X Y Z", " X10. Y20.", "G2 X20. Y30. R10."},
    ExampleFrame{"fanuc", Machine::lathe, 'A', "O1(EXAMPLE)\nG99\nG0 G80 X100. Z100.\n", "M30\n", "",
                 "A B C F I J K R U V W X Y Z", " X10. Z20.", "G2 X20. Z30. R10."},
    ExampleFrame{"fanuc", Machine::lathe, 'B', "O1(EXAMPLE)\nG95\nG0 G80 X100. Z100.\n", "M30\n", "",
                 "A B C F I J K R U V W X Y Z", " X10. Z20.", "G2 X20. Z30. R10."},
    ExampleFrame{"fanuc", Machine::lathe, 'C', "O1(EXAMPLE)\nG95\nG0 G80 X100. Z100.\n", "M30\n", "",
                 "A B C F I J K R U V W X Y Z", " X10. Z20.", "G2 X20. Z30. R10."},
    ExampleFrame{"dinplus", Machine::lathe, 0, "MACHINING\n", "END\n", "MACHINING", "", " X50 Z5",
                 "G2 X60 Z0 R5", "PROGRAM_HEAD"},
};

/// Of the language, and of the machine where that makes a difference.
[[nodiscard]] const ExampleFrame& frame_of(const ControlModel& control);
/// The first control that the row is for; rather one with a name of its own.
[[nodiscard]] const ControlModel& example_control(const RowForCode& row);

} // namespace maclint
