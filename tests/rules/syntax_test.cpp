//! Rules of syntax: what their examples do not show.
#include "tests/rules/raised.hpp"
#include "tests/support/linted.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// "2: error MAC118 and lines 4, 6": a finding, its line, and those of its repeats.
std::vector<std::string> told(const cli::Result& result) {
    static constexpr const char* names[] = {"note", "warning", "error"};
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] : result.findings) {
        if (suppressed) continue;
        const auto line = [&](Span span) {
            return std::to_string(finding.source->position(span.begin).line);
        };
        std::string text = line(finding.span) + ": " + names[static_cast<int>(finding.severity)] + " " +
                           std::string(finding.rule->code);
        for (const RelatedLocation& place : finding.repeats) text += " +" + line(place.span);
        all.push_back(text);
    }
    return all;
}

std::vector<std::string> told(std::string_view text) { return told(test::lint_text(text)); }

/// What is told of a text that somebody says is for a control of the family.
std::vector<std::string> told_of_fanuc(std::string_view text) {
    cli::Overrides overrides;
    overrides.dialect = find_dialect("fanuc");
    return told(test::lint_texts({{"O1.nc", std::string(text)}}, std::move(overrides)));
}

std::string first_message(std::string_view text) {
    const cli::Result result = test::lint_text(text);
    return result.findings.empty() ? "" : result.findings.front().finding.message();
}

// ---- one cause, one finding

TEST(OneSyntaxError, TheSameUnknownWordIsToldOnceWithItsOtherLines) {
    const std::string text = "O1\nIF[#100LTE1]GOTO9\nG0X1.\nIF[#101LTE1]GOTO9\nIF[#102LTE1]GOTO9\nN9M30\n";
    EXPECT_THAT(told(text), ElementsAre("2: error MAC118 +4 +5"));
    EXPECT_THAT(first_message(text), EndsWith(" The same in 2 more places: lines 4 and 5. Write 'LE'."));
}

TEST(SyntaxErrors, AreToldOfNumbersTooLongForTheirCure) {
    const std::string zeros(80, '0');
    EXPECT_THAT(test::messages_raised("MAC106", "O1\nG0 X0." + zeros + "O7\nM30\n"),
                ElementsAre(AllOf(HasSubstr(zeros + "O7"), EndsWith("Write the figure."))));
    EXPECT_THAT(test::messages_raised("MAC106", "O1\nGO" + std::string(80, '1') + "\nM30\n"),
                ElementsAre(EndsWith("Write the figure.")));
}

/// Whoever has a message with a cure needs one for where none is known; where the message itself tells the
/// second thing, that is always known.
TEST(SyntaxErrors, HaveAMessageWithoutACureToo) {
    std::size_t with_cure = 0;
    for (const Rule* rule : all_rules()) {
        const auto find = [&](std::string_view id) {
            return std::ranges::find(rule->messages, id, &Message::id);
        };
        const auto cure = find("cure");
        if (cure == rule->messages.end()) continue;
        ++with_cure;
        const bool is_detail = cure->text.find("{1}") != std::string_view::npos;
        EXPECT_TRUE(is_detail || find("plain") != rule->messages.end()) << rule->code;
    }
    EXPECT_GT(with_cure, 5U);
}

TEST(OneMissingNumber, IsToldOnceAProgramWithTheOthers) {
    const std::string text = "O1\nIF[#100EQ1]GOTO7\nIF[#100EQ2]GOTO8\nM30\nO2\nGOTO9\nM30\n";
    EXPECT_THAT(told(text), ElementsAre("2: error MAC301 +3", "6: error MAC301"));
    EXPECT_THAT(first_message(text), HasSubstr(" The same in 1 more place: line 3. "));
}

TEST(OneSyntaxError, AnotherWordAndAnotherProgramAreOtherCauses) {
    EXPECT_THAT(told("O1\nIF[#100LTE1]GOTO9\nIF[#101GTE1]GOTO9\nN9M30\n"),
                ElementsAre("2: error MAC118", "3: error MAC118"));
    EXPECT_THAT(told("O1\nIF[#100LTE1]GOTO9\nN9M30\nO2\nIF[#100LTE1]GOTO9\nN9M30\n"),
                ElementsAre("2: error MAC118", "5: error MAC118"));
}

TEST(OneSyntaxError, OfAMainPartBehindItsSubprogramIsAnotherCause) {
    const std::string text = "%x.nc\nSUBPROGRAM \"A\"\nG1 X??\nRETURN\nMACHINING\nT1\nG1 X??\nM30\nEND\n";
    EXPECT_THAT(told(text), ElementsAre("3: error MAC121", "7: error MAC121"));
}

