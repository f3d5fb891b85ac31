//! What blocks become in the program model.
#include "analyzer/program/tables.hpp"
#include "tests/dialect/reading.hpp"

#include <chrono>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::lower;
using test::read;
using test::read_as;
using ::testing::ElementsAre;

// ---- blanks

TEST(FanucBlanks, BetweenASkipMarkAndItsLevelMeanNothing) {
    for (const char* block : {"/2 #1=5", "/ 2 #1=5", "/\t2#1=5"}) {
        const auto file = read(block);
        EXPECT_EQ(std::get<Block>(file.programs.front().items.front()).skip_levels, 1U << 2U) << block;
        EXPECT_TRUE(file.syntax_errors.empty()) << block;
    }
    EXPECT_FALSE(read("/ 20 #1=5").syntax_errors.empty());
}

TEST(FanucBlanks, InANumberLeaveItUnknown) {
    EXPECT_EQ(lower("GOTO 1 0"), "jump unreadable");
    EXPECT_EQ(lower("#1=1 0"), "#1 := unreadable");
    EXPECT_EQ(lower("M98 P1 0"), "values unreadable; call M98 subprogram call unreadable");
    EXPECT_EQ(lower("GOTO 10"), "jump 10");
}

TEST(FanucBlanks, BehindALetterOForTheFigureAreOfTheNumber) {
    EXPECT_THAT(lower("X1 GO 1"), testing::HasSubstr("'GO 1' -> G0 1"));
    EXPECT_THAT(lower("GO 1"), testing::HasSubstr("letter-o-or-jump 'GO 1'"));
}

TEST(FanucBlanks, DoNotHideDataOfTheMachineBuilder) {
    for (const char* block : {"G10L60P1[*BDB 1]", "G 10 L60 P1 [*BDB 1]"})
        EXPECT_EQ(lower(block), "synchronise") << block;
}

// ---- variables

TEST(FanucAssignment, GoesWhereTheTableSaysThatTheNumberLives) {
    EXPECT_EQ(lower("#1=5"), "#1 := 5");
    EXPECT_EQ(lower("#101=#1"), "#101 := #1");
    EXPECT_EQ(lower("# 500 = 1.5"), "#500 := 1.5.");
    EXPECT_EQ(lower("#5221=0"), "machine #5221 := 0");
    EXPECT_EQ(lower("#[#1+2]=3"), "#[add(#1, 2)] := 3");
    EXPECT_EQ(lower("##1=3"), "#[#1] := 3\n! double-sharp '##1' -> #[#1]");
    EXPECT_EQ(lower("[#_ABSKP[1]]=3"), "#_ABSKP[1] := 3");
}

TEST(FanucAssignment, ToControlVariablesIsAnEffectOfItsOwn) {
    EXPECT_EQ(lower("#3000=101(NO DEPTH)"), "alarm 101");
    EXPECT_EQ(lower("#3006=1(CHECK TOOL)"), "pause 1");
    EXPECT_EQ(lower("#3003=1"), "single-block suppression=1");
    EXPECT_EQ(lower("#3004=7"), "feed-hold suppression=7");
}

TEST(FanucAssignment, ToNullIsIrregularAndDoesNothing) {
    EXPECT_EQ(lower("#0=5"), "\n! assignment-to-null '#0'");
}

TEST(FanucExpression, SystemVariablesReadModalStateOrTheMachine) {
    EXPECT_EQ(lower("#3=#4003"), "#3 := modal(distance mode)");
    EXPECT_EQ(lower("#9=#4109"), "#9 := modal(feed)");
    EXPECT_EQ(lower("#1=#5041"), "#1 := machine #5041");
    EXPECT_EQ(lower("#1=#0"), "#1 := vacant");
    EXPECT_EQ(lower("#1=#[#2]"), "#1 := #[#2]");
}

TEST(FanucExpression, BindsLikeTheControl) {
    EXPECT_EQ(lower("#1=#2+#3*#4"), "#1 := add(#2, multiply(#3, #4))");
    EXPECT_EQ(lower("#1=-#2+3"), "#1 := add(negate(#2), 3)");
    EXPECT_EQ(lower("#1=-3."), "#1 := -3.");
    EXPECT_EQ(lower("#1=#2AND7"), "#1 := bit-and(#2, 7)");
    EXPECT_EQ(lower("#1=#19MOD1"), "#1 := modulo(#19, 1)");
    EXPECT_EQ(lower("#1=[#2-[#3-1]]"), "#1 := subtract(#2, subtract(#3, 1))");
}

