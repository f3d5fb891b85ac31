//! The search for lines that hold a letter.
#include "analyzer/program/lines_with.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> lines_with(std::string_view letters, std::string_view text, Span part) {
    std::vector<std::string> lines;
    for_each_line_with(letters, text, part, [&](Span line) {
        lines.emplace_back(text.substr(line.begin, line.end - line.begin));
    });
    return lines;
}

std::vector<std::string> lines_with(std::string_view letters, std::string_view text) {
    return lines_with(letters, text, {0, static_cast<Offset>(text.size())});
}

TEST(LinesWith, AreThoseThatHoldOneOfTheLetters) {
    EXPECT_THAT(lines_with("GM", "X1\nG1 X2\nX3\nM8\nY4 G0"), ElementsAre("G1 X2", "M8", "Y4 G0"));
    EXPECT_THAT(lines_with("G", "G1\rG2\r\nX1"), ElementsAre("G1", "G2"));
    EXPECT_THAT(lines_with("GM", "M3 G1 G2\nM4"), ElementsAre("M3 G1 G2", "M4")) << "a line once";
    EXPECT_THAT(lines_with("GM", "X1\nX2"), IsEmpty());
    EXPECT_THAT(lines_with("", "G1"), IsEmpty());
}

TEST(LinesWith, LieInThePart) {
    EXPECT_THAT(lines_with("G", "G1;G2 X1\nG3\nG4", {3, 11}), ElementsAre("G2 X1", "G3"));
    EXPECT_THAT(lines_with("G", "G1\nX1\nG2", {3, 5}), IsEmpty());
}

} // namespace
} // namespace maclint