TEST(OneSyntaxError, ManyLinesAreCountedButNotAllNamed) {
    std::string text = "O1\n";
    for (int i = 0; i < 9; ++i) text += "#1=ABS(#2)\n";
    EXPECT_THAT(first_message(text + "M30\n"),
                EndsWith(" The same in 8 more places: lines 3, 4, 5, 6, 7, 8 … Write '[#2]'."));
}

TEST(OneSyntaxError, APlaceThatACommentAllowsIsNoRepeat) {
    EXPECT_THAT(told("O1\n#1=ABS(#2)(MACLINT ALLOW MAC116 - OLD)\n#1=ABS(#3)\n#1=ABS(#4)\nM30\n"),
                ElementsAre("3: error MAC116 +4"));
}

TEST(OneSyntaxError, IsMendedInAllItsPlaces) {
    const cli::Result result = test::lint_text("O1\nGO1Y5.\nG0X1.\nGO1Y6.\nM30\n");
    ASSERT_THAT(told(result), ElementsAre("2: error MAC106 +4"));
    const Finding& finding = result.findings.front().finding;
    ASSERT_EQ(finding.fixes.size(), 1U);
    std::string text(finding.source->bytes());
    for (const Edit& edit : finding.fixes.front().edits)
        text.replace(edit.span.begin, edit.span.length(), edit.text); // as long as it was
    EXPECT_EQ(text, "O1\nG01Y5.\nG0X1.\nG01Y6.\nM30\n");
}

TEST(OneSyntaxError, DinPlusHasItToo) {
    EXPECT_THAT(told("MACHINING\nN10 G0 X100 Z2\nN11 THN\nN12 THN\nN13 ENDFI\nN30 M30\nEND\n"),
                ElementsAre("3: error MAC118 +4", "5: error MAC118"));
}

// ---- where no path leads

TEST(UnreachedText, IsANoteThatNamesTheSlip) {
    EXPECT_THAT(told("O1\nIF[#100GT0]GOTO5\n#3000=1(NO LENGTH)\n#101=[#102+1\nN5G0X#101\nM30\n"),
                ElementsAre("4: note MAC122"));
    EXPECT_THAT(
        first_message("O1\nIF[#100GT0]GOTO5\n#3000=1(NO LENGTH)\n#101=[#102+1\nN5G0X#101\nM30\n"),
        "Block that no path reaches and the control could not read: in '#101=[#102+1', at '[', its ']' is "
        "missing. Correct it, or delete it.");
    EXPECT_THAT(told("O1\nGOTO5\n#101=[#102+1\nN5G0X1.\nGOTO6\n#102=ABS(#1)\nN6M30\n"),
                ElementsAre("3: note MAC122", "6: note MAC122"));
}

TEST(UnreachedText, IsToldWithTheJumpThatPassesItByMistake) {
    EXPECT_THAT(told("O1\nGOTO77\nG01X[#102*2.Y5.\nGO1X5.\nM30\n"),
                ElementsAre("2: error MAC301", "3: note MAC122 +4"));
}

TEST(UnreachedText, IsSilentOnSeparatorsRemarksAndWhatIsPassedOnPurpose) {
    EXPECT_THAT(told("O1\nIF[#100GT0]GOTO5\nGOTO10\n---------\n=====\n* * *\n...\nN5\nM0\nN10\nM30\n"),
                IsEmpty());
    EXPECT_THAT(told("O1\nGOTO5\nTURN THE PART OVER\nTWPXEQ\nN5G0X1.\nM30\n"), IsEmpty());
    EXPECT_THAT(told("O1\nG0X1.\nM30\n#101=[#102+1\nTOOL LIST\n"), IsEmpty());
    EXPECT_THAT(told("O1\nGOTO5(DELETE TO MEASURE)\n#101=[#102+1\nN5G0X1.\nM30\n"), IsEmpty());
    EXPECT_THAT(told("O1\nGOTO5\nTAKE TOOL 5\nN5G0X1.\nM30\n"), IsEmpty());
}

TEST(UnreachedText, IsNoneWhereAJumpOrTheBlockBeforeLeads) {
    EXPECT_THAT(told("O1\nIF[#100GT0]GOTO4\nGOTO5\nN4-----\nN5G0X1.\nM30\n"), ElementsAre("4: error MAC121"));
    EXPECT_THAT(told("O1\nIF[#100GT0]GOTO5\n-----\nN5G0X1.\nM30\n"), ElementsAre("3: error MAC121"));
    EXPECT_THAT(told("O1\n#1=4\nGOTO#1\nN3-----\nN4-----\nN5G0X1.\nM30\n").size(), 1U);
}

// ---- remarks of other controls

