//! Rules about look-ahead: MAC605.
#include "tests/rules/raised.hpp"

#include <gmock/gmock.h>

namespace maclint {
namespace {

using test::lines_raised;
using test::messages_raised;
using test::path_raised;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Lines on which MAC605 speaks of O9001 with these blocks, the first of which is on line 2.
std::vector<std::uint32_t> early(const std::string& blocks) {
    return lines_raised("MAC605", "O9001\n" + blocks + "M99\n");
}

TEST(PositionReadAhead, BecomesAnOffset) {
    EXPECT_THAT(early("G1X5.F100.\n#5221=#5021\n"), ElementsAre(3));
    EXPECT_THAT(early("G1X5.F100.\n#1=#5041-#2\n#3=#1/2\n#[5220+#4]=#3\n"), ElementsAre(3));
    EXPECT_THAT(early("G1X#1F100.\nIF[#2GT5]GOTO1\n#3=1\nN1#2501=-#5041\n"), ElementsAre(5));
    EXPECT_THAT(path_raised("MAC605", "O9001\nG1X5.F100.\n#5221=#5021\nM99\n"), ElementsAre(2, 3));
    EXPECT_THAT(messages_raised("MAC605", "O9001\nG1X5.F100.\n#1=#5021\n#5221=#1\nM99\n"),
                ElementsAre(AllOf(HasSubstr("'#5021'"), HasSubstr("line 2"), HasSubstr("'#5221=#1'"))));
}

TEST(PositionReadAhead, IsCompared) {
    EXPECT_THAT(early("G1X5.F100.\nIF[#5041GT#1]GOTO9\nN9\n"), ElementsAre(3));
    EXPECT_THAT(early("G1X5.F100.\n#1=#5041\nIF[ABS[#1-#2]GT0.1]THEN#3000=1\n"), ElementsAre(3));
}

TEST(PositionReadAhead, IsKeptOrMovedToOnly) {
    EXPECT_THAT(early("G1X5.F100.\n#1=#5041\nG0X#1\n"), IsEmpty());
    EXPECT_THAT(early("G1X5.F100.\n#501=#5041\n#101=#5041\n#[100+#2]=#5041\n"), IsEmpty());
}

TEST(PositionReadAhead, ComesAfterAStopOfLookAhead) {
    for (const std::string stop :
         {"G53", "G4X1.", "M00", "M01", "G31X1.", "G10L2P1X0", "M98P9002", "M19", "M160"})
        EXPECT_THAT(early("G1X5.F100.\n" + stop + "\n#5221=#5021\n"), IsEmpty()) << stop;
    EXPECT_THAT(early("G1X5.F100.M80\n#5221=#5021\n"), IsEmpty()); // M80 may be one of parameters 3411-3432
    EXPECT_THAT(early("G53\nG1X5.F100.\n#5221=#5021\n"), ElementsAre(4));
    EXPECT_THAT(early("M8\nG1X5.F100.\n#5221=#5021\n"), ElementsAre(4));
    EXPECT_THAT(early("G1X5.F100.\nM8\nF50.\n#5221=#5021\n"), IsEmpty());
    EXPECT_THAT(early("G103P1\nG1X5.F100.\n#5221=#5021\n"), IsEmpty());
    EXPECT_THAT(early("G103\nG1X5.F100.\n#5221=#5021\n"), ElementsAre(4));
    // The jump past the dwell is never taken.
    EXPECT_THAT(early("#4=5\nG1X5.F100.\nIF[#4NE5]GOTO1\nG4X1.\nN1#5221=#5021\n"), IsEmpty());
}

TEST(PositionReadAhead, IsNoMoveOfTheCallerAndNoEndOfABlock) {
    EXPECT_THAT(early("#5221=#5021\nG1X5.F100.\n"), IsEmpty());
    EXPECT_THAT(early("G1X5.F100.\n#5221=#5001\n#5222=#5061\n"), IsEmpty());
}

TEST(PositionReadAhead, IsOfAnAxisThatMoves) {
    // Touched in X, lifted in Z: X stands still.
    EXPECT_THAT(early("G91G31X-20.F100.\nG90G0Z100.\n#5221=#5021\n"), IsEmpty());
    EXPECT_THAT(early("G91G31X-20.F100.\nG90G0Z100.\n#5223=#5023\n"), ElementsAre(4));
    EXPECT_THAT(early("G91G31Z-20.F100.\nG90G0X100.\n#5223=#5023\n"), IsEmpty());
    // The second axis is Y, or Z on a lathe.
    EXPECT_THAT(early("G91G31Y-20.F100.\nG90G0X100.\n#5222=#5022\n"), IsEmpty());
    EXPECT_THAT(early("G91G31X-20.F100.\nG90G0Y100.\n#5222=#5022\n"), ElementsAre(4));
    EXPECT_THAT(early("G91G31X-20.F100.\nG90G0Z100.\n#5222=#5022\n"), ElementsAre(4));
    EXPECT_THAT(early("G91G31X-20.F100.\nG91G0Z#1\n#5221=#5021\n"), IsEmpty());
    EXPECT_THAT(early("G91G0X#2\nG91G0Z#1\n#5221=#5021\n"), ElementsAre(4)); // two moves may wait
    EXPECT_THAT(early("G0U#2\n#5221=#5021\n"), ElementsAre(3));
    EXPECT_THAT(early("G0X#2\n#5226=#5026\n"), ElementsAre(3)); // which axis the sixth is nobody knows
}

TEST(PositionReadAhead, IsFollowedThroughTwelveOperations) {
    const auto after = [](int operations, const std::string& operation) {
        std::string text = "G1X5.F100.\n#1=#5041\n";
        for (int i = 0; i < operations; ++i) text += operation + "\n";
        return early(text + "#5221=#1\n").size();
    };
    for (const std::string operation : {"#1=#1/2", "#1=#1-#2", "#1=2*#1", "#1=#2-#1"}) {
        EXPECT_EQ(after(1, operation), 1U) << operation;
        EXPECT_EQ(after(12, operation), 1U) << operation;
        EXPECT_EQ(after(13, operation), 0U) << operation;
    }
}

TEST(PositionReadAhead, IsNoDifferenceOfTwoCoordinateSystems) {
    EXPECT_THAT(early("G1X5.F100.\n#5221=#5021-#5041+#1\n"), IsEmpty());
    EXPECT_THAT(early("G1X5.Y5.F100.\n#5221=#5021-#5042\n"), ElementsAre(3, 3));
}

TEST(PositionReadAhead, InALoopFollowsTheMoveOfTheRoundBefore) {
    EXPECT_THAT(early("#1=0\nWHILE[#1LT5]DO1\n#5221=#5021\nG1X#1F100.\n#1=#1+1\nEND1\n"), ElementsAre(4));
}

} // namespace
} // namespace maclint
