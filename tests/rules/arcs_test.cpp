//! Rules on the geometry of moves: MAC522, MAC558, MAC532.
#include "tests/rules/raised.hpp"
#include "tests/support/linted.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::judged;
using test::lines_raised;
using test::messages_raised;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// ---- MAC522

/// Behind a first line that leaves the tool at X10. Y30.
std::vector<std::string> arc(const std::string& block, const std::string& modes = "G17 G21 G90") {
    return messages_raised("MAC522", "O9522\n" + modes + " G0 X10. Y30.\n" + block + "\nM30\n");
}

/// Messages about a lathe's arc, behind a block that leaves the tool at X20. Z0.
std::vector<std::string> on_a_lathe(const std::string& block) {
    cli::Overrides overrides;
    overrides.control = "fanuc-16i-lathe";
    overrides.select = {"MAC522"};
    std::vector<std::string> messages;
    const std::string text = "O9522\nG21G97S500M3\nT0101\nG0X20.Z0\n" + block + "\nG28U0W0\nM30\n";
    for (const auto& [finding, suppressed] : test::lint_texts({{"O1.nc", text}}, overrides).findings)
        messages.push_back(finding.message());
    return messages;
}

TEST(ImpossibleArc, HasItsEndsAtDifferentDistancesFromItsCentre) {
    EXPECT_THAT(arc("G2 X20. Y40. I12. J0 F200."),
                ElementsAre(AllOf(HasSubstr("begins 12 from its centre"), HasSubstr("10.198"))));
    EXPECT_THAT(arc("G2 X20. Y40. I10. J0 F200."), IsEmpty());
    EXPECT_THAT(arc("G91 G2 X10. Y10. I12. J0 F200."), ElementsAre(HasSubstr("10.198")));
    EXPECT_THAT(arc("G3 I12. J1. Z-2. F200."), IsEmpty()) << "a full circle";
    EXPECT_THAT(arc("G2 X20. Y40. I12. J0 F200.", "G17 G21"), IsEmpty()) << "from where is not known";
}

TEST(ImpossibleArc, HasItsOnlyCentreInAnotherPlaneWhateverTheValue) {
    EXPECT_THAT(arc("G3 K-#31 F200."), ElementsAre(HasSubstr("Centre of another plane: 'K-#31'")));
    EXPECT_THAT(arc("G3 I-#31 F200."), IsEmpty());
    EXPECT_THAT(arc("G3 I-#31 K#6 F200."), IsEmpty()) << "#6 may be vacant";
    EXPECT_THAT(arc("G3 K-#31 F200.", "G18 G21 G90"), IsEmpty());
}

TEST(ImpossibleArc, MayBeOffByWhatThreeDecimalsLose) {
    EXPECT_THAT(arc("G2 X20. Y40. I10.015 J0 F200."), IsEmpty());
    EXPECT_THAT(arc("G2 X20. Y40. I10.05 J0 F200."), ElementsAre(HasSubstr("10.05")));
    EXPECT_THAT(arc("G2 X20. Y40. I10.1 J0 F200."), IsEmpty()) << "rounded to tenths";
    EXPECT_THAT(arc("G2 X20.0000 Y40. I10.0015 J0 F20.", "G17 G20 G90"), ElementsAre(HasSubstr("Radii")));
    EXPECT_THAT(arc("G2 X20.0000 Y40. I10.0004 J0 F20.", "G17 G20 G90"), IsEmpty());
}

TEST(ImpossibleArc, IsNotClaimedOfNumbersThatMeanSomethingElse) {
    EXPECT_THAT(arc("G2 X20 Y40. I12. J0 F200."), IsEmpty()) << "perhaps thousandths";
    EXPECT_THAT(arc("G2 X20. Y40. I#1 J0 F200."), IsEmpty());
    EXPECT_THAT(arc("G2 X20. Y40. I12. J0 A5. F200."), IsEmpty());
    EXPECT_THAT(arc("G16\nG2 X20. Y40. I12. J0 F200."), IsEmpty());
    EXPECT_THAT(arc("G2 X20. Y40. I20. J30. F200."), IsEmpty()) << "a centre from the zero";
}

/// Four of them in a program that has no other arcs.
TEST(ImpossibleArc, IsNotClaimedWhereTheProgramWritesItsArcsSo) {
    const std::string odd = "G2 X20. Y40. I12. J0 F200.\nG1 X10. Y30.\n";
    const std::string even = "G2 X20. Y40. I10. J0 F200.\nG1 X10. Y30.\n";
    EXPECT_EQ(arc(odd + odd + odd).size(), 3U);
    EXPECT_THAT(arc(odd + odd + odd + odd), IsEmpty());
    std::string many;
    for (int i = 0; i < 12; ++i) many += even;
    EXPECT_EQ(arc(odd + odd + odd + odd + many).size(), 4U);
}

