//! Programs for controls that maclint does not know: one finding, and nothing else.
#include "tests/support/linted.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string lnc_program =
    "O100\n#1=R_SKIP[1]\nIF[#1EQ0]GOTO9\nALARM(\"NO TOUCH\")\nW_G53G59_COOR[1,1]=#1\nGOTO7\nN9M99\n";

std::string only_message(const std::string& text) {
    const cli::Result result = test::lint_text(text);
    return result.findings.empty() ? "" : result.findings.front().finding.message();
}

cli::Result lint_as_fanuc(const std::string& text) {
    cli::Overrides overrides;
    overrides.dialect = find_dialect("fanuc");
    return test::lint_texts({{"O1.nc", text}}, std::move(overrides));
}

/// A program of as many blocks, `bad` of them wrong in as many ways.
std::string with_wrong_blocks(int bad, int blocks) {
    static const std::string slips[] = {"G1X5.Y?F1", "IFF#1GT2", "GO TO THE BORE", "X1Y2]", "G1 X@@"};
    std::string text = "O1\n";
    for (int i = 0; i < blocks; ++i)
        text += i < bad ? slips[i % 5] + "\n" : "G1X" + std::to_string(i) + ".F100\n";
    return text + "M30\n";
}

TEST(OtherControl, TwoMarksAreOneFindingThatSaysWhichWhatToDoAndHowMuchIsWithheld) {
    EXPECT_THAT(test::codes(test::lint_text(lnc_program)), ElementsAre("MAC005"));
    EXPECT_THAT(only_message(lnc_program),
                AllOf(HasSubstr("LNC"), HasSubstr("'R_SKIP[' on line 2"), HasSubstr("--dialect fanuc"),
                      HasSubstr(" findings, withheld")));
}

TEST(OtherControl, WhoeverNamesTheDialectSeesAll) {
    EXPECT_THAT(test::codes(lint_as_fanuc(lnc_program)),
                AllOf(Contains("MAC118"), Contains("MAC301"), Not(Contains("MAC005"))));
}

TEST(OtherControl, WhoeverAllowsOrIgnoresItSeesAll) {
    EXPECT_THAT(test::codes(test::lint_text("(MACLINT ALLOW-FILE MAC005 - LNC)\n" + lnc_program)),
                Contains("MAC118"));
    cli::Overrides overrides;
    overrides.ignore = {"MAC005"};
    EXPECT_THAT(test::codes(test::lint_texts({{"O1.nc", lnc_program}}, std::move(overrides))),
                Contains("MAC118"));
}

TEST(OtherControl, OneMarkIsAMistake) {
    const std::string one = "O100\n#1=R_SKIP[1]\n#2=R_SKIP[2]\nIF[#1EQ0]GOTO9\nG0X#2\nN9M99\n";
    EXPECT_THAT(test::codes(test::lint_text(one)), ElementsAre("MAC118"));
}

TEST(OtherControl, MarksInRemarksAreNone) {
    EXPECT_THAT(test::codes(test::lint_text("O1\n(A (B) R_SKIP[1] C)\n(A (B) W_G53G59_COOR[1] C)\nM30\n")),
                Not(Contains("MAC005")));
}

TEST(OtherControl, OthersAreNamedByTheirWords) {
    static const std::pair<const char*, const char*> programs[] = {
        {"OKUMA",
         "O1\nG65P2A1.\nN1 IF[#1EQ2]GOTO1\nWHILE[#1LT3]DO1\n#1=#1+1\nEND1\nCALL O1000\nVC1=5\nM30\n"},
        {"SINUMERIK", "O1\nG65P2A1.\nN1 IF[#1EQ2]GOTO1\nG65P3A1.\nWHILE[#1LT3]DO1\n#1=#1+1\nEND1\nDEF REAL "
                      "DEPTH\nSTOPRE\nM30\n"},
        {"Klartext", "O1\nG65P2A1.\nN1 IF[#1EQ2]GOTO1\nG65P3A1.\nWHILE[#1LT3]DO1\n#1=#1+1\nEND1\nTOOL CALL 5 "
                     "Z S200\nL X+1 FMAX\nM30\n"},
    };
    for (const auto& [name, text] : programs) EXPECT_THAT(only_message(text), HasSubstr(name)) << text;
}

TEST(OtherControl, FiveTypingErrorsAreNeverWithheld) {
    const auto codes_found = test::codes(test::lint_text(with_wrong_blocks(5, 8)));
    EXPECT_THAT(codes_found, Not(Contains("MAC005")));
    EXPECT_THAT(codes_found.size(), testing::Ge(4U));
}