TEST(FanucExpression, KnowsFunctionsByNameAndAbbreviation) {
    EXPECT_EQ(lower("#1=SIN[#2]"), "#1 := sin(#2)");
    EXPECT_EQ(lower("#1=RO[#2]"), "#1 := round(#2)");
    EXPECT_EQ(lower("#1=atan[#2]/[#3]"), "#1 := atan2(#2, #3)");
    EXPECT_EQ(lower("#1=ATAN[#2,#3]"), "#1 := atan2(#2, #3)");
    EXPECT_EQ(lower("#1=POW[#2,3]"), "#1 := power(#2, 3)");
    EXPECT_EQ(lower("#1=COS#150"), "#1 := cos(#150)\n! function-without-brackets 'COS#150' -> COS[#150]");
}

// ---- control flow

TEST(FanucExpression, ManyNamesAreReadInLinearTime) {
    std::string text = "O1\n";
    for (int i = 0; i < 60'000; ++i) text += "[#_A" + std::to_string(i) + "]=1\n";
    const auto start = std::chrono::steady_clock::now();
    const ProgramFile file = read(text + "#1=#_A59999\n");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(3));
    EXPECT_EQ(describe(file.programs.at(0), file.programs[0].effects.back()), "#1 := #_A59999");
}

TEST(FanucCondition, EqualToNullAsksForVacancy) {
    EXPECT_EQ(lower("IF[#1EQ#0]GOTO10"), "if vacant?(#1) {jump 10}");
    EXPECT_EQ(lower("IF[#0NE#1]THEN#2=1"), "if set?(#1) {#2 := 1}");
    EXPECT_EQ(lower("IF[#1EQ0]GOTO10"), "if equal(#1, 0) {jump 10}");
}

TEST(FanucCondition, LogicBetweenComparisonsIsNotBitLogic) {
    EXPECT_EQ(lower("IF[[#1EQ1]AND[#2LT3]]GOTO5"), "if all-of(equal(#1, 1), less(#2, 3)) {jump 5}");
    EXPECT_EQ(lower("IF[#1EQ1]OR[#2LT3]GOTO5"),
              "if any-of(equal(#1, 1), less(#2, 3)) {jump 5}\n"
              "! logic-outside-brackets '[#1EQ1]OR[#2LT3]' -> [[#1EQ1]OR[#2LT3]]");
    EXPECT_EQ(lower("IF[#1AND4]GOTO5"), "if bit-and(#1, 4) {jump 5}\n"
                                        "! missing-construct '[#1AND4]' -> Compare, as in [#1 NE 0]");
}

/// Also in forms that the control does not take: what was meant is plain.
TEST(FanucIf, GuardsEverythingThatFollowsIt) {
    EXPECT_EQ(lower("IF[#21LT0]THEN#112=-1"), "if less(#21, 0) {#112 := -1}");
    EXPECT_EQ(lower("IF[#21LT0]#112=-1"),
              "if less(#21, 0) {#112 := -1}\n! consequence-without-then '#112=-1' -> THEN #112=-1");
    EXPECT_EQ(lower("IF[#1GT#2]THEN #1=#2 GOTO30"),
              "if greater(#1, #2) {#1 := #2; jump 30}\n! more-after-then 'GOTO30'");
    EXPECT_EQ(lower("IF[#6LE0]#3006=301(DEPTH)"),
              "if less-equal(#6, 0) {pause 301}\n! consequence-without-then '#3006=301' -> THEN #3006=301");
    EXPECT_EQ(lower("IF[#1EQ2]THEN M99"), "if equal(#1, 2) {return}\n! words-after-then 'M99'");
    EXPECT_EQ(lower("IF #1EQ2 GOTO5"),
              "if equal(#1, 2) {jump 5}\n! condition-without-brackets '#1EQ2' -> [#1EQ2]");
}

