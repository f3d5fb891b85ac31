//! What was meant by a block that is wrong: messages that say it, and notes that are told on request alone.
#include "tests/support/linted.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string message(const std::string& text) {
    const cli::Result result = test::lint_text(text);
    return result.findings.size() == 1 ? result.findings.front().finding.message()
                                       : std::to_string(result.findings.size()) + " findings";
}

std::string message_of_block(const std::string& block) { return message("O1\n#100=1\n" + block + "\nM30\n"); }

std::vector<std::string> codes_selecting(const std::string& text, const std::string& rule) {
    cli::Overrides overrides;
    overrides.select = {rule};
    return test::codes(test::lint_texts({{"O1.nc", text}}, std::move(overrides)));
}

std::vector<std::string> codes_by_default(const std::string& text) {
    return test::codes(test::lint_text(text));
}

TEST(Meant, ACommaIsADecimalPoint) {
    for (const char* block : {"G1 X1,5 F100", "X1,5", "N10 G1 Y2 X1,5 F0,2"})
        EXPECT_THAT(message_of_block(block), HasSubstr("Decimal comma in 'X1,5'")) << block;
    EXPECT_THAT(message_of_block("#100=1,5"), HasSubstr("Write 1.5."));
    EXPECT_THAT(message_of_block("G1 X 5,25"), HasSubstr("Write 5.25."));
    // A comma before a letter is a chamfer or a corner.
    EXPECT_THAT(codes_by_default("O1\nG1 X5,C3 F100\nM30\n"), IsEmpty());
}

TEST(Meant, NamesOfTheGrammarAreNoWordsForUsers) {
    for (const char* block : {"G1 X5,", "G1 X5, F100", "IF", "WHILE[#100LT5]DO", "#100=", "G1 X[", "GOTO"})
        EXPECT_THAT(message_of_block(block), Not(testing::ContainsRegex("[a-z]_[a-z]"))) << block;
}

TEST(Meant, ASharpWithoutItsNumber) {
    EXPECT_THAT(message_of_block("#100=#ABS[#100]"),
                HasSubstr("expected the number of the variable after '#'"));
    EXPECT_THAT(message_of_block("#100=[#SIN[30]]+2"),
                HasSubstr("expected the number of the variable after '#'"));
}

TEST(Meant, AnAddressIsMissingBeforeAVariable) {
    EXPECT_THAT(message_of_block("G1 X10. #100"),
                HasSubstr("'#100': expected an address before the variable."));
    EXPECT_THAT(message("O1\n#675=500.\nG1 X1. F#675\nX5. #675\nM30\n"),
                HasSubstr("expected an address before the variable, which is F elsewhere"));
    EXPECT_THAT(message("O1\n#675=500.\nG1 Y#675 F#675\nX5. #675\nM30\n"), Not(HasSubstr("elsewhere")));
    EXPECT_THAT(message("O1\n#675=500.\nG1 X1. F#6750\nX5. #675\nM30\n"), Not(HasSubstr("elsewhere")))
        << "another variable";
}

/// 29 blocks without their F are one finding.
TEST(Meant, AMissingAddressIsOneFindingAProgram) {
    std::string text = "O1\n#675=500.\nG1 X1. F#675\n";
    for (int i = 0; i < 150; ++i) text += "Y" + std::to_string(i) + ".\n";
    for (int i = 0; i < 29; ++i) text += "X" + std::to_string(i) + ". #675\n";
    EXPECT_THAT(message(text + "M30\n"),
                AllOf(HasSubstr("which is F elsewhere"), HasSubstr("28 more places")));
}

TEST(Meant, AWordWithoutAnArgumentIsNoFunction) {
    EXPECT_THAT(message_of_block("T3 TAP M10"),
                AllOf(HasSubstr("Unknown word 'TAP'"), Not(HasSubstr("TAN"))));
    EXPECT_THAT(message_of_block("#100=TAM[30]"), HasSubstr("Write 'TAN'"));
}

TEST(Meant, LettersOfGotoAreNoRapidTraverse) {
    for (const char* block : {"IF[#100EQ1]GOT5", "IF[#100EQ1]GOT 5", "GTO5", "IF[#100EQ1]GTO5"})
        EXPECT_THAT(message_of_block(block), HasSubstr("Write 'GOTO'")) << block;
    EXPECT_THAT(message_of_block("GO X5."), HasSubstr("G0")) << "a letter O";
    EXPECT_THAT(message_of_block("GOT0101"), Not(HasSubstr("GOTO"))) << "G0 T0101";
}

TEST(Meant, TheNearestSequenceNumberIsADigitAway) {
    const auto nearest = [](const std::string& jump, const std::string& numbers) {
        return message("O1\n#100=1\n" + jump + "\n" + numbers + "M30\n");
    };
    EXPECT_THAT(nearest("GOTO401", "N390\nN430\nN4001\n"), HasSubstr("nearest: N4001 (line 6), N390"));
    EXPECT_THAT(nearest("GOTO120", "N100\nN102\nN210\nN12\n"), HasSubstr("nearest: N102 (line 5) and N210"))
        << "exchanged digits lie nearer than a lost one";
    EXPECT_THAT(nearest("GOTO6", "N5\nN8\nN16\n"), HasSubstr("nearest: N5 (line 4) and N8 (line 5)."));
}