TEST(ImpossibleArc, HasARadiusThatDoesNotReach) {
    EXPECT_THAT(arc("G2 X30. Y50. R1. F200."),
                ElementsAre(AllOf(HasSubstr("28.2843"), HasSubstr("reaches 2 at most"))));
    EXPECT_THAT(arc("G2 X30. Y30. R10. F200."), IsEmpty());
    EXPECT_THAT(arc("G2 X30. Y30. R-10. F200."), IsEmpty());
    EXPECT_THAT(arc("G2 X30. Y30. R0 F200."), ElementsAre(HasSubstr("Radius of 0")));
    EXPECT_THAT(arc("G2 X30. Y30. I0 J0 F200."), ElementsAre(HasSubstr("Centre at the start")));
    EXPECT_THAT(arc("G2 X30. Y50. R1. I10. F200."), IsEmpty()) << "MAC575 speaks of the two";
}

TEST(ImpossibleArc, HasItsCentreInItsPlane) {
    EXPECT_THAT(arc("G2 X20. Y30. I5. K2. F200."),
                ElementsAre(AllOf(HasSubstr("'K2.'"), HasSubstr("G17"), HasSubstr("I and J"))));
    EXPECT_THAT(arc("G2 X20. Y30. I5. K0 F200."), IsEmpty());
    EXPECT_THAT(arc("G2 X20. Y30. Z-1. I5. J0 K2. F200."), IsEmpty()) << "the pitch of a helix";
    EXPECT_THAT(arc("G2 X20. Z-10. I10. K-10. F200.\nG3 X30. Z0 I10. K10."), testing::SizeIs(1))
        << "G18 is missing, and that once";
    EXPECT_THAT(arc("G18 G2 X20. Z-10. I10. K0 F200.", "G90 G21 G0 Z0 G17"), IsEmpty());
    EXPECT_THAT(arc("G2 X20. Y30. I5. K2. F200.", "G90 G21"), ElementsAre(HasSubstr("plane of X and Y")));
    EXPECT_THAT(arc("G2 X20. Z-10. I6. K2. F200.", "G90 G21"), ElementsAre(HasSubstr("plane of X and Y")));
    EXPECT_THAT(messages_raised("MAC522", "O9522\nG90 G21 G0 X10. Z0\nG2 X20. Z-10. I6. K2. F200.\nM30\n"),
                IsEmpty())
        << "perhaps a lathe";
    EXPECT_THAT(messages_raised("MAC522", "O9522\nG90 G21 G0 X10. Y0 Z0\nG2 X20. Z-10. I6. K2. F200.\nM99\n"),
                IsEmpty())
        << "who calls it may have said G18";
}

TEST(ImpossibleArc, OfALatheCountsXInDiameters) {
    EXPECT_THAT(on_a_lathe("G3X30.Z-5.R5.F0.1"), IsEmpty());
    EXPECT_THAT(on_a_lathe("G3X30.Z-5.I0K-5.F0.1"), IsEmpty());
    EXPECT_THAT(on_a_lathe("G3U10.W-5.I0K-5.F0.1"), IsEmpty());
    EXPECT_THAT(on_a_lathe("G3X30.Z-5.I0K-7.F0.1"), ElementsAre(HasSubstr("begins 7 ")));
    EXPECT_THAT(on_a_lathe("G3U10.W-5.R3.F0.1"), ElementsAre(HasSubstr("reaches 6 at most")));
    EXPECT_THAT(on_a_lathe("G3X30.Z-10.I0K-10.F0.1"), IsEmpty()) << "X in radii";
}

TEST(ImpossibleArc, NamesTheAlarm) {
    EXPECT_THAT(arc("G2 X20. Y40. I12. J0 F200."), ElementsAre(HasSubstr("020")));
    EXPECT_THAT(arc("G2 X20. Y30. I5. K2. F200."), ElementsAre(HasSubstr("021")));
    EXPECT_THAT(arc("G2 X30. Y50. R1. F200."), ElementsAre(testing::Not(HasSubstr("alarm"))));
}

// ---- MAC558

TEST(FullCircleByRadius, EndsWhereItBegins) {
    const auto circle = [](const std::string& block) {
        return lines_raised("MAC558", "O9558\nG17 G21 G90 G0 X10. Y30.\n" + block + "\nM30\n");
    };
    EXPECT_THAT(circle("G2 X10. Y30. R5. F200."), ElementsAre(3));
    EXPECT_THAT(circle("G2 Y30. R5. F200."), ElementsAre(3));
    EXPECT_THAT(circle("G91 G2 X0 Y0 Z-1. R5. F200."), ElementsAre(3));
    EXPECT_THAT(circle("G2 X10. Y30. I5. F200."), IsEmpty());
    EXPECT_THAT(circle("G2 X10. Y32. R5. F200."), IsEmpty());
    EXPECT_THAT(circle("G2 X#1 Y30. R5. F200."), IsEmpty());
}

