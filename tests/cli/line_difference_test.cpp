//! What differs between two texts, line by line.
#include "cli/gate/line_difference.hpp"

#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(LineDifference, TellsLinesThatWereChangedOrAdded) {
    EXPECT_THAT(changed_lines("O1\nG0\nX1\nM30\n", "O1\nG1\nG2\nX1\nM9\nM30\n"),
                ElementsAre(LineRange{2, 3}, LineRange{5, 5}));
    EXPECT_THAT(changed_lines("", "O1\nM30\n"), ElementsAre(LineRange{1, 2}));
    EXPECT_THAT(changed_lines("O1\n", "O1\nM30"), ElementsAre(LineRange{2, 2}));
}

TEST(LineDifference, TellsTheLinesAroundWhatIsGone) {
    EXPECT_THAT(changed_lines("O1\nX1\nX2\nX3\nX4\nM30\n", "X1\nX2\nX4\nM30\n"),
                ElementsAre(LineRange{1, 1}, LineRange{2, 3}));
    EXPECT_THAT(changed_lines("O1\nM30\n", "O1\n"), ElementsAre(LineRange{1, 2}));
    EXPECT_THAT(changed_lines("O1\nM30\n", ""), ElementsAre(LineRange{1, 1}));
}

TEST(LineDifference, EndsOfLinesAreNone) {
    EXPECT_THAT(changed_lines("O1\nX1\n\nM30\n", "O1\r\nX1\r\n\r\nM30\r\n"), IsEmpty());
    EXPECT_THAT(changed_lines("O1\r\nM30\r\n", "O1\nM30"), IsEmpty());
    EXPECT_THAT(changed_lines("O1\r\nX1\r\nM30\r\n", "O1\nX2\nM30\n"), ElementsAre(LineRange{2, 2}));
    EXPECT_THAT(changed_lines("O1\nM30\n", "O1\nM30\r"), ElementsAre(LineRange{2, 2})); // it ends no line
    EXPECT_THAT(changed_lines("O1\rX1\rM30\n", "O1\rX2\rM30\n"), ElementsAre(LineRange{1, 1}));
}

TEST(LineDifference, FindsWhatStayedAmongLinesThatRepeat) {
    std::string before;
    for (int i = 0; i < 2000; ++i) before += "G0 Z5\nG1 Z-1\nM8\n";
    std::string after = before;
    after.insert(before.size() / 2, "G0 Z5\nG4\nM8\n");
    after.insert(0, "G4\n");
    const auto ranges = changed_lines(before, after); // G4 is line 3003, and one line on each side is new
    ASSERT_EQ(ranges.size(), 2U);
    EXPECT_EQ(ranges[0], (LineRange{1, 1}));
    EXPECT_EQ(ranges[1].last - ranges[1].first, 2U);
    EXPECT_LE(ranges[1].first, 3003U);
    EXPECT_GE(ranges[1].last, 3003U);
}

TEST(LineDifference, FindsBlocksThatStayedBetweenManyThatChanged) {
    std::string before;
    std::string after;
    for (int i = 0; i < 1000; ++i) {
        before += "N" + std::to_string(i) + " X1\nG0 Z5\nX" + std::to_string(i % 7) + "\n";
        after += "N" + std::to_string(i + 5000) + " X1\nG0 Z5\nX" + std::to_string(i % 7) + "\n";
    }
    const auto ranges = changed_lines(before, after);
    ASSERT_EQ(ranges.size(), 1000U);
    for (std::uint32_t i = 0; i < ranges.size(); ++i) EXPECT_EQ(ranges[i], (LineRange{3 * i + 1, 3 * i + 1}));
}

/// Lines that stand once keep their order as far as that goes, however many differ.
TEST(LineDifference, OfTwoBlocksThatChangedPlacesOneStays) {
    std::string first;
    std::string second;
    for (int i = 0; i < 2000; ++i) first += "N" + std::to_string(i) + " X1\n";
    for (int i = 2000; i < 3000; ++i) second += "N" + std::to_string(i) + " X1\n";
    EXPECT_THAT(changed_lines(first + second, second + first),
                ElementsAre(LineRange{1, 1000}, LineRange{3000, 3001}));
}

using Lines = std::vector<std::string>;

std::string text_of(const Lines& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

class Dice {
  public:
    explicit Dice(unsigned seed)
        : random_(seed) {}
    std::size_t below(std::size_t end) { return random_() % end; }
    std::string line(std::size_t kinds) { return {static_cast<char>('A' + below(kinds))}; }

  private:
    std::mt19937 random_;
};

/// The lines that no range names, from 0.
std::vector<std::size_t> unchanged(const std::vector<LineRange>& ranges, std::size_t lines) {
    std::vector<bool> changed(lines + 2);
    for (const auto& [first, last] : ranges)
        for (std::size_t line = first; line <= last; ++line) changed.at(line) = true;
    std::vector<std::size_t> rest;
    for (std::size_t line = 0; line < lines; ++line)
        if (!changed[line + 1]) rest.push_back(line);
    return rest;
}

/// Nothing is lost: what is called unchanged stands in the older text, in that order, and a difference is
/// never passed over.
void expect_sound(const Lines& before, const Lines& after) {
    const auto ranges = changed_lines(text_of(before), text_of(after));
    EXPECT_EQ(ranges.empty(), before == after);
    auto at = before.begin();
    for (const std::size_t line : unchanged(ranges, after.size())) {
        at = std::find(at, before.end(), after[line]);
        ASSERT_NE(at, before.end()) << text_of(before) << "against\n" << text_of(after);
        ++at;
    }
    EXPECT_TRUE(std::ranges::is_sorted(ranges, {}, &LineRange::first));
    EXPECT_TRUE(std::ranges::is_sorted(ranges, {}, &LineRange::last));
}

TEST(LineDifference, NeverCallsALineUnchangedThatIsNot) {
    Dice dice(7);
    for (int round = 0; round < 20'000; ++round) {
        const std::size_t kinds = 1 + dice.below(8);
        Lines before(dice.below(14));
        for (std::string& line : before) line = dice.line(kinds);
        Lines after = before;
        for (std::size_t edits = dice.below(6); edits > 0; --edits) {
            if (!after.empty() && dice.below(2) == 0) {
                after.erase(after.begin() + static_cast<std::ptrdiff_t>(dice.below(after.size())));
            } else {
                after.insert(after.begin() + static_cast<std::ptrdiff_t>(dice.below(after.size() + 1)),
                             dice.line(kinds));
            }
        }
        expect_sound(before, after);
    }
}

/// Longer than one round of the search, and than the work that is allowed.
TEST(LineDifference, IsSoundWhereABoundIsMet) {
    Dice dice(11);
    for (const std::size_t length : {3'000U, 60'000U}) {
        Lines before(length);
        Lines after(length);
        for (std::string& line : before) line = dice.line(20);
        for (std::string& line : after) line = dice.line(20);
        expect_sound(before, after);
    }
}

} // namespace
} // namespace maclint::cli
