//! Rules on what a lathe is doing: speeds, feeds, offsets, turret and profiles, beyond what their examples
//! show.
#include "tests/rules/raised.hpp"
#include "tests/support/linted.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Message and line of what a rule finds in the program: "thread 4".
std::vector<std::string> told(const std::string& rule, const std::string& text,
                              const std::string& control = "fanuc-16i-lathe") {
    cli::Overrides overrides;
    overrides.control = control;
    overrides.select = {rule};
    const auto result = lint_texts({{"O1.nc", text}}, std::move(overrides));
    std::vector<std::string> all;
    for (const auto& evaluated : result.findings) {
        const Finding& finding = evaluated.finding;
        all.push_back(std::string(finding.message_id) + " " +
                      std::to_string(finding.source->position(finding.span.begin).line));
    }
    return all;
}

/// The same of a main program, from its fourth line on.
std::vector<std::string> turned(const std::string& rule, const std::string& blocks,
                                const std::string& control = "fanuc-16i-lathe") {
    return told(rule, "O1\nG21 G40\nT0101\n" + blocks + "M30\n", control);
}

// ---- MAC570

TEST(SurfaceSpeed, WantsAClampBeforeTheFirstMoveInX) {
    EXPECT_THAT(turned("MAC570", "G96 S200 M3\nG0 Z5.\nX54.\nG1 X0 F0.1\n"), ElementsAre("no_clamp 4"));
    EXPECT_THAT(turned("MAC570", "G96 S200 M3\nG0 Z5.\nG50 S2000\nX54.\n"), IsEmpty());
    EXPECT_THAT(turned("MAC570", "G50 X200. Z100.\nG96 S200 M3\nG0 X54.\n"), ElementsAre("no_clamp 5"))
        << "G50 without S sets the position";
    EXPECT_THAT(turned("MAC570", "G97 S200 M3\nG0 X54.\n"), IsEmpty());
}

TEST(SurfaceSpeed, MayBeClampedByACalledProgram) {
    EXPECT_THAT(turned("MAC570", "M98 P77\nG96 S200 M3\nG0 X54.\n"), IsEmpty()) << "nobody knows it";
    const std::string call = "M98 P2\nG96 S200 M3\nG0 X54.\nM30\n";
    EXPECT_THAT(turned("MAC570", call + "O2\nG50 S2000\nM99\n"), IsEmpty());
    EXPECT_THAT(turned("MAC570", call + "O2\nM8\nM99\n"), ElementsAre("no_clamp 5"));
}

TEST(SurfaceSpeed, IsToldOnceForAllTools) {
    EXPECT_THAT(turned("MAC570", "G96 S200 M3\nG0 X54.\nT0202\nG97 S800\nG96 S90\nG0 X30.\n"),
                ElementsAre("no_clamp 4"));
}

// ---- MAC525

TEST(ThreadsUnderSurfaceSpeed, AreToldOnceForOneG96) {
    const std::string passes = "G0 X29.\nG32 Z-30. F2.\nG0 X32.\nZ5.\nX28.\nG32 Z-30.\nG0 X32.\n";
    EXPECT_THAT(turned("MAC525", "G96 S60 M3\n" + passes), ElementsAre("thread 6"));
    EXPECT_THAT(turned("MAC525", "G96 S60 M3\n" + passes + "T0202\nG96 S60\nG0 X32.\n" + passes),
                ElementsAre("thread 6"));
    EXPECT_THAT(turned("MAC525", "G96 S60 M3\n" + passes + "G97 S500\nG96 S60\n" + passes),
                ElementsAre("thread 6", "thread 15"));
    EXPECT_THAT(turned("MAC525", "G96 S60 M3\nG0 X40.\nG97 S400\n" + passes), IsEmpty());
}

TEST(ThreadsUnderSurfaceSpeed, HaveTheCodesOfTheSystem) {
    EXPECT_THAT(turned("MAC525", "G96 S60 M3\nG90 G0 X32. Z5.\nG78 X29. Z-20. F2.\n", "fanuc-16i-lathe-b"),
                ElementsAre("thread 6"));
    EXPECT_THAT(turned("MAC525", "G96 S60 M3\nG90 G0 X32. Z5.\nG77 X29. Z-20. F.2\n", "fanuc-16i-lathe-b"),
                IsEmpty());
    EXPECT_THAT(turned("MAC525", "G96 S60 M3\nG90 G0 X32. Z5.\nG21 X29. Z-20. F2.\n", "fanuc-16i-lathe-c"),
                ElementsAre("thread 6"));
}

TEST(HolesUnderSurfaceSpeed, AreToldOnTheCentreOnly) {
    EXPECT_THAT(turned("MAC525", "G96 S60 M3\nG0 X0 Z5.\nG83 Z-20. R-2. F0.1\nG80\n"),
                ElementsAre("centre 6"));
    EXPECT_THAT(turned("MAC525", "G96 S60 M3\nG0 X0 Z5.\nG74 R1.\nG74 Z-20. Q5000 F0.1\n"),
                ElementsAre("centre 7"));
    EXPECT_THAT(turned("MAC525", "G96 S60 M3\nG0 X40. Z5. C0\nG83 Z-20. R-2. F0.1\nC90.\nG80\n"), IsEmpty());
    EXPECT_THAT(turned("MAC525", "G96 S60 M3\nG28 U0\nG0 Z5.\nG83 Z-20. R-2. F0.1\nG80\n"), IsEmpty())
        << "nobody knows X";
    EXPECT_THAT(turned("MAC525", "G96 S60 M3\nG0 X40. Z0\nG1 X0 F0.1\n"), IsEmpty()) << "facing";
}