TEST(Meant, ANumberThatIsAVariableIsNoConstantCondition) {
    const std::string text = "O1\nIF[4012EQ56]GOTO5\n#3000=1\nN5M30\n";
    EXPECT_THAT(codes_by_default(text), ElementsAre("MAC229"));
    EXPECT_THAT(message(text), HasSubstr("Write #4012."));
    EXPECT_THAT(codes_by_default("O1\n#500=#500+1\nIF[500LT20]GOTO5\n#3000=1\nN5M30\n"),
                ElementsAre("MAC229"));
    for (const char* meant : {"1EQ1", "4012EQ4012", "0EQ1", "150LT20"})
        EXPECT_THAT(codes_by_default("O1\nIF[" + std::string(meant) + "]GOTO5\n#3000=1\nN5M30\n"),
                    Not(testing::Contains("MAC229")))
            << meant;
}

TEST(OneHabit, IsOneFinding) {
    const std::string zero_tests = "O9001\nIF[#1EQ0]GOTO9\nIF[#2EQ0]GOTO9\nIF[#3EQ0]GOTO9\nG0X#1Y#2Z#3\nM99\n"
                                   "N9#3000=1(MISSING)\n";
    EXPECT_THAT(codes_by_default(zero_tests), ElementsAre("MAC220"));
    EXPECT_THAT(message(zero_tests), HasSubstr("2 more places"));
    const std::string two_in_one =
        "O1\n#1=#500/3\n#2=#501/3\nIF[[#1EQ1.2]OR[#2EQ3.4]]GOTO5\nG0X#1Y#2\nN5M30\n";
    EXPECT_THAT(codes_by_default(two_in_one), ElementsAre("MAC710"));
}

/// Each of these is right, and hardly anybody acts on it.
TEST(OnRequest, NotesAreToldWhereTheirRuleIsSelected) {
    const std::vector<std::pair<std::string, std::string>> notes = {
        {"MAC213", "O9001\n#33=#24*2\n#32=#25*2\nG0X#33\nM99\n"},
        {"MAC460", "O1\nG0X1.\nGOTO5\nG0X2.\nN5M30\n"},
        {"MAC462", "O1\nIF[#500EQ1]GOTO5\nX1.\nN5\nIF[#501EQ1]GOTO5\nX2.\nN5M30\n"},
    };
    for (const auto& [rule, text] : notes) {
        EXPECT_THAT(codes_by_default(text), Not(testing::Contains(rule))) << rule;
        EXPECT_THAT(codes_selecting(text, rule), ElementsAre(rule));
        EXPECT_THAT(codes_selecting(text, "ALL"), testing::Contains(rule));
    }
}

TEST(OnRequest, AnAlarmThatNothingRaisesIsToldAlways) {
    EXPECT_THAT(codes_by_default("O9460\nIF[#24EQ#0]GOTO91\nG90G0X#24\nM99\nN91#3000=1(X)\nN92#3000=2(Y)\n"),
                ElementsAre("MAC460"));
}

/// N5 of the first part is the start of its loop: GOTO5 goes on to the second part, past M99 or an alarm.
TEST(RepeatedNumber, ThatLeadsIntoAnotherPartIsAWarning) {
    const std::string strayed = "O9001\n#1=5\nN5G0X#1\n#1=#1-1\nIF[#1GT0]GOTO5\nIF[#500EQ1]GOTO20\nM99\n"
                                "N20#1=9\nN5G0Y#1\nM99\n";
    EXPECT_THAT(codes_by_default(strayed), ElementsAre("MAC462"));
    EXPECT_THAT(message(strayed),
                AllOf(HasSubstr("'GOTO5' on line 5"), HasSubstr("N5 of line 9"), HasSubstr("N5 of line 3")));
    // Copies whose jumps take the next one, each behind an alarm.
    EXPECT_THAT(codes_by_default("O9001\nIF[#24NE#0]GOTO5\n#3000=1(X)\nN5\nIF[#25NE#0]GOTO5\n#3000=2(Y)\n"
                                 "N5G0X#24Y#25\nM99\n"),
                IsEmpty());
}

/// The alarm is that of the jump into the loop; that the number stands twice tells why it goes there.
TEST(RepeatedNumber, ThatLeadsIntoALoopTellsWhyTheJumpGoesThere) {
    EXPECT_THAT(codes_by_default("O9001\n#1=5\nN5G0X#1\n#1=#1-1\nIF[#1GT0]GOTO5\n#2=0\nWHILE[#2LT3]DO1\n"
                                 "N5G0Y#2\n#2=#2+1\nEND1\nM99\n"),
                ElementsAre("MAC303", "MAC462"));
}

TEST(Alarms, InMessagesAreThoseOfTheControl) {
    const auto under = [](const std::string& control) {
        cli::Overrides overrides;
        overrides.control = control;
        const auto result = test::lint_texts({{"O1.nc", "O1\nG0 G1 X1. F100.\nM30\n"}}, std::move(overrides));
        return result.findings.empty() ? "" : result.findings.front().finding.message();
    };
    EXPECT_THAT(under("fanuc-16i"), HasSubstr("stops with alarm 5074"));
    EXPECT_THAT(under("haas"), AllOf(HasSubstr("stops with an alarm"), Not(HasSubstr("5074"))));
}

} // namespace
} // namespace maclint
