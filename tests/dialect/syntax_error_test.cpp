//! Wrong blocks, and the cause that is told for each.
#include "analyzer/dialect/fanuc/diagnose.hpp"
#include "analyzer/dialect/fanuc/split.hpp"
#include "analyzer/program/faults.hpp"
#include "analyzer/program/readable.hpp"
#include "tests/dialect/reading.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::lower;

std::set<SyntaxErrorKind> causes_of_rule(std::string_view rule) {
    static constexpr std::pair<std::string_view, SyntaxErrorKind> causes[] = {
        {"MAC102", SyntaxErrorKind::unterminated_comment},
        {"MAC106", SyntaxErrorKind::letter_o},
        {"MAC106", SyntaxErrorKind::letter_o_or_jump},
        {"MAC109", SyntaxErrorKind::missing_value},
        {"MAC116", SyntaxErrorKind::parenthesis_as_bracket},
        {"MAC117", SyntaxErrorKind::bracket_mismatch},
        {"MAC118", SyntaxErrorKind::unknown_keyword},
        {"MAC118", SyntaxErrorKind::missing_construct},
        {"MAC119", SyntaxErrorKind::symbolic_comparison},
        {"MAC126", SyntaxErrorKind::unreadable},
        {"MAC127", SyntaxErrorKind::unreadable},
        {"MAC206", SyntaxErrorKind::double_sharp},
        {"MAC305", SyntaxErrorKind::letter_in_jump},
        {"MAC307", SyntaxErrorKind::words_after_jump},
        {"MAC324", SyntaxErrorKind::condition_without_brackets},
        {"MAC325", SyntaxErrorKind::condition_alone},
        {"MAC325", SyntaxErrorKind::consequence_without_then},
        {"MAC326", SyntaxErrorKind::more_after_then},
        {"MAC327", SyntaxErrorKind::words_after_then},
        {"MAC329", SyntaxErrorKind::logic_outside_brackets},
        {"MAC332", SyntaxErrorKind::words_beside_statement},
        {"MAC332", SyntaxErrorKind::statement_beside_statement},
        {"MAC401", SyntaxErrorKind::call_without_program},
        {"MAC706", SyntaxErrorKind::function_without_brackets},
        {"MAC709", SyntaxErrorKind::comparison_as_value},
        {"MAC716", SyntaxErrorKind::sign_after_sign},
        {"MAC701", SyntaxErrorKind::bracket_depth},
        {"MAC311", SyntaxErrorKind::loop_without_do},
    };
    std::set<SyntaxErrorKind> of_rule;
    for (const auto& [code, cause] : causes)
        if (code == rule) of_rule.insert(cause);
    return of_rule;
}

TEST(SyntaxErrors, AJumpInTwoWordsIsNoUnknownWord) {
    EXPECT_EQ(lower("OR[#19 EQ2]GO TO1"), lower("OR[#19 EQ2]GOTO1"));
}

TEST(SyntaxErrors, WrongBlocksOfTheGrammarAreToldTheirCause) {
    std::ifstream file(MACLINT_SOURCE_DIR "/grammar/fanuc/test/wrong-blocks.txt");
    ASSERT_TRUE(file);
    for (std::string line; std::getline(file, line);) {
        const std::size_t tab = line.find('\t');
        if (tab == std::string::npos) continue;
        const std::set<SyntaxErrorKind> wanted = causes_of_rule(line.substr(tab + 1));
        if (wanted.empty()) continue;
        std::set<SyntaxErrorKind> found;
        for (const SyntaxError& syntax_error : test::read(line.substr(0, tab)).syntax_errors)
            found.insert(syntax_error.kind);
        EXPECT_TRUE(std::ranges::any_of(found, [&](SyntaxErrorKind kind) { return wanted.contains(kind); }))
            << line << '\n'
            << lower(line.substr(0, tab));
        EXPECT_FALSE(found.contains(SyntaxErrorKind::unreadable) && found.size() > 1)
            << "told twice: " << line;
    }
}