TEST(FanucLoop, OpensAndClosesByNumber) {
    EXPECT_EQ(lower("WHILE[#1LT5]DO1\nEND1"), "open while 1 less(#1, 5)\nclose while 1");
    EXPECT_EQ(lower("DO 2\nEND 2"), "open endless 2\nclose while 2");
    EXPECT_EQ(lower("WHILE[#1LT5]"), "open while less(#1, 5)\n! loop-without-do 'WHILE[#1LT5]' -> DO");
}

TEST(FanucJump, TakesNumbersVariablesAndExpressions) {
    EXPECT_EQ(lower("GOTO10"), "jump 10");
    EXPECT_EQ(lower("GOTO#1"), "jump #1");
    EXPECT_EQ(lower("GOTO[#1+10]"), "jump add(#1, 10)");
    EXPECT_EQ(lower("GOTO N10"), "jump 10\n! letter-in-jump 'N10' -> 10");
}

// ---- words

TEST(FanucWords, SetModalGroupsThenMove) {
    EXPECT_EQ(lower("G90G1X#1F200"), "distance mode=90; motion mode=1; feed=200; values #1; move");
    EXPECT_EQ(lower("X[#1+2]Y-#3"), "values add(#1, 2) negate(#3); move");
    EXPECT_EQ(lower("G#3"), "modal=#3");
    EXPECT_EQ(lower("S#19M3"), "spindle speed=#19; spindle=3");
    EXPECT_EQ(lower("ZI-[#2]"), "values negate(#2); move\n! missing-value 'Z'");
}

TEST(FanucWords, ThatAreNoTargetsDoNotMove) {
    EXPECT_EQ(lower("G4X#1"), "values #1; synchronise");
    EXPECT_EQ(lower("G10L2P1X0Y#1"), "values #1; synchronise");
    EXPECT_EQ(lower("G68X0Y0R#1"), "rotation=68; values #1");
    EXPECT_EQ(lower("G92S#1"), "values #1");
}

TEST(FanucWords, ThatMoveOnTheirOwnAccordAlsoStopLookAhead) {
    EXPECT_EQ(lower("G91G28Z0"), "distance mode=91; rapid move to reference; synchronise");
    EXPECT_EQ(lower("G27X0"), "rapid move to reference");
    EXPECT_EQ(lower("G29X#1"), "values #1; move to reference; synchronise");
    EXPECT_EQ(lower("G103P1"), "synchronise from here on");
    EXPECT_EQ(lower("G103P0"), "synchronise");
    EXPECT_EQ(lower("G103"), "synchronise");
    EXPECT_EQ(lower("G31Z-10.F100"), "feed=100; move; synchronise");
    EXPECT_EQ(lower("G53X0"), "move; synchronise");
}

TEST(FanucWords, LocalOffsetIsOnUntilItIsZero) {
    EXPECT_EQ(lower("G52X#24Y0"), "local offset=52; values #24");
    EXPECT_EQ(lower("G52X0Y0"), "local offset=0");
}

TEST(FanucWords, EndStopAndToolChange) {
    EXPECT_EQ(lower("M30"), "synchronise; end");
    EXPECT_EQ(lower("M01"), "synchronise; pause");
    EXPECT_EQ(lower("T5M6"), "synchronise; tool change");
    EXPECT_EQ(lower("M99"), "return");
    EXPECT_EQ(lower("M99P#1"), "values #1; return to #1");
}

TEST(FanucSkip, LeadingMarkIsTheBlocksAndALaterOneGuardsTheRest) {
    EXPECT_EQ(lower("/G#3"), "/1 modal=#3");
    EXPECT_EQ(lower("/2N5GOTO10"), "N5 /2 jump 10");
    EXPECT_EQ(lower("Z3./M99"), "move; if unreadable {return}");
}

// ---- calls

TEST(FanucCall, PassesArgumentsBySpecificationOne) {
    EXPECT_EQ(lower("G65P9010A1.B-#2Z[#3+1]L3"),
              "call G65 macro call 9010 A>#1=1. B>#2=negate(#2) Z>#26=add(#3, 1) times 3");
}

TEST(FanucCall, RepeatedCentreLettersBeginNewSets) {
    EXPECT_EQ(lower("G65A1.B2.I-3.I4.D5.P1000"),
              "call G65 macro call 1000 A>#1=1. B>#2=2. I>#4=-3. I>#7=4. D>#7=5.");
    EXPECT_EQ(lower("G65P1I1J2K3I4J5K6"), "call G65 macro call 1 I>#4=1 J>#5=2 K>#6=3 I>#7=4 J>#8=5 K>#9=6");
    EXPECT_EQ(lower("G65P1K1I2"), "call G65 macro call 1 K>#6=1 I>#7=2");
}

