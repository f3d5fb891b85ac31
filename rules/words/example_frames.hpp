//! What stands around the block of an example, a row a language.
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace maclint {

/// How a language writes the program around a block.
struct ExampleFrame {
    std::string_view language;
    std::string_view head, tail;
    std::string_view main_section; ///< that a program must have; empty: there are no sections
    std::string_view with_point;   ///< addresses whose numbers have one
    std::string_view straight;     ///< words of a move
    std::string_view arc;          ///< a block that is none, without the end of its line
};
inline constexpr std::array example_frames = {
    ExampleFrame{"fanuc", "O1(EXAMPLE)\nG90 G54 G0 X0 Y0\n", "G40 G80\nM30\n", "",
                 "A B C F I J K Q R U V W X Y Z", " X10. Y20.", "G2 X20. Y30. R10."},
    ExampleFrame{"dinplus", "MACHINING\n", "END\n", "MACHINING", "", " X50 Z5", "G2 X60 Z0 R5"},
};

[[nodiscard]] constexpr const ExampleFrame& frame_of(std::string_view language) {
    return *std::ranges::find(example_frames, language, &ExampleFrame::language);
}

} // namespace maclint
