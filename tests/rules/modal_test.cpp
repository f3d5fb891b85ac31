//! Rules about modal state that a program leaves behind: MAC501-MAC506, MAC515, MAC517, MAC518; and about its
//! codes that serve as numbers: MAC574.
#include "tests/rules/raised.hpp"
#include "tests/support/analysed.hpp"

#include <gmock/gmock.h>

namespace maclint {
namespace {

using test::judged;
using test::lines_raised;
using test::messages_raised;
using test::path_raised;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(HandedModes, AreNotReportedOfAProgramThatDoesNothingElse) {
    EXPECT_THAT(lines_raised("MAC502", "O9700\n#1=ATAN[#4]/[#5]\nG68X0Y0R#1\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC502", "O9700\nG68X0Y0R#1\nX1\nM99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC502", "O9700\nG68X0Y0R#1\nM99\nO1\nM98P9700\nG0X1\nM30\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC502", "O9700\nG68X0Y0R#1\nIF[#1EQ1]GOTO9\nG69\nN9M99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC501", "O9700\nG18\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC501", "O9700\nG18\nM6T#20\nM99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC501", "O9700\nG18\n#101=5\nM99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC515", "O9700\n#3003=1\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC515", "O9700\n#3003=1\nM6T20\nM99\n"), ElementsAre(2));
}

TEST(HandedModes, AreNotReportedWhereEveryCallerCancelsThem) {
    const auto raised = [](const std::string& after_call) {
        return lines_raised("MAC502", "O8\nG1G41D1X20.F300\nM99\nO9\nG40X0\nM99\nO7\nX9\nM99\nO1\nM98P8\n" +
                                          after_call + "M30\n");
    };
    EXPECT_THAT(raised("G1Y20.F300\nG40X0\n"), IsEmpty());
    EXPECT_THAT(raised("G1Y20.F300\nM98P7\nM98P9\n"), IsEmpty());
    EXPECT_THAT(raised("G1Y20.F300\nIF[#500EQ1]GOTO5\nG40X0\nM30\nN5G40\n"), IsEmpty());
    EXPECT_THAT(raised("G1Y20.F300\n"), ElementsAre(2));
    EXPECT_THAT(raised("G1Y20.F300\nIF[#500EQ1]GOTO5\nG40X0\nN5\n"), ElementsAre(2)); // on some paths
    EXPECT_THAT(raised("G1Y20.F300\nG40G80G49\n"), ElementsAre(2));   // what every tool begins with
    EXPECT_THAT(raised("G1Y20.F300\nG42X9\nG40\n"), ElementsAre(2));  // the caller takes it for cancelled
    EXPECT_THAT(raised("G1Y20.F300\nG65P77\nG40\n"), ElementsAre(2)); // nobody knows what that does
    std::string far;
    for (int i = 0; i < 1900; ++i) far += "IF[#500EQ1]THEN#2=1\n";
    EXPECT_THAT(raised("G1Y20.F300\n" + far + "G40X0\n"), ElementsAre(2));
    EXPECT_THAT(raised("G1Y20.F300\n" + far.substr(0, far.size() / 4) + "G40X0\n"), IsEmpty());
    EXPECT_THAT(raised("G1Y20.F300\nG40X0\nM30\nO2\nM98P8\nX1\n"), ElementsAre(2)); // another caller does not
}

/// The rules that speak of a state which the program keeps, with their lines.
std::string of_kept(const std::string& body) {
    std::string found;
    for (const char* code : {"MAC501", "MAC503", "MAC504", "MAC507", "MAC519"})
        for (const std::uint32_t line : lines_raised(code, "O9001\n" + body))
            found += (found.empty() ? "" : " ") + std::string(code) + ":" + std::to_string(line);
    return found;
}

TEST(KeptState, IsPutBackOnEveryPathOrReportedWithoutAnyCaller) {
    const auto behind = [](const std::string& rest) { return of_kept("#31=#4003\nG90X5.\n" + rest); };
    EXPECT_EQ(behind("G#31\nM99\n"), "");
    EXPECT_EQ(behind("IF[#1EQ1.]GOTO9\nG#31\nN9M99\n"), "MAC501:3");
    EXPECT_EQ(behind("IF[#1EQ1.]GOTO8\nM99\nN8G#31\nM99\n"), "MAC501:3");
    EXPECT_EQ(behind("/G#31\nM99\n"), "MAC501:3");
    EXPECT_EQ(behind("M99\n"), "MAC507:3");
    EXPECT_EQ(behind("G#31\nM30\n"), ""); // its exits are no returns
    // Nothing is changed on the path without the word.
    EXPECT_EQ(of_kept("#31=#4003\nIF[#1EQ1.]GOTO9\nG90X5.\nG#31\nN9M99\n"), "");
}

TEST(KeptState, MayBeAnyGroupThatACallerHas) {
    const auto kept = [](const std::string& variable, const std::string& change, const std::string& back) {
        const std::string begin = "#31=" + variable + "\n" + change + "\n";
        return of_kept(begin + "IF[#1EQ1.]GOTO9\n" + back + "\nN9M99\n") + " " + of_kept(begin + "M99\n");
    };
    EXPECT_EQ(kept("#4001", "G0X5.", "G#31"), "MAC504:3 MAC507:3");
    EXPECT_EQ(kept("#4002", "G18X5.", "G#31"), "MAC501:3 MAC501:3 MAC507:3"); // MAC507 yields
    EXPECT_EQ(kept("#4002", "G17X5.", "G#31"), "MAC501:3 MAC507:3");
    EXPECT_EQ(kept("#4006", "G20X5.", "G#31"), "MAC501:3 MAC507:3");
    EXPECT_EQ(kept("#4010", "G98X5.", "G#31"), "MAC501:3 MAC507:3");
    EXPECT_EQ(kept("#4008", "G49X5.", "G#31"), "MAC519:3 MAC507:3");
    EXPECT_EQ(kept("#4109", "F50", "F#31"), "MAC503:3 MAC507:3");
    EXPECT_EQ(kept("#4119", "S50", "S#31"), "MAC503:3 MAC507:3");
}

TEST(KeptState, IsNoneThatIsReadForSomethingElseOrThatOthersMayPutBack) {
    EXPECT_EQ(of_kept("#31=#4006\nIF[#31EQ20]THEN#1=#1*25.4\nG21X#1\nM99\n"), "");
    EXPECT_EQ(of_kept("#500=#4003\nG90X5.\nM99\n"), "");
    EXPECT_EQ(of_kept("#31=#4003\nG90X5.\nG65P9002A#31\nM99\n"), "");
    EXPECT_EQ(of_kept("#31=#4003\n#500=#31\nG90X5.\nM99\n"), "");
    // Saved after the change it is the program's own, which MAC517 tells.
    EXPECT_EQ(of_kept("G90X5.\n#31=#4003\nG91Y5.\nG#31\nM99\n"), "");
}

TEST(Restore, OfAnotherGroupThanWasChangedIsReported) {
    const auto said = [](const std::string& body) { return judged("MAC505", "O9001\n" + body + "M99\n"); };
    EXPECT_THAT(said("#31=#4003\n#32=#4003\nG91G1X5.F9\nG#31\nG#32\n"), ElementsAre("warning 3"));
    EXPECT_THAT(said("#31=#4001\n#32=#4003\nG91G1X5.F9\nG#31\nG#32\n"), IsEmpty());
    EXPECT_THAT(said("#31=#4003\nG91X5.\nG90G#31X6.\n"), ElementsAre("warning 4"));
    EXPECT_THAT(said("#31=#4003\nG1X5.F9\nG#31\n"), ElementsAre("warning 4"));
    EXPECT_THAT(said("#31=#4003\nG91G1X5.F9\nG#31\n"), IsEmpty());
    EXPECT_THAT(said("#31=#4003\nG65P9002\nG1X5.F9\nG#31\n"), IsEmpty()); // it may change the mode
    EXPECT_THAT(said("#31=#4003\nG#5X5.\nG1X5.F9\nG#31\n"), IsEmpty());
    EXPECT_THAT(said("#31=#4001\nG90X5.\nG#31\n"), IsEmpty()); // a customary code may be left
    // In one variable after the other, on different paths.
    EXPECT_THAT(said("IF[#1EQ1]GOTO5\n#31=#4003\nG91X5.\nG#31\nM99\nN5#32=#4003\nG91X6.\nG#32\n"), IsEmpty());
}

TEST(HandedModes, AreAskedOfComputedCallsInTheFile) {
    const auto raised = [](const std::string& after_call) {
        return lines_raised("MAC501", "O1\nG90G54\nM98P[7100+#501]\n" + after_call +
                                          "M30\nO7100\nG91G1X2.F300\nM99\nO7101\nG91G1Y4.F300\nM99\n");
    };
    EXPECT_THAT(raised("G90G0Z2.\n"), IsEmpty());
    EXPECT_THAT(raised("G0Z2.\n"), ElementsAre(7, 10));
    EXPECT_THAT(lines_raised("MAC502", "O1\nM98P[9700+#501]\nX1\nM30\nO9701\nG68X0Y0R#1\nM99\n"),
                ElementsAre(6));
    // Not of calls of other numbers.
    EXPECT_THAT(lines_raised("MAC501", "O1\nM98P[8000+#501]\nG90G0Z2.\nM30\nO7100\nG91G1X2.F300\nM99\n"),
                ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC209", "O1\n#10=5\nM98P[7000+#501]\nM30\nO7001\nG0X#10\nM99\n"), IsEmpty());
}

TEST(ModalState, LeftAtAnUnusualCodeIsReportedWhereItWasSetLast) {
    EXPECT_THAT(lines_raised("MAC501", "O9001\nG91 G0 X1\nG91 G0 X2\nM99\n"), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC501", "O9001\n#33=#1\nG91\nG0 X1 Y2\nG0 X3\nM99\n"), ElementsAre(3));
}

TEST(ModalState, OfAMainProgramIsItsOwnAffair) {
    EXPECT_THAT(lines_raised("MAC501", "O1\nG91 G28 Z0\nM30\n"), IsEmpty());
}

TEST(ModalState, PutBackFromAVariableOrByItsCustomIsFine) {
    EXPECT_THAT(lines_raised("MAC501", "O9001\n#33=#4003\nG91 G0 X1\nG#33\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC501", "O9001\nG91 G0 X1\nG90\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC501", "O9001\n#33=#4003\n#32=#33\nG91 G0 X1\nG#32\nM99\n"), IsEmpty());
}

TEST(ModalState, PutBackByATestOfTheSavedCodeIsFine) {
    EXPECT_THAT(lines_raised("MAC501", "O9001\n#33=#4003\nG91 G0 X1\nIF[#33EQ91]GOTO9\nG90\nN9 M99\n"),
                IsEmpty());
}

TEST(ModalState, PutBackOnSomeWaysOnlySaysSo) {
    EXPECT_THAT(messages_raised("MAC501", "O9001\n#33=#4003\nG91 G0 X1\nIF[#1EQ1]GOTO9\nG#33\nN9 M99\n"),
                ElementsAre(HasSubstr("on some of the paths")));
}

TEST(ModalState, SwitchedOnAndOffUnderOneConditionIsNotLeft) {
    const auto pair = [](const std::string& off) {
        return "O9001\nIF[#7EQ1]GOTO1\nG91\nG41D1\nN1G1X1.F#9\n" + off + "N2M99\n";
    };
    for (const char* rule : {"MAC501", "MAC502"}) {
        EXPECT_THAT(lines_raised(rule, pair("IF[#7EQ1]GOTO2\nG40G90\n")), IsEmpty()) << rule;
        EXPECT_THAT(lines_raised(rule, pair("IF[#7NE1]THENGOTO3\nGOTO2\nN3G40G90\n")), IsEmpty()) << rule;
        EXPECT_EQ(lines_raised(rule, pair("IF[#7EQ2]GOTO2\nG40G90\n")).size(), 1) << rule;
        EXPECT_EQ(lines_raised(rule, pair("#7=#8\nIF[#7EQ1]GOTO2\nG40G90\n")).size(), 1) << rule;
    }
    EXPECT_THAT(lines_raised("MAC502", "O9001\nG1F#9\n/G41D1X1.\nX2.\n/G40X3.\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC502", "O9001\nG1F#9\n/G41D1X1.\nX2.\n/2G40X3.\nM99\n"), ElementsAre(3));
}

TEST(ModalState, ThatNoSearchCanFollowThroughALoopIsLeft) {
    // The head of the loop sets it, and the rounds come over it.
    EXPECT_THAT(lines_raised("MAC501", "O9001\n#24=0\nN13G91X1.\n#24=#24+1\nIF[#24LT3]GOTO13\nM99\n"),
                ElementsAre(3));
    // A block of the loop may put it back, and may be passed by in each round.
    EXPECT_THAT(lines_raised("MAC501", "O9001\n#1=0\nG91\nWHILE[#1LT5]DO1\nIF[#7NE1]GOTO2\nG90\nN2G0X1.\n"
                                       "#1=#1+1\nEND1\nM99\n"),
                ElementsAre(3));
}

TEST(ModalState, ThatACalledProgramOnlyMayPutBackIsLeft) {
    const auto raised = [](const std::string& call, const std::string& callee) {
        return lines_raised("MAC501", "O9001\nG91\n" + call + "G0X1.\nM99\nO9002\n" + callee + "N1M99\n");
    };
    EXPECT_THAT(raised("M98P9002\n", "IF[#500EQ1]GOTO1\nG90\n"), ElementsAre(2));
    EXPECT_THAT(raised("M98P9002L#7\n", "G90\n"), ElementsAre(2));
    EXPECT_THAT(raised("M98P9002\n", "G90\n"), IsEmpty());
    // Paired: what the caller sets, the called program puts back under the same condition.
    EXPECT_THAT(lines_raised("MAC501", "O9001\nIF[#500EQ1]GOTO1\nG91\nN1G0X1.\nIF[#500EQ1]GOTO2\nM98P9002\n"
                                       "N2M99\nO9002\nG90\nM99\n"),
                IsEmpty());
}

TEST(ModalState, LeftByACalledProgramIsThatPrograms) {
    EXPECT_THAT(lines_raised("MAC501", "O9001\nG65 P9002\nM99\nO9002\nG91\nG0 X1\nM99\n"), ElementsAre(5));
}

TEST(ModalState, ThatAnUnknownProgramMayHaveChangedIsLeftAlone) {
    EXPECT_THAT(lines_raised("MAC501", "O9001\nG91 G0 X1\nG65 P9999\nM99\n"), IsEmpty());
}

TEST(ModalState, ThatEveryCallerSetsAgainBeforeItMovesHarmsNobody) {
    const std::string sub = "O9001\nG91 G0 Z#26\nM99\n";
    EXPECT_THAT(lines_raised("MAC501", "O1\nG65 P9001 Z5.\nG90 G0 X1\nM30\n" + sub), IsEmpty());
    EXPECT_THAT(lines_raised("MAC501", "O1\nG65 P9001 Z5.\nG0 X1\nM30\n" + sub), ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC501", "O1\nG65 P9001 Z5.\nM30\n" + sub), IsEmpty());
    // One of two callers moves so.
    EXPECT_THAT(
        lines_raised("MAC501", "O1\nG65 P9001 Z5.\nG90 G0 X1\nM30\nO2\nG65 P9001 Z5.\nX1\nM30\n" + sub),
        ElementsAre(10));
    // Only on one path does the caller set it.
    EXPECT_THAT(lines_raised("MAC501", "O1\nG65 P9001 Z5.\nIF[#100EQ1]GOTO9\nG90\nN9 G0 X1\nM30\n" + sub),
                ElementsAre(8));
}

TEST(ModalState, ThatACallerLeavesToItsOwnCallersMattersThere) {
    const std::string subs = "O9001\nG65 P9002 Z#26\nM99\nO9002\nG91 G0 Z#26\nM99\n";
    EXPECT_THAT(lines_raised("MAC501", subs), ElementsAre(5)); // it is unknown who calls O9001
    EXPECT_THAT(lines_raised("MAC501", "O1\nG65 P9001 Z1.\nG90 X1\nM30\n" + subs), IsEmpty());
    EXPECT_THAT(lines_raised("MAC501", "O1\nG65 P9001 Z1.\nG0 X1\nM30\n" + subs), ElementsAre(9));
}

TEST(ModalState, ThatTheNextCalledProgramSetsAgainHarmsNobody) {
    const std::string sub = "O9001\nG91 G0 Z#26\nM99\n";
    EXPECT_THAT(lines_raised("MAC501",
                             "O1\nG65 P9001 Z5.\nG65 P9002\nG0 X1\nM30\n" + sub + "O9002\nG90 G0 X0\nM99\n"),
                IsEmpty());
    EXPECT_THAT(
        lines_raised("MAC501", "O1\nG65 P9001 Z5.\nG65 P9002\nG90 X1\nM30\n" + sub + "O9002\nG0 X0\nM99\n"),
        ElementsAre(7));
}

TEST(Feed, MattersToMovesThatHaveOne) {
    const std::string sub = "O9001\nG1 Z#26 F#9\nG0 Z5.\nM99\n";
    EXPECT_THAT(lines_raised("MAC503", "O1\nG65 P9001 Z1. F9.\nX1\nG1 X2 F100\nM30\n" + sub), IsEmpty());
    EXPECT_THAT(lines_raised("MAC503", "O1\nG65 P9001 Z1. F9.\nG28 X0\nG1 X2 F100\nM30\n" + sub), IsEmpty());
    EXPECT_THAT(lines_raised("MAC503", "O1\nG65 P9001 Z1. F9.\nG1 X2\nM30\n" + sub), ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC503", "O1\nG65 P9001 Z1. F9.\nX#100\nG1 X2\nM30\n" + sub), ElementsAre(7));
}

TEST(Feed, ThatAMacroInBetweenSetsIsNotTheFirstOnes) {
    EXPECT_THAT(lines_raised("MAC503",
                             "O1\nG65 P9001 F100.\nG65 P9002 F300.\nG1 X5.\nM30\nO9001\nG1 X1. F#9\nM99\n"
                             "O9002\nG1 F#9 X2.\nM99\n"),
                ElementsAre(10));
}

TEST(Feed, OfAWayThatTheCallerCannotTakeHarmsNobody) {
    // Where the macro is called #100 is 1, and where it is moved without a feed it is not.
    EXPECT_THAT(lines_raised("MAC503",
                             "O1\nIF[#100NE1]GOTO5\nG65 P9001 F100.\nN5\nIF[#100NE1]GOTO6\nG1 X1 F50\nGOTO7\n"
                             "N6 G1 X2\nN7 M30\nO9001\nG1 X1. F#9\nM99\n"),
                IsEmpty());
}

TEST(Feed, OfTheCallFromWhichTheWayIsOpenMatters) {
    // Two calls lead to line 9; the path from the later one is closed by its own test, the other one is open.
    EXPECT_THAT(
        lines_raised("MAC503",
                     "O1\nG65 P9001 F100.\nIF[#100NE1]GOTO5\nG65 P9001 F100.\nN5\n"
                     "IF[#100NE1]GOTO6\nG1 X1 F50\nGOTO7\nN6 G1 X2\nN7 M30\nO9001\nG1 X1. F#9\nM99\n"),
        ElementsAre(12));
}

TEST(Speed, OfASpindleThatStandsMattersToNobody) {
    const std::string sub = "O9001\nG1 X1. F100 S#19 M3\nM5\nS200\nM99\n";
    EXPECT_THAT(lines_raised("MAC503", "O1\nG65 P9001 S9.\nG1 X1 F5\nS500 M3\nG1 X2\nM30\n" + sub),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC503", "O1\nG65 P9001 S9.\nM3\nG1 X1 F5\nM30\n" + sub), ElementsAre(9));
}

/// Four lines of a caller that moves under whatever feed O9001 leaves, and with its spindle.
const std::string relying = "O1\nG65 P9001 Z1. S9.\nG1 X9.\nM30\n";

TEST(Feed, SetByManyWordsFromOneArgumentIsStillThatOne) {
    std::string text = relying + "O9001\n";
    for (int i = 0; i < 20; ++i) text += "G1 X" + std::to_string(i) + " F#9\n";
    EXPECT_THAT(lines_raised("MAC503", text + "M99\n"), ElementsAre(25));
}

TEST(Compensation, LeftActiveIsReportedAtEveryEnd) {
    EXPECT_THAT(lines_raised("MAC502", "O1\nG41 D1 G1 X5 F100\nG1 X9\nM30\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC502", "O9001\nG52 X#1\nG0 X1\nM99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC502", "O9001\nG52 X#1\nG0 X1\nG52 X0\nM99\n"), IsEmpty());
}

TEST(Compensation, OfACannedCycleEndsWithAMainProgram) {
    EXPECT_THAT(lines_raised("MAC502", "O1\nG81 X1 Z-5 R2 F100\nX#100\nM30\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC502", "O9001\nG81 X1 Z-5 R2 F100\nX#100\nM99\n"), ElementsAre(2));
}

TEST(Compensation, OfTheCallerIsNotTheMacros) {
    EXPECT_THAT(lines_raised("MAC502", "O9001\nG0 X#1\nM99\n"), IsEmpty());
}

TEST(Feed, OfAMacroIsPutBackOrReported) {
    EXPECT_THAT(lines_raised("MAC503", relying + "O9001\nG1 Z#26 F#9\nM99\n"), ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC503", "O9001\n#33=#4109\nG1 Z#26 F#9\nF#33\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC503", "O9001\nG1 X10 F100\nM99\n"),
                IsEmpty()); // no macro: it reads no argument
}

TEST(Feed, SpeedThatTheCallerPassesIsWhatItWants) {
    EXPECT_THAT(lines_raised("MAC503", "O9001\nS#19 M3\nG0 X#24\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC503", relying + "O9001\nS[#19*2] M3\nG0 X#24\nM99\n"), ElementsAre(6));
}

TEST(Restore, FromAnotherKindOfWordIsReported) {
    EXPECT_THAT(lines_raised("MAC505", "O9001\n#3=#4019\nG1 X1 F#9\nF#3\nM99\n"), ElementsAre(4));
    EXPECT_THAT(lines_raised("MAC505", "O9001\n#3=#4107\nG1 X1 F#9\nF#3\nM99\n"), ElementsAre(4));
    EXPECT_THAT(lines_raised("MAC505", "O9001\n#3=#4109\nG1 X1 F#9\nG#3\nM99\n"), ElementsAre(4));
    // What the interrupted program had: the body of an interruption puts it back.
    EXPECT_THAT(lines_raised("MAC505", "O9001\n#3=#4403\n#4=#4509\nG91 G1 X1 F#9\nG#3 F#4\nM99\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC505", "O9001\n#4=#4519\nG1 X1 F#9\nF#4\nM99\n"), ElementsAre(4));
    EXPECT_THAT(lines_raised("MAC505", "O9001\n#3=#4109\n#4=#4003\nG91 G1 X1 F#9\nG#4 F#3\nM99\n"),
                IsEmpty());
}

TEST(Restore, FromAWrongVariableIsNotAlsoAFeedThatIsNotPutBack) {
    EXPECT_THAT(lines_raised("MAC503", "O9001\n#3=#4019\nG1 X#24 F#9\nF#3\nM99\n"), IsEmpty());
}

TEST(SavedValue, OverwrittenBeforeItIsPutBackIsLost) {
    EXPECT_THAT(lines_raised("MAC506", "O9001\n#1=#4001\nG1 X1\n#1=#1+#2\nG#1\nM99\n"), ElementsAre(4));
    EXPECT_THAT(lines_raised("MAC506", "O9001\n#1=#4109\nG1 X1 F50\n#1=7\nF#1\nM99\n"), ElementsAre(4));
    // In a loop, where it holds the saved value only the first time.
    EXPECT_THAT(lines_raised("MAC506",
                             "O9001\n#29=#4003\n#27=1\nWHILE[#27LE#100]DO1\nG91X1.\n#29=#27+1\n#27=#27+1\n"
                             "END1\nG#29\nM99\n"),
                ElementsAre(6));
}

TEST(SavedValue, IsFollowedFromWhereItWasSaved) {
    EXPECT_THAT(path_raised("MAC506", "O9001\nIF[#9EQ1]GOTO10\nG0 X5\nN10 #1=#4003\nG91 X1\n"
                                      "#1=#1+#2\nG#1\nM99\n"),
                ElementsAre(4, 6));
}

TEST(PlainBlock, IsNotQuotedWhereOneOfItsWordsIsMeant) {
    EXPECT_THAT(messages_raised("MAC503", relying + "O9001\nG0 X#24\nG1 X5. Y6. F200.5\nM99\n"),
                ElementsAre(HasSubstr("'F200.5'")));
    EXPECT_THAT(messages_raised("MAC517", "O9001\nG0 X#24\nG91 G1 X5.\n#1=#4003\nG0 X1.\nG#1\nM99\n"),
                ElementsAre(HasSubstr("after 'G91' has")));
}

TEST(SavedValue, MayServeForAFeedComputedFromIt) {
    EXPECT_THAT(lines_raised("MAC506", "O9001\n#1=#4109\n#1=#1*0.5\nG1 X1 F#1\nM99\n"), IsEmpty());
}

TEST(SavedValue, PutBackBeforeTheVariableIsUsedAgainIsFine) {
    EXPECT_THAT(lines_raised("MAC506", "O9001\n#1=#4109\nG1 X1 F50\nF#1\n#1=7\nG1 X2 F#1\nM99\n"), IsEmpty());
}

TEST(SavedValue, MayBeLeftOutOnAPath) {
    const std::string skipped = "O9001\nIF[#1000EQ1]GOTO5\n";
    EXPECT_THAT(lines_raised("MAC505", skipped + "#3=#4019\nN5 G1 X1 F#9\nF#3\nM99\n"), ElementsAre(5));
    // Which of two is meant nobody knows.
    EXPECT_THAT(lines_raised("MAC505", skipped + "#3=#4019\nGOTO6\nN5 #3=100.\nN6 G1 X1 F#9\nF#3\nM99\n"),
                IsEmpty());
}

TEST(SavedValue, SavedAfterTheChangeIsTheProgramsOwn) {
    EXPECT_THAT(lines_raised("MAC517", "O9001\nG91\n#1=#4003\nG0 X1\nG#1\nM99\n"), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC501", "O9001\nG91\n#1=#4003\nG0 X1\nG#1\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC517", "O9001\n#2=#4003\nG91\n#1=#4003\nG90 G0 X1\nG#1\nG#2\nM99\n"),
                IsEmpty());
}

TEST(Suppression, IsSetBackOnEveryWay) {
    EXPECT_THAT(lines_raised("MAC515", "O9001\n#3003=1\nG0 X#24\nM99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC515", "O1\n#3004=7\nG0 X1\nM30\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC515", "O9001\n#3003=1\nG0 X#24\n#3003=0\nM99\n"), IsEmpty());
    EXPECT_THAT(messages_raised("MAC515", "O9001\n#3003=1\nIF[#1EQ1]GOTO9\n#3003=0\nN9 M99\n"),
                ElementsAre(HasSubstr("on some of the paths")));
}

TEST(ForcedState, IsANoteUnlessTheStateWasSaved) {
    EXPECT_THAT(lines_raised("MAC518", "O9001\nG90 G0 X1\nM99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC518", "O9001\n#1=#4003\nG90 G0 X1\nIF[#1EQ90]GOTO9\nG91\nN9 M99\n"),
                IsEmpty());
}

TEST(ModalCode, IsNoAmount) {
    EXPECT_THAT(lines_raised("MAC574", "O9001\n#3=#4019\n#12=#3*SIN[#10]\nM99\n"), ElementsAre(3));
    EXPECT_THAT(
        lines_raised("MAC574",
                     "O9001\n#3=#4003\n#4=#3\nX[-#4/2]\nY[SQRT[#3]]\nZ[FIX[#3]*2]\nZ[FUP[#3]*2]\nM99\n"),
        ElementsAre(4, 5, 6, 7));
    EXPECT_THAT(lines_raised("MAC574", "O9001\nX[#4003*2]\nM99\n"), ElementsAre(2));
    EXPECT_THAT(path_raised("MAC574", "O9001\n#3=#4003\nIF[#1EQ1]GOTO5\n#5=1\nN5 #2=#3*2\nM99\n"),
                ElementsAre(2, 3, 5));
}

TEST(SavedValueLost, NamesALocalThatIsFree) {
    const std::string begin = "O9506(UP, K STEP)\n#33=#4003\nG91 G0 Z#6\n#33=#5003+#6\nG#33\n";
    EXPECT_THAT(messages_raised("MAC506", begin + "M99\n"), ElementsAre(HasSubstr("such as #32.")));
    EXPECT_THAT(messages_raised("MAC506", begin + "#32=1\nX#31\nM99\n"),
                ElementsAre(HasSubstr("such as #30.")));
}

TEST(ModalCode, MayBeAddedComparedAndPutBack) {
    EXPECT_THAT(lines_raised("MAC574", "O9001\n#1=[#4014-53]*20\n#2=#4014\n#3=[#2-53]*20\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC574", "O9001\n#3=#4003\nIF[#3EQ90]GOTO9\nG91\nN9 G#3\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC574", "O9001\n#33=#4012\nIF[#33NE[FUP[#33]]]GOTO9\nN9 M99\n"), IsEmpty());
}

TEST(ModalCode, IsNotWhatAVariableHoldsThatMayHoldSomethingElse) {
    EXPECT_THAT(lines_raised("MAC574", "O9001\n#3=#4003\nG#3\n#3=#7\n#4=#3*2\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC574", "O9001\nIF[#1EQ1]GOTO9\n#3=#4003\nN9 #4=#3*2\nM99\n"), IsEmpty());
}

TEST(ModalCode, IsNotFeedOrSpeed) {
    EXPECT_THAT(lines_raised("MAC574", "O9001\n#3=#4109\n#4=#3/2\n#5=SQRT[#4119*2]\nM99\n"), IsEmpty());
}

TEST(FeedLeak, OfAVariableThatMayBeVacantIsReportedAsWell) {
    // Nothing says whether #514 is set; where it is, its value stays in force.
    EXPECT_THAT(lines_raised("MAC503", relying + "O9001\nG1 X#24 F#514\nM99\n"), ElementsAre(6));
}

TEST(FeedLeak, IsAWarningWhereACallerLosesItsOwn) {
    const std::string macro = "O9001\nG1 Z#26 F#9\nM99\n";
    EXPECT_THAT(judged("MAC503", "O1\nG1 X1. F800.\nG65 P9001 Z-1. F50.\nX9.\nM30\n" + macro),
                ElementsAre("warning 7"));
    EXPECT_THAT(judged("MAC503", "O1\nG65 P9001 Z-1. F50.\nX9.\nM30\n" + macro), ElementsAre("note 6"));
    // What is left is what the caller had.
    const std::string fast = "O9001\nG1 Z#26 F200.\nG1 Z0 F9600\nM99\n";
    EXPECT_THAT(judged("MAC503", "O1\nG1 X1. F9600\nG65 P9001 Z-1.\nX9.\nM30\n" + fast),
                ElementsAre("note 8"));
    EXPECT_THAT(judged("MAC503", "O1\nG1 X1. F900\nG65 P9001 Z-1.\nX9.\nM30\n" + fast),
                ElementsAre("warning 8"));
    // Whoever calls it writes its feed again, as everybody does behind a macro that cuts.
    EXPECT_THAT(judged("MAC503", macro), IsEmpty());
}

TEST(FeedLeak, IsAWarningWhereTheMacroKeepsOtherState) {
    EXPECT_THAT(judged("MAC503", "O9001\n#1=#4001\n#2=#4003\nG91 G31 Z#26 F#514\nG#1 G#2\nM99\n"),
                ElementsAre("warning 4"));
    // Saved and forgotten.
    EXPECT_THAT(judged("MAC503", "O9001\n#2=#4003\nG91 G31 Z#26 F#514\nM99\n"), ElementsAre("warning 3"));
    // Its own: saved on every path, put back on one.
    EXPECT_THAT(judged("MAC503", "O9001\n#2=#4109\nG31 Z#26 F#514\nIF[#1EQ1]GOTO9\nF#2\nN9 M99\n"),
                ElementsAre("warning 3"));
    // What is only asked for is not kept: units, a mode that decides a branch, a work offset's number.
    EXPECT_THAT(judged("MAC503", relying + "O9001\n#2=#4006\nG31 Z#26 F#514\nM99\n"), ElementsAre("note 7"));
    EXPECT_THAT(judged("MAC503", relying + "O9001\n#2=#4003\nIF[#2EQ91]GOTO9\nG31 Z#26 F#514\nN9 M99\n"),
                ElementsAre("note 8"));
    EXPECT_THAT(judged("MAC503", relying + "O9001\n#2=#4012\nG31 Z#26 F#514\nM99\n"), ElementsAre("note 7"));
}

TEST(FeedLeak, OfAHelperIsItsCallersThatKeepsOtherState) {
    const std::string helper = "O9390\nG31 Z#26 F#514\nM99\n";
    EXPECT_THAT(judged("MAC503", "O9301\n#1=#4001\nG0 X#24\nG65 P9390 Z#26\nG#1\nM99\n" + helper),
                ElementsAre("warning 4"));
    EXPECT_THAT(judged("MAC503", "O9301\n#1=#4001\nG65 P9390 Z#26\nG1 X#24 F#9\nG#1\nM99\n" + helper),
                ElementsAre("warning 4"));
    EXPECT_THAT(judged("MAC503", "O9301\nG0 X#24\nG65 P9390 Z#26\nG1 X0\nM99\n" + helper),
                ElementsAre("note 7"));
    EXPECT_THAT(judged("MAC503", "O9301\nG0 X#24\nG65 P9390 Z#26\nM99\n" + helper), IsEmpty());
}

TEST(FeedLeak, OfACalledProgramIsToldWithTheCall) {
    EXPECT_THAT(messages_raised("MAC503", "O9301\n#1=#4001\nG0 X#24\nG65 P9390 Z#26\nG#1\nM99\nO9390\n"
                                          "G31 Z#26 F#514\nM99\n"),
                ElementsAre(HasSubstr("Feed set by 'G65 P9390 Z#26' is left to the caller")));
}

TEST(FeedLeak, IsNotPutBackByAGWord) {
    EXPECT_THAT(judged("MAC503", "O9301\n#1=#4001\nIF[#24EQ1]GOTO5\nG31 Z#26 F#514\nGOTO6\nN5 G65 P9390 "
                                 "Z#26\nN6 G#1 G#500\nM99\nO9390\nG31 Z#26 F#514\nM99\n"),
                ElementsAre("warning 4"));
}

TEST(FeedLeak, UnderWhichACallerMovesIsOneNoteForFeedAndSpeed) {
    EXPECT_THAT(messages_raised("MAC503", relying + "O9001\nS[#1*2] M3\nG1 Z#26 F#9\nM99\n"),
                ElementsAre(HasSubstr("Left to the caller: 'F#9' and 'S[#1*2]'.")));
}

TEST(FeedLeak, NamesTheCure) {
    EXPECT_THAT(
        messages_raised("MAC503", "O9001\n#1=#4001\nG1 Z#26 F#9\nG#1\nM99\n"),
        ElementsAre(HasSubstr("saves #4001, but not this. Add #33=#4109 at the start, and F#33 before "
                              "the M99 of line 5.")));
    EXPECT_THAT(messages_raised("MAC507", "O9001\n#2=#4109\nG1 Z#26 F#9\nM99\n"),
                ElementsAre(HasSubstr("#2 holds the caller's since line 2: write F#2 before the M99")));
    EXPECT_THAT(
        messages_raised("MAC501", "O9001\n#33=1\nG91 G0 Z#33\nM99\n"),
        ElementsAre(HasSubstr("Distance mode G91 is left to the caller. Add #32=#4003 at the start")));
}

TEST(FeedLeak, OfACallerThatStatedItsOwnOnAnotherPathIsANote) {
    const std::string macro = "O9001\nG1 Z#26 F#9\nM99\n";
    const auto caller = [](std::string_view second) {
        return "O1\nIF[#500EQ1]GOTO5\nG1 X1. F800.\nN5 G0 Z1.\nIF[#500" + std::string(second) +
               "1]GOTO9\nG65 P9001 Z-1. F50.\nX9.\nN9 M30\n";
    };
    EXPECT_THAT(judged("MAC503", caller("EQ") + macro), ElementsAre("warning 10"));
    EXPECT_THAT(judged("MAC503", caller("NE") + macro), ElementsAre("note 10"));
}

TEST(FeedLeak, NamesTheFileOfACallerThatHasANamesake) {
    const auto workspace =
        test::analyse_files({{"a/first.nc", "O1\nG1 X1. F800.\nG65 P9001 Z-1. F50.\nX9.\nM30\n"},
                             {"a/second.nc", "O1\nG0 X1.\nM30\n"},
                             {"a/macro.nc", "O9001\nG1 Z#26 F#9\nM99\n"}},
                            {false, 1});
    const auto findings = run_rules(*workspace, {{find_rule("MAC503")}}, 1);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_THAT(findings.front().message(), HasSubstr("O1 line 4 (first.nc) moves"));
}

TEST(SpeedLeak, OfASpindleThatOnePathStopsDependsOnTheWayThere) {
    const auto macro = [](std::string_view second) {
        return "O9001\nIF[#4111EQ50]GOTO1\nS2000\nM03\nN1 G0 X#24\nIF[#4111" + std::string(second) +
               "50]GOTO2\nM05\nN2 G0 Z#26\nM99\n";
    };
    const std::string caller = "O1\nS900 M3\nG65 P9001 X1.\nG1 X5. F9\nM30\n";
    EXPECT_THAT(judged("MAC503", caller + macro("EQ")), IsEmpty());
    EXPECT_THAT(judged("MAC503", caller + macro("NE")), ElementsAre("warning 8"));
}

TEST(SpeedLeak, OfAParkedSpindleHarmsOnlyWhoStartsItWithout) {
    const std::string parked = "O9001\nG0 X#24\nM05\nS35\nM99\n";
    EXPECT_THAT(judged("MAC503", relying + parked), IsEmpty());
    EXPECT_THAT(judged("MAC503", "O1\nS900 M3\nG65 P9001 X1.\nM3\nG1 X5. F9\nM30\n" + parked),
                ElementsAre("warning 10"));
    EXPECT_THAT(judged("MAC503", "O1\nS900 M3\nG65 P9001 X1.\nG1 X5. F9\nM3\nM30\n" + parked), IsEmpty());
    // On another path the spindle runs on.
    EXPECT_THAT(judged("MAC503", relying + "O9001\nIF[#1EQ1]GOTO9\nM05\nS35\nN9 G0 X#24\nM99\n"), IsEmpty());
    EXPECT_THAT(judged("MAC503", relying + "O9001\nG0 X#24\nM05\nS35\nM03\nM99\n"), ElementsAre("note 8"));
}

TEST(SpeedLeak, BesideAnOrientationMayBeAnAngle) {
    EXPECT_THAT(judged("MAC503", "O1\nS900 M3\nG65 P9001 X1.\nM3\nG1 X5. F9\nM30\nO9001\nM19 S90\n"
                                 "G0 X#24\nM99\n"),
                IsEmpty());
    EXPECT_THAT(judged("MAC503", relying + "O9001\nM19 S[#1*2]\nG0 X#24\nM99\n"), IsEmpty());
}

TEST(OffsetLeft, ToACallerThatHasSetItsOwnAndMovesOn) {
    const std::string macro = "O9001\nG54\nG0X#24\nM99\n";
    EXPECT_THAT(judged("MAC519", "O1\nG55G0X0\nG65P9001X1.\nX5.\nM30\n" + macro), ElementsAre("warning 7"));
    EXPECT_THAT(judged("MAC519", "O1\nG55G0X0\nG65P9001X1.\nG56X5.\nM30\n" + macro), IsEmpty());
    EXPECT_THAT(judged("MAC519", "O1\nG54G0X0\nG65P9001X1.\nX5.\nM30\n" + macro), IsEmpty()); // the same
    EXPECT_THAT(judged("MAC519", "O1\nG65P9001X1.\nX5.\nM30\n" + macro), IsEmpty()); // it has none of its own
    EXPECT_THAT(judged("MAC519", macro), IsEmpty());
    EXPECT_THAT(
        judged("MAC519", "O1\nG55G0X0\nG65P9001X1.\nX5.\nM30\nO9001\n#1=#4014\nG54\nG0X#24\nG#1\nM99\n"),
        IsEmpty());
}

TEST(OffsetLeft, OfATool) {
    const std::string macro = "O9001\nG49\nG53Z0\nM99\n";
    EXPECT_THAT(judged("MAC519", "O1\nG43H1Z50.\nM98P9001\nG0Z2.\nM30\n" + macro), ElementsAre("warning 7"));
    EXPECT_THAT(judged("MAC519", "O1\nG43H1Z50.\nM98P9001\nG0X2.\nG43H2Z2.\nM30\n" + macro), IsEmpty());
    EXPECT_THAT(judged("MAC519", "O1\nG49\nM98P9001\nG0Z2.\nM30\nO9001\nG43H1Z5.\nM99\n"), IsEmpty());
}

TEST(MotionMode, LeftAtRapidMattersToABlockWithAFeed) {
    const std::string up = "O9001\nG0 Z9.\nM99\n";
    const auto after_call = [&](const std::string& block) {
        return judged("MAC504", "O1\nM98 P9001\n" + block + "M30\n" + up);
    };
    EXPECT_THAT(after_call("X5. F100\n"), ElementsAre("warning 6"));
    EXPECT_THAT(after_call("G90 Z#500 F#501\n"), ElementsAre("warning 6"));
    EXPECT_THAT(after_call("G1 X5. F100\n"), IsEmpty());
    EXPECT_THAT(after_call("X5.\n"), IsEmpty());
    EXPECT_THAT(after_call("G31 Z-5. F100\n"), IsEmpty());
    EXPECT_THAT(after_call("G81 X1. Z-5. R2. F100\n"), IsEmpty());
    EXPECT_THAT(after_call("G180 X1. F100\n"), IsEmpty()); // a code that no table knows may be a macro
    EXPECT_THAT(after_call("F100\nG1 X5.\n"), IsEmpty());
}

TEST(MotionMode, OfTheCallerIsLostWhereItGoesOnFromG1) {
    const std::string up = "O9001\nG0 Z9.\nM99\n";
    EXPECT_THAT(judged("MAC504", "O1\nG1 X1. F9\nM98 P9001\nX5.\nM30\n" + up), ElementsAre("warning 7"));
    EXPECT_THAT(judged("MAC504", "O1\nG0 X1.\nM98 P9001\nX5.\nM30\n" + up), IsEmpty());
    EXPECT_THAT(judged("MAC504", "O1\nG0 X1.\nM98 P9001\nX5.\nM30\nO9001\nG1 Z9.\nM99\n"), IsEmpty());
    EXPECT_THAT(judged("MAC504", up), IsEmpty());
}

TEST(ModalState, LeftOnThePathWithoutAnUnknownCallIsReported) {
    EXPECT_THAT(lines_raised("MAC501", "O9001\nG91 G0 Z5.\nIF[#1EQ#0]GOTO1\nG65 P9726\nN1 M99\n"),
                ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC501", "O9001\nIF[#1EQ1]GOTO9\n#2=#4003\nG91 G0 Z5.\nN9 G#2 M99\n"),
                IsEmpty());
}

TEST(ModalState, IsChangedByEveryKindOfBlockAroundAnUnknownCall) {
    const auto around = [](const std::string& block) {
        return lines_raised("MAC501", "O9001\nG91 G0 Z5.\nIF[#1EQ#0]GOTO1\nG65 P9726\nGOTO2\nN1 " + block +
                                          "\nN2 M99\n");
    };
    for (const std::string change : {"G90", "X1. G90", "G90 X#2", "G#2", "G65 P9727"})
        EXPECT_THAT(around(change), IsEmpty()) << change;
    for (const std::string other : {"X1.", "G17 X1.", "#3=1", "X#2", "M#2", "F#2"})
        EXPECT_THAT(around(other), ElementsAre(2)) << other;
}

TEST(SpeedLeak, OfASpindleThatAnotherCalledProgramLeavesStandingHarmsNobody) {
    // O2 stops the spindle, or leaves it as it is: it stands already.
    EXPECT_THAT(judged("MAC503", "O1\nS900 M3\nG65 P9001 X1.\nM98 P2\nG1 X5. F9\nM30\nO9001\nG0 X#24\nM05\n"
                                 "S35\nM99\nO2\nIF[#500EQ1]GOTO5\nM05\nN5 M99\n"),
                IsEmpty());
}

TEST(Suppression, NamesWhatIsSwitchedOff) {
    EXPECT_THAT(messages_raised("MAC515", "O9001\n#3004=2\nG0 X#24\nM99\n"),
                ElementsAre(HasSubstr("No feed override any more: '#3004=2'")));
    EXPECT_THAT(messages_raised("MAC515", "O9001\n#3004=5\nG0 X#24\nM99\n"),
                ElementsAre(HasSubstr("No feed hold and exact stop any more")));
}

TEST(Restore, NamesWhatToWrite) {
    EXPECT_THAT(messages_raised("MAC505", "O9001\n#3=#4019\nG1 X1 F#9\nF#3\nM99\n"),
                ElementsAre(HasSubstr("Write #3=#4109 on line 2")));
}

TEST(SavedValue, ThatIsOverwrittenOnOnePathIsLost) {
    const auto lines = [](const std::string& between, const std::string& after = "") {
        return lines_raised("MAC506", "O9001\n#3=#4003\n" + between + "G91G0Z1.\n" + after + "G#3\nM99\n");
    };
    EXPECT_THAT(lines("IF[#1EQ1]GOTO2\n#3=#5001+1\nN2"), ElementsAre(4));
    // Saved anew, or the path with the other value is none.
    EXPECT_THAT(lines("IF[#1EQ1]GOTO2\n#3=#5001+1\n#3=#4003\nN2"), IsEmpty());
    EXPECT_THAT(lines("IF[#1EQ1]GOTO2\n#3=#5001+1\nN2", "IF[#1NE1]THEN#3000=1\n"), IsEmpty());
}

} // namespace
} // namespace maclint