TEST(FanucCall, KeepsWordsBeforeTheCodeOutOfTheArguments) {
    EXPECT_EQ(lower("G90G65P1X5."), "distance mode=90; call G65 macro call 1 X>#24=5.");
}

TEST(FanucCall, ModalCallsAndTheirEnd) {
    EXPECT_EQ(lower("G66P9010Z-5."), "call G66 modal macro call 9010 Z>#26=-5.");
    EXPECT_EQ(lower("G67"), "modal macro call=67");
}

TEST(FanucCall, SubprogramsWithRepeats) {
    EXPECT_EQ(lower("M98P1000L2"), "call M98 subprogram call 1000 times 2");
    EXPECT_EQ(lower("M98P51002"), "call M98 subprogram call 1002 times 5");
    EXPECT_EQ(lower("M98P0021002"), "call M98 subprogram call 1002 times 2");
    EXPECT_EQ(lower("M98P1002"), "call M98 subprogram call 1002");
    EXPECT_EQ(lower("M98<PART>"), "call M98 subprogram call <PART>");
    EXPECT_EQ(lower("M198P7"), "call M198 subprogram call 7");
    EXPECT_EQ(describe(read_as("haas", "x.nc", "M98P51002")), "x:\ncall M98 subprogram call 51002\n");
}

TEST(FanucCall, WithoutProgramIsIrregular) {
    EXPECT_EQ(lower("G65X5."), "call G65 macro call ? X>#24=5.\n! call-without-program 'G65' -> P");
    EXPECT_EQ(lower("M98L2"), "call M98 subprogram call ? times 2\n! call-without-program 'M98' -> P");
    EXPECT_EQ(lower("M98Q100"), "if unreadable {jump 100}; call M98 subprogram call unreadable");
}

TEST(FanucCall, OfBlocksOfTheSameProgramMayJumpThereAndGoesOnHere) {
    EXPECT_EQ(lower("M97P#4L2"), "values #4; if unreadable {jump #4}; call M98 subprogram call unreadable");
}

TEST(FanucOutput, SendsVariables) {
    EXPECT_EQ(lower("DPRNT[X#100[53]*Y#101[53]]"), "exchange out #100 out #101");
    EXPECT_EQ(lower("POPEN"), "exchange");
}

// ---- blocks that cannot be read

TEST(FanucUnreadable, NamesWhatTheBlockMayDo) {
    EXPECT_EQ(lower("#1=ATAN(ABS(#2)/#3)"),
              "unreadable writes #1 writes #3\n! parenthesis-as-bracket 'ATAN' -> [ABS[#2]/#3]");
    EXPECT_EQ(lower("N5 #1=SIN(30)"), "N5 unreadable writes #1\n! parenthesis-as-bracket 'SIN' -> [30]");
    EXPECT_EQ(lower("IF[#1EQ2GOTO5"), "unreadable writes #1 jumps N5 opens-or-closes\n! bracket-mismatch '[' "
                                      "-> a ']' is missing before 'GOTO'");
    EXPECT_EQ(lower("WHLE[#1LT5]DO1"),
              "unreadable writes #1 opens-or-closes\n! unknown-keyword 'WHLE' -> WHILE");
    EXPECT_EQ(lower("IF[#1LTE2]GOTO5"),
              "unreadable writes #1 jumps N5 opens-or-closes\n! unknown-keyword 'LTE' -> LE");
    EXPECT_EQ(lower("G65P9010A["),
              "unreadable calls-or-returns\n! bracket-mismatch '[' -> its ']' is missing");
    EXPECT_EQ(lower("#1="), "unreadable writes #1\n! unreadable '=' -> a value after '='");
    EXPECT_EQ(lower("Increment pass counter"),
              "unreadable\n! unreadable 'Increment pass counter' -> ( ) around a remark");
}