// ---- MAC532

TEST(CycleDepth, LiesBelowTheLevelFromWhichTheCycleFeeds) {
    const auto cycle = [](const std::string& block) {
        return lines_raised("MAC532", "O9532\nG17 G21 G90 G54 G0 X10. Y30.\n" + block + "\nG80\nM30\n");
    };
    EXPECT_THAT(cycle("G99 G81 Z20. R2. F100."), ElementsAre(3));
    EXPECT_THAT(cycle("G99 G81 Z2. R2. F100."), ElementsAre(3));
    EXPECT_THAT(cycle("G99 G81 Z-20. R2. F100."), IsEmpty());
    EXPECT_THAT(cycle("G99 G81 Z20 R2. F100."), IsEmpty()) << "perhaps thousandths";
    EXPECT_THAT(cycle("G98 G87 Z5. R-20. Q1. F100."), IsEmpty());
    EXPECT_THAT(cycle("G91 G99 G81 Z5. R-20. F100."), ElementsAre(3));
    EXPECT_THAT(cycle("G91 G99 G81 Z-5. R-20. F100."), IsEmpty());
    EXPECT_THAT(cycle("G18 G99 G81 Z5. R2. Y-20. F100."), IsEmpty());
}

TEST(ArcsOfAPocket, MayCountTheirCentresFromThePart) {
    const std::string begins = "O9522\nG17 G90 G21 G0 X10. Y0\nG1 Y30. F200.\nG2 X20. Y40. ";
    EXPECT_THAT(messages_raised("MAC522", begins + "I20. J30.\nG2 X30. Y30. I20. J30.\nM30\n"), IsEmpty());
    EXPECT_THAT(messages_raised("MAC522", begins + "I12. J0\nM30\n"),
                ElementsAre(HasSubstr("begins 12 from its")));
    EXPECT_THAT(
        messages_raised("MAC522", begins + "I10. J0\nG2 X30. Y30. R10.\nG2 X37.07 Y27.07 R-10.\nM30\n"),
        IsEmpty());
}

// ---- MAC522, of sizes that are not known

std::vector<std::string> arc_of_sizes(const std::string& blocks) {
    return messages_raised("MAC522", "O9522\nG91 G1 X-20. F200.\n" + blocks + "\nG90\nM99\n");
}

TEST(ArcOfSizes, IsNoneForTwoThatDiffer) {
    EXPECT_THAT(arc_of_sizes("G3 X#1 Y#1 I0 J#18"), ElementsAre(HasSubstr("where #1 and #18 are equal")));
    EXPECT_THAT(arc_of_sizes("#20=#7\nG2 X#20 Y-#20 J-#18"), ElementsAre(HasSubstr("only where")));
    EXPECT_THAT(arc_of_sizes("G3 X#1 Y#1 I0 J#1"), IsEmpty());
    EXPECT_THAT(arc_of_sizes("G3 X-#18 Y#18 I-#18 J0"), IsEmpty());
    EXPECT_THAT(arc_of_sizes("G3 I-#18"), IsEmpty());
    // Four sizes may fit each other.
    EXPECT_THAT(arc_of_sizes("G3 X#24 Y#25 I#4 J#5"), IsEmpty());
    EXPECT_THAT(arc_of_sizes("#5=SQRT[#18*#18-#1*#1]\nG3 X[#18-#1] Y#5 I-#1 J#5"), IsEmpty());
}

TEST(ArcOfSizes, IsNoneForAnyNumber) {
    EXPECT_THAT(arc_of_sizes("#20=#7/2\nG3 X-#20 Y#20 I-#7 J0"),
                ElementsAre(AllOf(HasSubstr("No circle"), HasSubstr("with #7 of 3.7"))));
    EXPECT_THAT(arc_of_sizes("#20=#7/2\nG3 X-#20 Y#20 I-#20 J0"), IsEmpty());
    EXPECT_THAT(arc_of_sizes("#20=5.\nG3 X-#20 Y#20 I-[#20+1.] J0"), ElementsAre(HasSubstr("No circle")));
    EXPECT_THAT(judged("MAC522", "O9522\nG91 G1 X-20. F200.\nG3 X#1 Y#1 I0 J#18\nG90\nM99\n"),
                ElementsAre("warning 3"));
}

TEST(ArcOfSizes, CountsFromTheTool) {
    EXPECT_THAT(messages_raised("MAC522", "O9522\nG90 G1 X-20. F200.\nG3 X#1 Y#1 I0 J#18\nM99\n"), IsEmpty());
    EXPECT_THAT(arc_of_sizes("G18 G3 X#1 Y#1 I0 J#18"), ElementsAre(HasSubstr("Centre of another plane")));
    EXPECT_THAT(arc_of_sizes("G3 X#1 Y#1 I0 J#5041"), IsEmpty());
}

} // namespace
} // namespace maclint