TEST(HolesUnderSurfaceSpeed, AreDrilledWhereARoughingCycleLeavesTheTool) {
    const std::string roughing = "G71 U2. R1.\nG71 P10 Q20 U0.4 W0.1 F0.2\nN10 G0 X20.\nG1 Z-9.\nN20 X0\n";
    EXPECT_THAT(turned("MAC525", "G96 S60 M3\nG0 X52. Z5.\n" + roughing + "G83 Z-20. R-2. F0.1\nG80\n"),
                IsEmpty());
}

// ---- MAC526

TEST(FeedsOfTheOtherMode, AreHeldAgainstTheLimitsOfTheUnit) {
    EXPECT_THAT(turned("MAC526", "G99\nG1 X20. F9.\n"), IsEmpty()) << "an approach";
    EXPECT_THAT(turned("MAC526", "G99\nG1 X20. F10.\n"), ElementsAre("per_revolution 5"));
    EXPECT_THAT(turned("MAC526", "G98\nG1 X20. F1.\n"), IsEmpty());
    EXPECT_THAT(turned("MAC526", "G98\nG1 X20. F0.9\n"), ElementsAre("per_minute 5"));
    EXPECT_THAT(turned("MAC526", "G20 G99\nG1 X2. F.5\n"), ElementsAre("per_revolution 5"));
    EXPECT_THAT(turned("MAC526", "G20 G98\nG1 X2. F.05\n"), IsEmpty()) << "a hand lathe";
    EXPECT_THAT(turned("MAC526", "G20 G98\nG1 X2. F.01\n"), ElementsAre("per_minute 5"));
}

TEST(FeedsOfTheOtherMode, CountInMillimetresWhereTheLatheIsAtSuchAPlace) {
    const std::string head = "O1\nT0101\nG98\n";
    EXPECT_THAT(told("MAC526", head + "G0 X54. Z0.\nG1 X30. F0.2\nM30\n"), ElementsAre("per_minute 5"));
    EXPECT_THAT(told("MAC526", head + "G0 X2.5 Z0.\nG1 X1. F0.2\nM30\n"), IsEmpty());
}

TEST(FeedsOfTheOtherMode, AreToldOnceForOneMode) {
    EXPECT_THAT(turned("MAC526", "G98\nG1 X20. F0.2\nZ-9. F0.1\nX30. F0.3\n"), ElementsAre("per_minute 5"));
    EXPECT_THAT(turned("MAC526", "G99\nG1 X20. F80.\nZ-9. F0.1\nX30. F60.\n"),
                ElementsAre("per_revolution 5", "per_revolution 7"));
}

TEST(FeedsOfTheOtherMode, AreNoLeads) {
    EXPECT_THAT(turned("MAC526", "G99\nG0 X40. Z20.\nG32 Z-20. F12.\nG0 X60.\n"), IsEmpty());
    EXPECT_THAT(turned("MAC526", "G99\nG0 X40. Z20.\nG76 P010060 Q100\nG76 X30. Z-20. P9000 Q500 F12.\n"),
                IsEmpty());
}

// ---- MAC568

TEST(ToolOffsets, AreMissedWhereTheToolHasOneElsewhere) {
    EXPECT_THAT(turned("MAC568", "G0 X50. Z2.\nG1 Z-9. F0.1\nG0 X99. T0100\nG1 Z-20.\nX50.\n"),
                ElementsAre("taken_back 7"));
    EXPECT_THAT(turned("MAC568", "G0 X50. Z2.\nG1 Z-9. F0.1\nG0 X99. T0100\nG0 Z20.\nT0101\nG1 X50.\n"),
                IsEmpty());
    EXPECT_THAT(turned("MAC568", "G0 X50. Z2.\nG1 Z-9. F0.1\nG0 X99.\nT0000\nG1 X50.\n"), IsEmpty());
}

// ---- MAC521

TEST(Compensation, IsOffBeforeAnotherToolOfATurretComes) {
    const std::string cut = "G0 X50. Z2.\nG42 G1 Z-9. F0.1\nG0 X99. Z50.\n";
    EXPECT_THAT(turned("MAC521", cut + "T0202\n"), ElementsAre("change 7"));
    EXPECT_THAT(turned("MAC521", cut + "T0100\nG40 G0 X120.\nT0202\n"), IsEmpty());
}

// ---- MAC534