TEST(FanucSyntaxErrors, OpenCommentSwallowsWhatFollows) {
    EXPECT_EQ(lower("G0X#1(TO THE EDGE\nG1X#2"), "motion mode=0; values #1; move\nmotion mode=1; values #2; "
                                                 "move\n! unterminated-comment '(TO THE EDGE' -> )");
    EXPECT_EQ(lower("#1=(NOT CLOSED"), "unreadable writes #1\n! unterminated-comment '(NOT CLOSED' -> )");
}

TEST(FanucSyntaxErrors, CommentsThatAreNoBracketsPass) {
    EXPECT_EQ(lower("#1=5(DEPTH)"), "#1 := 5");
    EXPECT_EQ(lower("#1=#2+(STEP)5"), "#1 := add(#2, 5)");
    EXPECT_EQ(lower("T (TOOL 5)M6"), "synchronise; tool change\n! missing-value 'T'");
}

TEST(FanucSyntaxErrors, BracketsBeyondTheLimitOfTheControl) {
    EXPECT_EQ(lower("#1=[[[[[#2]]]]]"), "#1 := #2");
    EXPECT_EQ(lower("#1=[[[[[[#2]]]]]]"), "#1 := #2\n! bracket-depth '['");
}

TEST(FanucSyntaxErrors, SymbolsInConditions) {
    EXPECT_EQ(lower("IF[#1>=2]GOTO5"), "if greater-equal(#1, 2) {jump 5}\n! symbolic-comparison '>=' -> GE");
}

// ---- programs

TEST(FanucProgram, NumberNameAndFileNameAreItsNames) {
    const ProgramFile file =
        read_as("fanuc", "parts/holder.nc", "%\nO0100(HOLDER)\nM99\nO<PART-2>\nM99\n:7\nM99\n%");
    ASSERT_EQ(file.programs.size(), 3U);
    EXPECT_EQ(file.programs[0].name, "O0100");
    EXPECT_EQ(file.programs[0].number, 100);
    EXPECT_THAT(file.programs[0].also_known_as, ElementsAre("O100", "holder"));
    EXPECT_EQ(file.programs[1].name, "<PART-2>");
    EXPECT_THAT(file.programs[1].also_known_as, ElementsAre("PART-2"));
    EXPECT_EQ(file.programs[2].number, 7);
}

TEST(FanucProgram, WithoutNumberIsNamedAfterItsFile) {
    const ProgramFile file = read_as("fanuc", "macros/O9100.NC", "G0X0\nM99");
    ASSERT_EQ(file.programs.size(), 1U);
    EXPECT_EQ(file.programs[0].name, "O9100");
    EXPECT_EQ(file.programs[0].number, 9100);
}

TEST(FanucProgram, NctHeadAndTailStandOnOneLineWithTheTapeMarks) {
    const ProgramFile file = read("%O9601(POCKET)\nG0X#1\nM99%\nREST OF TAPE");
    EXPECT_EQ(describe(file), "O9601:\n\nmotion mode=0; values #1; move\nreturn\n");
}

TEST(FanucProgram, LatheTextTakesTheLatheTwinOfTheControl) {
    const char* text = "O1\nG50S2000\nT0101\nG96S200M3\nG0X50.Z2.\nG90X40.Z-20.F.2\nM30";
    EXPECT_EQ(read(text).control->name, "fanuc-lathe");
    EXPECT_EQ(read_as("fanuc-30i", "x.nc", text).control->name, "fanuc-30i-lathe");
    EXPECT_EQ(read("O1\nT1M6\nG43H1Z50.\nG96S200\nM30").control->name, "fanuc");
    EXPECT_EQ(read("O1\nG0X50.Z2.\nG71P10Q20U.4W.1F.25\nN10G1X10.\nN20X20.\nM30").control->name,
              "fanuc-lathe");
}