TEST(SyntaxErrors, WordsThatTheControlRefusesAreToldThoughTheyCanBeParsed) {
    static constexpr std::pair<const char*, const char*> blocks[] = {
        {"G1X--5", "! unreadable 'X--5' -> a number with at most one sign and one decimal point"},
        {"G1X1..5", "! unreadable 'X1..5' -> a number with at most one sign and one decimal point"},
        {"N#3G1X1.", "! unreadable 'N#3' -> the digits of a sequence number"},
        {"O#1", "! unreadable 'O#1' -> the digits of a program number"},
        {"##1=5", "! double-sharp '##1' -> #[#1]"},
        {"N1 21 G40", "! unreadable '21' -> an address before the number"},
        {"(HOLES (8) / 1.7)",
         "! nested-comment '/ 1.7)' -> nothing after the first ')', because comments do not nest"},
        {"#4=#1>2", "! unreadable '>' -> a calculation, because only IF and WHILE compare"},
        {"IF[#1>2]GOTO5", "! symbolic-comparison '>' -> GT"},
        {"NEXT", "! unknown-keyword 'NEXT' -> END"},
        {"ENDIF", "! missing-construct 'ENDIF' -> THEN takes one statement"},
        {"#1=[5 ELSE", "! bracket-mismatch '[' -> its ']' is missing"},
        {"#1=5 ELSE IF", "! missing-construct 'ELSE' -> THEN takes one statement"},
    };
    for (const auto& [block, reported] : blocks)
        EXPECT_THAT(lower(block), ::testing::HasSubstr(reported)) << block;
    for (const char* fine : {"G1X-#1", "#1=-[-5]", "#[#1]=5", "N1#1=5", "X-.5"})
        EXPECT_TRUE(test::read(fine).syntax_errors.empty()) << fine;
}

TEST(SyntaxErrors, AbbreviatedFunctionsAreWordsOfTheLanguage) {
    EXPECT_THAT(lower("#1=RO(#2)"), ::testing::EndsWith("! parenthesis-as-bracket 'RO' -> [#2]"));
    EXPECT_THAT(lower("#1=FI[#2]+AB[#3"),
                ::testing::EndsWith("! bracket-mismatch '[' -> its ']' is missing"));
}

TEST(SyntaxErrors, TheNumberOfALoopStandsWithoutBrackets) {
    EXPECT_EQ(test::read("WHILE[#1LT5]DO(1)").syntax_errors.at(0).cure, "1");
    EXPECT_EQ(test::read("END(1)").syntax_errors.at(0).cure, "1");
}

TEST(SyntaxErrors, TheCureHasAllThatTheBracketsHoldNotOnlyTheComment) {
    // The comment is "(ABS(#2)": in brackets it would be as wrong as before.
    EXPECT_EQ(test::read("#1=ATAN(ABS(#2)/ABS(#3))").syntax_errors.at(0).cure, "[ABS[#2]/ABS[#3]]");
    EXPECT_EQ(test::read("#1=ATAN(ABS(#2)/ABS(#3)").syntax_errors.at(0).cure, "");
    EXPECT_EQ(test::read("#1=ATAN(#2)").syntax_errors.at(0).cure, "[#2]");
}

TEST(SyntaxErrors, TheCureIsUtf8LikeTheSubject) {
    EXPECT_EQ(test::read("#1=SIN(\xE4)").syntax_errors.at(0).cure, "[\xC3\xA4]");
}

TEST(SyntaxErrors, TheListOfAnOutputStatementMayHoldAnyWords) {
    for (const std::string block :
         {"DPRNT[HOLE*NO/#122[40]/**HOLE*NAME/**CENTRE*DISTANCE]", "DPRNT[HOLES*OUT*OF*LIMITS]",
          "BPRNT[IF*ANGLE<LIMIT*THEN*GOOD]", "N10DPRNT[WHILE*DIAMETER>=#1[33]*REWORK*PART]"}) {
        EXPECT_TRUE(test::read(block).syntax_errors.empty()) << block;
        const auto cause = fanuc::find_cause(block, {0, static_cast<Offset>(block.size())});
        EXPECT_FALSE(cause) << block << ": " << cause->subject;
    }
    EXPECT_EQ(test::read("DPRNT[HOLES*OUT*OF*LIMITS").syntax_errors.at(0).cure, "its ']' is missing");
}