TEST(BareRemark, IsOneWarningAFileForEachSign) {
    EXPECT_THAT(
        told_of_fanuc(
            "O1\n// clamp the part\nG0X1. ; to the left\n// and turn it\nM30\nO2\n// second side\nM30\n"),
        ElementsAre("2: warning MAC121 +4 +7", "3: warning MAC121"));
}

TEST(BareRemark, IsNoneWhereBlocksAreWrittenSideBySide) {
    EXPECT_THAT(told("O1\nG0X1.;G1Y2.F100;\n//G0X5.\nM30;\n"), IsEmpty());
    EXPECT_THAT(told("O1\nG0X1.;G1Y?\nM30\n"), ElementsAre("2: error MAC121"));
}

TEST(BareRemark, ChangesNothingInTheProgram) {
    // A block that could not be read might set #100, and leave no doubt of the loop.
    EXPECT_THAT(told("O1\n#100=1\nWHILE[#100LT5]DO1\nG0X1. ; here #100 is counted\nEND1\nM30\n"),
                testing::Contains(HasSubstr("MAC319")));
}

// ---- single messages

TEST(UnknownKeyword, SaysWhatTakesThePlaceOfAnIfWithBlocks) {
    const std::string text = "O1\nIF[#100EQ1]THEN\n#101=2\nELSE\n#101=3\nENDIF\nM30\n";
    cli::Overrides named;
    named.control = "fanuc-16i";
    const cli::Result result = test::lint_texts({{"O1.nc", text}}, std::move(named));
    EXPECT_THAT(told(result), ElementsAre("2: error MAC118 +4 +6"));
    EXPECT_THAT(result.findings.front().finding.message(),
                AllOf(StartsWith("No block IF on this control"), HasSubstr("IF and GOTO")));
    EXPECT_THAT(first_message(text), AllOf(StartsWith("Block IF: the assumed control has none"),
                                           HasSubstr("mitsubishi or mazak-eia")));
}

TEST(UnknownKeyword, AThenWithItsStatementIsNoBlock) {
    EXPECT_THAT(told("O1\nIF[#100EQ1]THEN#101=2\nG0X#101\nM30\n"), IsEmpty());
}

TEST(ParenthesisAsBracket, WritesAllBracketsSquare) {
    EXPECT_THAT(first_message("O1\n#1=ATAN(ABS(#3)/ABS(#4))\nM30\n"), EndsWith("Write '[ABS[#3]/ABS[#4]]'."));
    EXPECT_THAT(first_message("O1\n#1=ABS(#3\nM30\n"), EndsWith("Close it with ')'."));
}

TEST(UnreadableBlock, NamesTheWholeWord) {
    EXPECT_THAT(first_message("O1\nG0X1.WXY2.\nM30\n"), HasSubstr("'WXY"));
}

TEST(VariableNumber, WithAPointIsAWarningWithDecimalsAnErrorExceptOnAHaas) {
    EXPECT_THAT(told("O1\n#504.=1\nG0X#504\nM30\n"), ElementsAre("2: warning MAC121"));
    cli::Overrides fanuc;
    fanuc.control = "fanuc-0i-d";
    const std::string text = "O1\n#1=#30003.036\nIF[#30003.036EQ1]GOTO2\nG0X#1\nN2M30\n";
    EXPECT_THAT(told(test::lint_texts({{"O1.nc", text}}, fanuc)), ElementsAre("2: error MAC121 +3"));
    EXPECT_THAT(told(text), IsEmpty());
}

TEST(DataOfG10, IsNoExpression) {
    EXPECT_THAT(told("O1\nG10L60P1[*BDB,1,2]\nG11\nM30\n"), IsEmpty());
    EXPECT_THAT(told("O1\nG10L2P1X[#1+2\nM30\n"), ElementsAre("2: error MAC117"));
    EXPECT_THAT(told("O1\nG1X10[*BDB]\nM30\n").size(), 1U);
}

TEST(WhileLoop, MayBeWrittenWithTwoLetters) {
    EXPECT_THAT(told("O1\n#100=0\nWH[#100LT5]DO1\n#100=#100+1\nEND1\nM30\n"), IsEmpty());
    EXPECT_THAT(told("O1\n#100=0\nWH[#100LT5]DO1\nG0X1.\nEND1\nM30\n"), ElementsAre(HasSubstr("MAC319")));
}

TEST(FolderMark, IsNoBlock) {
    EXPECT_THAT(told("%\n&F=/MTB/\nO1\nM98P2\nM30\nO2\nM99\n&F=\nO2\nG0X1.\nM99\n%\n"), IsEmpty());
}

} // namespace
} // namespace maclint