TEST(FanucProgram, PeckDrillingOfAMillIsNoTurningCycle) {
    for (const char* text :
         {"O1\nG73X#24Y#25Z#26R#18Q2.P500F#9\nM99", "O1\nG0X#24Y#25\nG73Z-20.Q2000P500\nM99",
          "O1\nG73Z-20.Q2000P500\nM30", "O1\nG73X10.Q2.P500\nM30", "O1\nG96S200\nG1X5.Y[#1+2]\nM30"})
        EXPECT_EQ(read(text).control->name, "fanuc") << text;
    for (const char* text : {"O1\nG76X10.Z-20.R2.P100000Q.2F80.\nM99", "O1\nG76P1000Q.2\nM99",
                             "O1\nG74Z-20.R2.F100.\nM99", "O1\nG74X#24R2.\nM99", "O1\nG74R2.F80.\nM99"})
        EXPECT_EQ(read(text).control->name, "fanuc") << text;
    // Cycles of two blocks.
    for (const char* text : {"O1\nG74R0.2\nG74Z-20.Q3000F0.1\nM99", "O1\nN5G75R#1\nG75X20.P3000F0.1\nM99",
                             "O1\nG76P020060Q20R0.02\nG76X40.Z-20.P1200Q300F2.\nM99"})
        EXPECT_EQ(read(text).control->name, "fanuc-lathe") << text;
    EXPECT_EQ(read("O1\nG96S200\n#1=#_KEY[1]\nM30").control->name, "fanuc-lathe");
    EXPECT_EQ(read("O1\nG\t96 S200\nM30").control->name, "fanuc-lathe");
    EXPECT_EQ(read("O1\nG\t49\nG96S200\nM30").control->name, "fanuc");
    EXPECT_EQ(read("O1\nX1 Z1 T 0101\nU2\nM30").control->name, "fanuc-lathe");
    EXPECT_EQ(read("O1(TURN\rG96S200\rM30").control->name, "fanuc-lathe"); // a comment ends at CR, too
}

TEST(FanucComment, ThatSpeaksToMaclintIsRecordedWithItsSurroundings) {
    const std::string text = "O1\nG0X1. (maclint allow MAC301)\nN5 (MACLINT OFF)\n\n(OTHER)\nX2.\n";
    const ProgramFile file = read(text);
    ASSERT_EQ(file.comments.size(), 2U);
    const auto at = [&](Span span) { return text.substr(span.begin, span.length()); };
    EXPECT_EQ(at(file.comments[0].block), "G0X1. (maclint allow MAC301)");
    EXPECT_TRUE(file.comments[0].next_block.empty());
    EXPECT_EQ(at(file.comments[1].span), "(MACLINT OFF)");
    EXPECT_EQ(at(file.comments[1].block), "N5 (MACLINT OFF)");
    EXPECT_EQ(at(file.comments[1].next_block), "X2.");
}

/// The block beside the only comment, a bar, and the block after it.
std::string blocks_around_comment(const std::string& text) {
    const ProgramFile file = read(text);
    if (file.comments.size() != 1) return "no comment";
    const auto at = [&](Span span) { return text.substr(span.begin, span.length()); };
    return at(file.comments[0].block) + "|" + at(file.comments[0].next_block);
}

TEST(FanucComment, BesideABlockThatDoesNothingIsForTheNextOneToo) {
    for (const char* block : {"N5 (MACLINT)", "n 05(MACLINT)", "/ (MACLINT)", "/2 N5 (MACLINT)",
                              "(MACLINT) N5", "N5 (A) (MACLINT) (B)"})
        EXPECT_EQ(blocks_around_comment("O1\nG0X1.\n" + std::string(block) + "\n(B)\nX2.\nX3.\n"),
                  std::string(block) + "|X2.");
    for (const char* block : {"N5 X1. (MACLINT)", "(MACLINT) G0", "/ M1 (MACLINT)", "O2 (MACLINT)"})
        EXPECT_EQ(blocks_around_comment("O1\nG0X1.\n" + std::string(block) + "\nX2.\n"),
                  std::string(block) + "|");
}

TEST(FanucComment, BehindTheEndOfABlockIsForThatBlockToo) {
    EXPECT_EQ(blocks_around_comment("O1;\nX1.; (MACLINT)\nX2.;\n"), "X1.|X2.");
    EXPECT_EQ(blocks_around_comment("O1\nGOTO5; (A) (MACLINT)\nX2.\n"), "GOTO5|X2.");
    EXPECT_EQ(blocks_around_comment("O1\nX1.;\n(MACLINT)\nX2.;\n"), "|X2.");
    EXPECT_EQ(blocks_around_comment("(MACLINT)\nO1\nX2.;\n"), "|O1");
    EXPECT_EQ(blocks_around_comment("O1\nM30;\n(MACLINT)\n"), "|");
    EXPECT_EQ(blocks_around_comment("O1\nM30; (MACLINT)\n%\n"), "M30|");
}

} // namespace
} // namespace maclint