/// Every block of the files below the folder that is read without complaint has no cause of an error in it:
/// inside noise the cause is looked for first.
void expect_no_cause_in_good_blocks(const std::filesystem::path& folder) {
    std::set<std::string> seen;
    RawBlock block{};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string text((std::istreambuf_iterator<char>(file)), {});
        for (Offset at = 0; at < text.size(); at = std::max(block.next, at + 1)) {
            fanuc::cut_block(text, at, fanuc::Reading::takes, block);
            const std::string code = text.substr(block.span.begin, block.span.length());
            if (code.empty() || !seen.insert(code).second) continue;
            if (!test::read(code).syntax_errors.empty()) continue;
            const auto cause = fanuc::find_cause(code, {0, static_cast<Offset>(code.size())});
            EXPECT_FALSE(cause) << entry.path() << ": " << code << "\n"
                                << cause->subject << ": " << cause->cure;
        }
    }
}

TEST(SyntaxErrors, NoCauseIsToldOfAGoodBlock) {
    expect_no_cause_in_good_blocks(MACLINT_SOURCE_DIR "/corpus/fanuc");
    const auto outer = std::filesystem::path(MACLINT_SHARED) / "corpus" / "fanuc-macro";
    if (std::filesystem::is_directory(outer)) expect_no_cause_in_good_blocks(outer);
}

TEST(SyntaxErrors, WhatIsReadAndThenRefusedHasNoCauseInItsText) {
    for (const std::string code : {"G0 ZI1", "ZI#5", "GOTO N5", "IF[#1EQ1]GOTO O5"}) {
        const auto cause = fanuc::find_cause(code, {0, static_cast<Offset>(code.size())});
        EXPECT_FALSE(cause) << code << ": " << cause->subject << ": " << cause->cure;
    }
    EXPECT_TRUE(fanuc::find_cause("XY10.", {0, 5}));
    EXPECT_TRUE(fanuc::find_cause("GOTO X5", {0, 7}));
}

/// What is said of `GO1` behind forty errors, with `between` after each of them.
SyntaxErrorKind kind_behind_errors(const std::string& between) {
    std::string text;
    for (int i = 0; i < 40; ++i) text += "==\n" + between;
    return test::read(text + "GO1\n").syntax_errors.back().kind;
}

TEST(SyntaxErrors, AreNoNoiseWithGoodBlocksBetweenThem) {
    const SyntaxErrorKind read = test::read("GO1").syntax_errors.at(0).kind;
    EXPECT_NE(kind_behind_errors(""), read) << "in noise it is not read";
    EXPECT_EQ(kind_behind_errors("X1.\nX2.\nX3.\nX4.\n"), read) << "plain blocks";
    EXPECT_EQ(kind_behind_errors("#1=1\n#1=2\n#1=3\n#1=4\n"), read);
}

TEST(SyntaxErrors, AWordOfAnotherLanguageHasOneCauseInNoiseAndElsewhere) {
    for (const std::string code : {"ENDWHILE", "ENDIF", "ELSE", "NEXT", "WEND", "N27 ENDWHILE"}) {
        const SyntaxError alone = test::read(code).syntax_errors.at(0);
        const auto in_noise = fanuc::find_cause(code, {0, static_cast<Offset>(code.size())});
        ASSERT_TRUE(in_noise) << code;
        EXPECT_EQ(in_noise->kind, alone.kind) << code;
        EXPECT_EQ(in_noise->cure, alone.cure) << code;
    }
}

TEST(SyntaxErrors, TheEndOfFileMarkOfDosIsPassedOverAtTheEndAndToldInTheMiddle) {
    for (const char* end : {"\x1A", "%\n\x1A", "%\r\n\x1A\x1A", "%\x1A", "\x1A\n\n"})
        EXPECT_TRUE(test::read(std::string("O1\nG0X5.\nM30\n") + end).syntax_errors.empty()) << end;
    EXPECT_EQ(test::read("O1\nG0X5.\n\x1A\nM30\n").syntax_errors.size(), 1U);
}