TEST(Turrets, MayTurnWhereTheProgramAlwaysTurnsThem) {
    const std::string at_work = "G0 X50. Z2.\nG1 Z-9. F0.1\nG0 X54.\nT0202\nG0 X40.\nG1 Z-5.\nG0 X54. Z2.\n";
    EXPECT_THAT(turned("MAC534", at_work + "T0303\n"), IsEmpty());
    EXPECT_THAT(turned("MAC534", at_work + "G0 X200. Z100.\nT0303\n"), ElementsAre("at_work 7"));
    EXPECT_THAT(turned("MAC534", "G0 X50. Z2.\nG1 Z-9. F0.1\nG0 X200.\nT0202\nG1 Z-5.\nG0 Z99.\nT0303\n"),
                IsEmpty())
        << "far beside the work";
}

// ---- MAC533

/// Of a roughing cycle from X52, Z2 on.
std::vector<std::string> roughed(const std::string& profile, const std::string& allowance = "U0.4 W0.1") {
    return turned("MAC533", "G0 X52. Z2.\nG71 U2. R1.\nG71 P10 Q20 " + allowance + " F0.2\n" + profile);
}

TEST(RoughedProfiles, AreSilentWhereTheyCanBeTurned) {
    EXPECT_THAT(roughed("N10 G0 X20.\nG1 Z-9.\nX40. Z-20.\nN20 X52.\n"), IsEmpty());
    EXPECT_THAT(roughed("N10 G0 X20.\nG1 Z-9.\nX40. Z-20.\nX52.\nN20 G0 G40 Z2.\n"), IsEmpty())
        << "the last block goes away";
    EXPECT_THAT(roughed("N10 G0 X20. Z2.\nG1 Z-9.\nX40.\nX35. Z-20.\nN20 X52.\n"), IsEmpty())
        << "both axes in the first block: pockets are taken";
    EXPECT_THAT(roughed("N10 G0 X20.\nG1 Z-9.\nX#1\nX30.\nN20 X52.\n"), IsEmpty()) << "nobody knows X";
    EXPECT_THAT(roughed("N10 G0 X20.\nG1 Z-9.\nX40. ,A150.\nX30.\nN20 X52.\n"), IsEmpty());
}

TEST(RoughedProfiles, DoNotGoBackInEitherAxis) {
    EXPECT_THAT(roughed("N10 G0 X20.\nG1 Z-9.\nX40.\nX35. Z-20.\nN20 X52.\n"), ElementsAre("back 10"));
    EXPECT_THAT(roughed("N10 G0 X20.\nG1 Z-9.\nX40.\nZ-5.\nX44.\nZ-30.\nN20 X52.\n"), ElementsAre("back 10"));
}

TEST(RoughedProfiles, BeginOutsideTheStock) {
    EXPECT_THAT(roughed("N10 G0 X20.\nG1 Z-9.\nX60.\nZ-20.\nN20 X62.\n"), ElementsAre("inside 6"));
    EXPECT_THAT(roughed("N10 G0 X20.\nG1 Z-9.\nX50.\nZ-20.\nN20 X54.\n"), IsEmpty()) << "by little";
    EXPECT_THAT(roughed("N10 G0 X20.\nG1 Z9.\nX40. Z-9.\nN20 X52.\n"), ElementsAre("inside 6")) << "in Z";
}

TEST(RoughedProfiles, LeaveTheirAllowanceOnTheSideOfTheWork) {
    EXPECT_THAT(roughed("N10 G0 X20.\nG1 Z-9.\nX40.\nN20 X52.\n", "U-0.4 W0.1"), ElementsAre("side 6"));
    const std::string bore = "G0 X17. Z2.\nG71 U1. R1.\nG71 P10 Q20 U0.4 W0.1 F0.2\n";
    EXPECT_THAT(turned("MAC533", bore + "N10 G0 X30.\nG1 Z-9.\nX22.\nZ-20.\nN20 X18.\n"),
                ElementsAre("side 6"));
}

// ---- MAC501

TEST(ModesOfALathe, AreToldWhereACallLeavesThemAndTheCallerCuts) {
    const std::string before = "G99 G97 S500 M3\nG0 X50. Z2.\nG1 Z-9. F0.1\nM98 P2\n";
    const std::string minute = "M30\nO2\nG98\nG1 Z5. F800.\nM99\n", speed = "M30\nO2\nG96 S90\nG0 Z5.\nM99\n";
    EXPECT_THAT(turned("MAC501", before + "G1 X20. F0.2\n" + minute), ElementsAre("by-call 7"));
    EXPECT_THAT(turned("MAC501", before + "G99 G1 X20. F0.2\n" + minute), IsEmpty());
    EXPECT_THAT(turned("MAC501", before + "G1 X20. F120.\n" + minute), IsEmpty()) << "it is written for it";
    EXPECT_THAT(turned("MAC501", before + "G0 X20.\n" + minute), IsEmpty()) << "no cut follows";
    EXPECT_THAT(turned("MAC501", before + "S800\nG1 X20.\n" + speed), ElementsAre("by-call 7"));
    EXPECT_THAT(turned("MAC501", before + "G97 S800\nG1 X20.\n" + speed), IsEmpty());
    EXPECT_THAT(turned("MAC501", before + "M98 P2\nG1 X20.\n" + speed), ElementsAre("by-call 7"))
        << "the call that leaves it first";
}

} // namespace
} // namespace maclint::test
