//! The search for lines that hold a code.
#include "analyzer/program/lines_with.hpp"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

LetterCodes codes_of(char letter, std::initializer_list<double> codes) {
    LetterCodes wanted{letter, {}};
    for (const double code : codes) wanted.codes.add(code);
    return wanted;
}

std::vector<std::string> lines_with(const std::vector<LetterCodes>& wanted, std::string_view text,
                                    Span part) {
    std::vector<std::string> lines;
    for_each_line_with(wanted, text, part, [&](Span line) {
        lines.emplace_back(text.substr(line.begin, line.end - line.begin));
    });
    return lines;
}

std::vector<std::string> lines_with(const std::vector<LetterCodes>& wanted, std::string_view text) {
    return lines_with(wanted, text, {0, static_cast<Offset>(text.size())});
}

TEST(LinesWith, AreThoseThatHoldOneOfTheCodes) {
    const std::vector wanted = {codes_of('G', {1, 54.1}), codes_of('M', {8})};
    EXPECT_THAT(lines_with(wanted, "X1\nG1 X2\nG2 X3\nM8\nY4 G01\nm08 g3\nM9"),
                ElementsAre("G1 X2", "M8", "Y4 G01", "m08 g3"));
    EXPECT_THAT(lines_with(wanted, "G1\rG2\r\nG54.2\nG 1\nG\t1"), ElementsAre("G1", "G54.2", "G 1", "G\t1"));
    EXPECT_THAT(lines_with(wanted, "M8 G1 G1\nM8"), ElementsAre("M8 G1 G1", "M8")) << "a line once";
    EXPECT_THAT(lines_with(wanted, "G10\nG11\nG100\nG\nM\nX1G"), IsEmpty());
    EXPECT_THAT(lines_with({}, "G1"), IsEmpty());
}

TEST(LinesWith, HoldNumbersOfAThousandAndMoreWhereThoseAreMeant) {
    std::vector wanted = {codes_of('G', {5})};
    EXPECT_THAT(lines_with(wanted, "G1000\nG99999999999999999999"), IsEmpty());
    wanted.front().codes.add_beyond();
    EXPECT_THAT(lines_with(wanted, "G1000\nG999\nG99999999999999999999"),
                ElementsAre("G1000", "G99999999999999999999"));
}

TEST(LinesWith, LieInThePart) {
    const std::vector wanted = {codes_of('G', {1, 2, 3, 4})};
    EXPECT_THAT(lines_with(wanted, "G1;G2 X1\nG3\nG4", {3, 11}), ElementsAre("G2 X1", "G3"));
    EXPECT_THAT(lines_with(wanted, "G1\nX1\nG2", {3, 5}), IsEmpty());
}

} // namespace
} // namespace maclint