TEST(OtherControl, AFifthOfTheBlocksWithoutSenseIsAnotherControl) {
    EXPECT_THAT(test::codes(test::lint_text(with_wrong_blocks(40, 90))), ElementsAre("MAC005"));
    EXPECT_THAT(test::codes(test::lint_text(with_wrong_blocks(30, 400))), Not(Contains("MAC005")));
}

TEST(OtherControl, NoiseAfterAWholeProgramIsNone) {
    EXPECT_THAT(test::codes(test::lint_text("O1\nG0X1.\nGOTO77\nM30\n" + lnc_program.substr(5))),
                AllOf(Contains("MAC301"), Not(Contains("MAC005"))));
}

TEST(OtherControl, AHabitOfWritingIsNone) {
    std::string brackets = "O1\n";
    for (int i = 0; i < 20; ++i) brackets += "#" + std::to_string(100 + i) + "=ABS(#2)\n";
    EXPECT_THAT(test::codes(test::lint_text(brackets + "M30\n")), ElementsAre("MAC116"));
}

TEST(OtherControl, TheHabitOfRemarksAfterSemicolonsIsOne) {
    const std::string remarks =
        "O1\n; measure the bore\n#1=5 ; depth\nG65P2A#1 ; call it\n; done\nGOTO7\nM30\n";
    EXPECT_THAT(test::codes(test::lint_text(remarks)), ElementsAre("MAC005"));
    EXPECT_THAT(only_message(remarks), AllOf(HasSubstr("remarks after ';'"), HasSubstr("on line 2")));
    EXPECT_THAT(
        test::codes(test::lint_text("O1\n; measure the bore\nG0X1. ; depth\nG100P2(<FMT:.1F,#10>)\nM30\n")),
        ElementsAre("MAC005"));
    // Three are none, and what stands in brackets after ';' is for any control.
    EXPECT_THAT(test::codes(test::lint_text("O1\n; measure the bore\nG0X1. ; depth\n; ready\nM30\n")),
                ElementsAre("MAC121"));
    std::string brackets = "O1\n";
    for (int i = 0; i < 6; ++i) brackets += "G0X1.; (TO THE (LEFT) EDGE)\n";
    EXPECT_THAT(test::codes(test::lint_text(brackets + "M30\n")), Not(Contains("MAC005")));
}

TEST(OtherControl, DinPlusStaysDinPlus) {
    EXPECT_THAT(
        test::codes(test::lint_text("MACHINING\nN10 G0 X100 Z2\nN11 CALL O5\nN12 NOEX\nN30 M30\nEND\n")),
        Not(Contains("MAC005")));
}

// ---- marks of a control of the family

std::string control_shown_by(const std::string& text) {
    return std::string(detect_dialect(Source::from_bytes("O1.nc", text)).control);
}

TEST(ControlMarks, OneCertainOrTwoDifferentOnesNameAHaas) {
    EXPECT_EQ(control_shown_by("O1\nIF[#30003.036EQ1]GOTO2\nN2M30\n"), "haas");
    EXPECT_EQ(control_shown_by("O1(POST FOR HAAS NGC)\nG0X1.\nM30\n"), "haas");
    EXPECT_EQ(control_shown_by("O1(CONTROLLER: HAAS LEGACY)\nG0X1.\nM30\n"), "haas");
    EXPECT_EQ(control_shown_by("O1(HAAS SETUP, MODEL 3 CONTROLS)\nG0X1.\nM30\n"), "");
    EXPECT_EQ(control_shown_by("O1\nG103 P1\nM97 P100\nM30\n"), "haas");
}

TEST(ControlMarks, OneThatOthersMayHaveNamesNone) {
    EXPECT_EQ(control_shown_by("O1\nG103 P1\nG103 P0\nM30\n"), "");
    EXPECT_EQ(control_shown_by("O1(WAS ON THE HAAS)\n#504.=1\nM30\n"), "");
    EXPECT_EQ(control_shown_by("O1(SHAASE NGCX)\nG0X1.\nM30\n"), "");
    EXPECT_EQ(control_shown_by("O1\n#1=#30003\nX.036\nM30\n"), "");
}

TEST(ControlMarks, NothingFallsSilentOnAHaas) {
    const std::string wrong = "IF[#100LTE1]GOTO9\n#1=#1/0\nGOTO77\nN9M30\n";
    EXPECT_EQ(test::codes(test::lint_text("O1(HAAS NGC)\n" + wrong)),
              test::codes(test::lint_text("O1(FANUC)\n" + wrong)));
}

} // namespace
} // namespace maclint