TEST(SyntaxErrors, TheFirstLettersOfWhileAreNoCause) {
    for (const std::string good : {"WH[#1LE5]DO1", "WH[#1NE#2]DO2", "wh[#1LT5]DO1", "N5 WH[#1LE5] DO1"})
        EXPECT_FALSE(fanuc::find_cause(good, {0, static_cast<Offset>(good.size())})) << good;
    const std::string sign = "WH[#1<5]DO1";
    EXPECT_EQ(fanuc::find_cause(sign, {0, static_cast<Offset>(sign.size())}).value().kind,
              SyntaxErrorKind::symbolic_comparison);
}

TEST(SyntaxErrors, ARemarkWithBracketsAndASemicolonIsOneCause) {
    for (const std::string remark : {"(AUTHOR(A):ANNA E EVA; 27/05)", "(CUT(1) SLOWLY; X5; Z5)"}) {
        const auto errors = test::read("O1\n" + remark + "\nG0X5.\nM30\n").syntax_errors;
        ASSERT_EQ(errors.size(), 1U) << remark;
        EXPECT_EQ(errors[0].kind, SyntaxErrorKind::nested_comment) << remark;
    }
    // Here the ';' ends the block.
    EXPECT_EQ(lower("G0X1(A(B)); G0X2 (C)").find("unreadable"), lower("G0X1)\nG0X2").find("unreadable"));
    EXPECT_EQ(lower("G0X1(A(B) X5; Z5)"), lower("G0X1(A(B) X5\nZ5)"));
    EXPECT_EQ(lower("G0X1(A); G0X2(B)"), lower("G0X1\nG0X2"));
}

TEST(SyntaxErrors, ARemarkAfterASharpIsToldAndTheBlockBeforeItRead) {
    const ProgramFile file = test::read("G1X5. # to the left edge\n# second pass\n#slow down here\nM30\n");
    ASSERT_EQ(file.syntax_errors.size(), 3U);
    for (const SyntaxError& error : file.syntax_errors) EXPECT_EQ(error.kind, SyntaxErrorKind::bare_remark);
    EXPECT_EQ(file.syntax_errors[0].subject, "# to the left edge");
    EXPECT_EQ(file.syntax_errors[2].cure, "'#'");
    EXPECT_EQ(count_readable(file).unreadable, 0U);
    EXPECT_EQ(count_readable(file).blocks, 5U);
}

TEST(SyntaxErrors, ABlockOfANumberAloneIsReadWithoutWhatWouldStandBehindIt) {
    for (const std::string code : {"N10", "N10;", "N10;N20", ";", "N10 ;N20;"}) {
        const auto cause =
            fanuc::find_cause(code, {0, static_cast<Offset>(std::min(code.find(';'), code.size()))});
        EXPECT_FALSE(cause) << code << ": " << cause->subject;
        const Span behind{static_cast<Offset>(code.size()), static_cast<Offset>(code.size())};
        EXPECT_FALSE(fanuc::find_cause(code, behind)) << code;
    }
}

TEST(SyntaxErrors, BlanksBesideADecimalCommaAreNothingToTheControl) {
    for (const std::string code : {"G0X1,5Y0", "G0X1 ,5Y0", "G0X1, 5Y0", "G0X1\t,\t5Y0"}) {
        const auto cause = fanuc::find_cause(code, {0, static_cast<Offset>(code.size())});
        ASSERT_TRUE(cause) << code;
        EXPECT_EQ(cause->fault, faults::decimal_comma) << code;
        EXPECT_EQ(cause->cure, "1.5") << code;
        ASSERT_EQ(cause->remedy.changes.size(), 1U);
        std::string mended = code;
        const Span comma = cause->remedy.changes[0].span;
        mended.replace(comma.begin, comma.length(), cause->remedy.changes[0].text);
        EXPECT_EQ(mended, "G0X1.5Y0");
    }
}

TEST(SyntaxErrors, AVariableIsNoRemark) {
    for (const std::string code : {"#=1", "# 101=5", "#[#2+1]=5", "#DEPTH=5", "#ABS[#1]=2", "X# Y5", "# X5"})
        for (const SyntaxError& error : test::read(code).syntax_errors)
            EXPECT_NE(error.kind, SyntaxErrorKind::bare_remark) << code;
}

} // namespace
} // namespace maclint
