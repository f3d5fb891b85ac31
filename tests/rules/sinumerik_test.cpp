//! What rules find in SINUMERIK texts.
#include "analyzer/dialect/dialect.hpp"
#include "rules/rule.hpp"
#include "tests/support/analysed.hpp"

#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

std::vector<Finding> findings(std::string_view code, std::string text) {
    return run_rules(*test::analyse_text("sinumerik", std::move(text)), {{find_rule(code)}}, 1);
}

TEST(SinumerikWrongBlocks, EachRaisesItsRule) {
    std::ifstream file(MACLINT_SOURCE_DIR "/grammar/sinumerik/test/wrong-blocks.txt");
    ASSERT_TRUE(file);
    std::size_t blocks = 0;
    for (std::string line; std::getline(file, line);) {
        const std::size_t tab = line.find('\t');
        if (tab == std::string::npos) continue;
        const std::string code = line.substr(tab + 1);
        ASSERT_NE(find_rule(code), nullptr) << line;
        const std::string text = "DEF INT COUNT_, LAST_\nDEF REAL DEPTH, TAB_[5]\nROW_0: G0 X0\n" +
                                 line.substr(0, tab) + "\nROW_1: G0 X1\nROW_2: M30\n";
        EXPECT_FALSE(findings(code, text).empty()) << line;
        ++blocks;
    }
    EXPECT_GT(blocks, 70U);
}

TEST(SinumerikPrograms, HaveNamesThatAreNoWords) {
    EXPECT_THAT(findings("SIN113", "PROC G1_VAR SAVE\nG0 X1\nM17\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC121", "PROC G1_VAR SAVE\nG0 X1\nM17\n"), IsEmpty());
}

TEST(SinumerikActions, BeginWithAnRParameterOrTheUnits) {
    EXPECT_THAT(findings("MAC121", "ID=2 WHENEVER R1<$AA_IM[X] DO M8\nG1 X5 F100\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC121", "ID=2 WHENEVER G710 $AA_IM[X]>5 DO M8\nG1 X5 F100\nM30\n"), IsEmpty());
}

TEST(SinumerikWords, NeedAnEqualsSignBeforeWhatIsCalculated) {
    const auto bracketed = findings("SIN105", "G1 X[R1] F100\nM30\n");
    ASSERT_THAT(bracketed, SizeIs(1));
    EXPECT_THAT(bracketed.front().message(), HasSubstr("'X=R1'"));
    EXPECT_THAT(findings("SIN105", "G1 X-R1 F100\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC121", "G1 X-R1 F100\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN105", "POS[X]=5 FA[X]=100\nM30\n"), IsEmpty());
    const auto radius = findings("SIN105", "G17 G0 X0 Y0\nG2 X10 Y0 R5. F100\nM30\n");
    ASSERT_THAT(radius, SizeIs(1));
    EXPECT_THAT(radius.front().message(), HasSubstr("'CR=5.'"));
    EXPECT_THAT(findings("SIN105", "G291\nG2 X10 Y0 R5. F100\nG290\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC121", "R5\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN105", "G96 S200 LIMS2000\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN105", "G0 X5\nLIMS2000\nM30\n"), IsEmpty()); // a program, perhaps
    EXPECT_THAT(findings("SIN105", "R5=3 G0 X5 CR=R5\nM30\n"), IsEmpty());
}

TEST(SinumerikTypes, AreThoseOfFunctionsToo) {
    const std::string begin = "DEF STRING[20] PART_=\"FLANGE_07\"\nDEF INT PART_NO\n";
    EXPECT_THAT(findings("SIN209", begin + "PART_NO=SUBSTR(PART_,7)\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN209", begin + "PART_NO=NUMBER(SUBSTR(PART_,7))\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN209", begin + "PART_=TOUPPER(PART_)\nM30\n"), IsEmpty());
}

TEST(SinumerikWords, OfOneGroupContradictEachOtherByNameToo) {
    EXPECT_THAT(findings("MAC514", "G18 DIAMON DIAMOF\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC514", "G1 X5 F100 CFC G641 cfin\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC514", "G18 DIAMON G64 SOFT DIAMON\nM30\n"), IsEmpty());
}

TEST(SinumerikJumps, TakeTheNearestLabelInTheirDirection) {
    EXPECT_THAT(findings("MAC301", "AGAIN: G0 X1\nGOTOF AGAIN\nAGAIN: M30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC301", "AGAIN: G0 X1\nGOTO AGAIN\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC301", "GOTOC NOWHERE\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC301", "DEF STRING[8] WHERE_\nGOTOF WHERE_\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC301", "GOTOF nExt\nNEXT: M30\n"), IsEmpty());
    const auto behind = findings("MAC301", "AGAIN: G0 X1\nN20 GOTOF AGAIN\nM30\n");
    ASSERT_THAT(behind, SizeIs(1));
    EXPECT_THAT(behind.front().message(), HasSubstr("on line 1"));
    EXPECT_THAT(findings("MAC301", "GOTOB N40\nN40 M30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC301", "GOTOF N040\nN40 M30\n"), IsEmpty());
}

TEST(SinumerikPairs, EachConstructHasItsOwnClose) {
    EXPECT_THAT(findings("MAC340", "IF R1==1\nWHILE R2<3\nR2=R2+1\nENDWHILE\nELSE\nENDIF\n"), IsEmpty());
    EXPECT_THAT(findings("MAC340", "IF R1==1 GOTOF NEXT\nNEXT: M30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC340", "REPEAT\nUNTIL R1>5\nPART: G0 X1\nREPEAT PART P=3\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC340", "LOOP\nGOTOF OUT_\nOUT_: M30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC340", "IF R1==1\nR2=1\nELSE\nR2=2\nELSE\nR2=3\nENDIF\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC340", "IF R1==(5\nENDIF\n"), IsEmpty()); // it may have opened there
}

TEST(SinumerikCalls, GiveNoMoreThanTheProgramTakes) {
    const std::string called = "%_N_SLOT_SPF\nPROC SLOT(REAL WIDTH, VAR INT STATE_)\nSTATE_=WIDTH\nM17\n";
    const auto main = [&](const std::string& call) {
        return "%_N_A_MPF\nDEF INT DONE\n" + call + "\nM30\n" + called;
    };
    EXPECT_THAT(findings("MAC472", main("SLOT(5,DONE)")), IsEmpty());
    EXPECT_THAT(findings("MAC472", main("SLOT(,DONE)")), IsEmpty());
    EXPECT_THAT(findings("MAC472", main("SLOT(5)")), IsEmpty());
    EXPECT_THAT(findings("MAC472", main("SLOT(5,DONE,1)")), SizeIs(1));
    EXPECT_THAT(findings("MAC472", main("SLOT(5,7)")), SizeIs(1));
}

TEST(SinumerikModes, SaveGivesTheCallersBack) {
    EXPECT_THAT(findings("MAC501", "PROC STEP_UP\nG91 G0 Z10\nM17\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC501", "PROC STEP_UP SAVE\nG91 G0 Z10\nM17\n"), IsEmpty());
    EXPECT_THAT(findings("MAC501", "PROC STEP_UP\nG90 G0 Z10\nRET\n"), IsEmpty());
}

TEST(SinumerikCalls, GiveWhatTheParametersTake) {
    const std::string called = "%_N_SLOT_SPF\nPROC SLOT(REAL WIDTH, VAR INT STATE_, STRING[9] NAME_=\"A\")\n"
                               "STATE_=WIDTH\nM17\n";
    const auto main = [&](const std::string& call) {
        return "%_N_A_MPF\nDEF INT DONE\nDEF REAL DEPTH\nDEF STRING[9] TEXT_\n" + call + "\nM30\n" + called;
    };
    EXPECT_THAT(findings("SIN402", main("SLOT(5,DONE)")), IsEmpty());
    EXPECT_THAT(findings("SIN402", main("SLOT(,DONE,TEXT_)")), IsEmpty());
    EXPECT_THAT(findings("SIN402", main("SLOT(5)")), SizeIs(1));
    EXPECT_THAT(findings("SIN402", main("SLOT(5,,TEXT_)")), SizeIs(1));
    EXPECT_THAT(findings("SIN404", main("SLOT(5,DEPTH)")), SizeIs(1));
    EXPECT_THAT(findings("SIN404", main("SLOT(5,R1)")), IsEmpty()); // nobody says of which type it is
    EXPECT_THAT(findings("SIN209", main("SLOT(TEXT_,DONE)")), SizeIs(1));
    EXPECT_THAT(findings("SIN209", main("SLOT(5,DONE,7)")), SizeIs(1));
    EXPECT_THAT(findings("SIN209", main("SLOT(5,DONE,\"B\"<<DEPTH)")), IsEmpty());
    EXPECT_THAT(findings("SIN407", main("SLOT(5,DONE)")), IsEmpty());
    EXPECT_THAT(findings("SIN403", main("SLOT(5,DONE)")), IsEmpty()); // what is left out has a default
    EXPECT_THAT(findings("SIN405", "%_N_A_MPF\nDEF INT DONE\nEXTERN SLOT(REAL,VAR INT,STRING[9])\n"
                                   "SLOT(5,DONE)\nM30\n" +
                                       called),
                IsEmpty());
    EXPECT_THAT(findings("SIN405", "%_N_A_MPF\nDEF INT DONE\nEXTERN SLOT(REAL,INT,STRING[9])\n"
                                   "SLOT(5,DONE)\nM30\n" +
                                       called),
                SizeIs(1));
}

/// Each raises its rule alone.
constexpr std::pair<std::string_view, std::string_view> shared_rules[] = {
    {"MAC318", "LOOP\nG1 X10 F100\nX0\nENDLOOP\nM30\n"},
    {"MAC337", "IF R1==1\nG1 X10 F100\nELSE\nG1 X10 F100\nENDIF\nM30\n"},
    {"MAC413", "MCALL DRILL\nG0 X10\nM30\n"},
    {"MAC462", "N10 G0 X1\nN20 G0 X2\nN20 G0 X3\nGOTOB N20\n"},
    {"MAC506", "PROC PART\nDEF INT OLD\nOLD=$P_GG[14]\nG91\nOLD=5\nG0 X5\nG[14]=OLD\nM17\n"},
    {"MAC507", "PROC PART\nDEF INT OLD\nOLD=$P_GG[14]\nG91\nG0 X5\nM17\n"},
    {"MAC511", "G17 G90\nG0 X0 Y0\nG41 G2 X20 Y20 CR=20 F100\nG40 G1 X0\nM30\n"},
    {"MAC514", "G90 G91 G0 X5\nG90\nM30\n"},
    {"MAC517", "PROC PART\nDEF INT OLD\nG91\nOLD=$P_GG[14]\nG0 X5\nG[14]=OLD\nM17\n"},
    {"MAC559", "G1 X5 Y5 X6 F100\nM30\n"},
    {"MAC703", "DEF REAL SIDE=-4\nG1 X=SQRT(SIDE) F100\nM30\n"},
    {"MAC704", "G1 X=TAN(90) F100\nM30\n"},
};

TEST(SinumerikShared, RulesOfAllLanguagesHold) {
    for (const auto& [code, text] : shared_rules)
        EXPECT_FALSE(findings(code, std::string(text)).empty()) << code;
}

TEST(SinumerikArrays, AreReadWithinTheirBounds) {
    const std::string define = "DEF REAL PLACE[4]\nDEF INT HOLE\nDEF INT GRID[2,3]\n";
    EXPECT_THAT(findings("SIN207", define + "G0 X=PLACE[0] Y=PLACE[3]\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN207", define + "G0 X=PLACE[4]\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN207", define + "GRID[1,3]=5\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN207", define + "GRID[1,2]=5\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN207", define + "FOR HOLE=0 TO 4\nIF HOLE<4\nG0 X=PLACE[HOLE]\nENDIF\nENDFOR\n"),
                IsEmpty());
    EXPECT_THAT(findings("SIN207", define + "FOR HOLE=0 TO 4\nG0 X=PLACE[HOLE]\nENDFOR\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN207", define + "HOLE=R5\nG0 X=PLACE[HOLE]\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN208", "DEF STRING[8] NAME_\nNAME_[0]=\"A\"\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN208", "PROC SUM(REAL PLACE[,])\nR1=PLACE[1,2]\nM17\n"), IsEmpty());
    EXPECT_THAT(findings("SIN208", "PROC SUM(REAL PLACE[])\nR1=PLACE[1,2]\nM17\n"), SizeIs(1));
}

TEST(SinumerikFrames, AreInForceUntilTheyAreTakenBack) {
    EXPECT_THAT(findings("MAC502", "TRANS X10\nG0 X0\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC502", "TRANS X10\nG0 X0\nROT\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC502", "AROT RPL=45\nG0 X0\nATRANS X5\nTRANS\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC502", "TRANS X10\nG0 X0\n$P_PFRAME=CTRANS()\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC502", "PROC PART SAVE\nTRANS X10\nG0 X0\nM17\n"), IsEmpty());
    EXPECT_THAT(findings("SIN504", "TRANS X10\nROT RPL=45\nG0 X0\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN504", "TRANS X10\nAROT RPL=45\nG0 X0\n"), IsEmpty());
    EXPECT_THAT(findings("SIN504", "TRANS X10\nG0 X0\nROT RPL=45\nG0 X0\n"), IsEmpty());
    EXPECT_THAT(findings("SIN504", "TRANS X10\nTRANS\nG0 X0\n"), IsEmpty());
    EXPECT_THAT(findings("SIN504", "TRANS X10\nFOR R1=1 TO 5\nROT RPL=45\nG0 X0\nENDFOR\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN504", "TRANS X10\nAGAIN: ROT RPL=45\nG0 X0\n"), IsEmpty());
}

TEST(SinumerikDistances, AreNoPositions) {
    EXPECT_THAT(findings("SIN505", "G91\nX=$P_EP[X]\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN505", "G91 X5\nG90\nX=$P_EP[X]\n"), IsEmpty());
    EXPECT_THAT(findings("SIN505", "G91 X5\nAGAIN: X=$P_EP[X]\n"), IsEmpty());
    EXPECT_THAT(findings("SIN505", "G91\nX=10-$P_EP[X]\n"), IsEmpty());
}

TEST(SinumerikMachine, KnowsWhereTheToolIs) {
    const std::string start = "G17 G90 G54\nG0 X20 Y0\n";
    EXPECT_THAT(findings("MAC558", start + "G3 X20 Y0 CR=20 F100\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC558", start + "G0 AP=45 RP=30\nG3 X20 Y0 CR=20 F100\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC558", start + "TRANS X5\nG3 X20 Y0 CR=20 F100\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC510", start + "G41 G1 Z-5 F100\nG40\nX40\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC510", start + "G41 G1 X10 F100\nG40 X40\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN502", start + "G41 G1 X10 F100\nM6\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN502", start + "G41 G1 X10 F100\nG40 X20\nM6\nM30\n"), IsEmpty());
    const std::string turret = start + "G41 G1 X10 F100\nG0 X90\n";
    EXPECT_THAT(findings("SIN502", turret + "T=\"FINISH\" D1\nG40\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN502", turret + "T3 D1\nG40\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN502", turret + "T=\"FINISH\"\nG40\nM30\n"), IsEmpty()); // made ready, perhaps
    EXPECT_THAT(findings("SIN502", turret + "T=\"FINISH\" D1\nG40 G0 X95\nM6\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN502", turret + "T=\"FINISH\" D1\nG40 G0 X95\nCHANGE_IT\nM30\n"), IsEmpty());
}

TEST(SinumerikMachine, CallsCyclesWithoutCompensation) {
    const std::string start = "G17 G90 G54\nG0 X20 Y0\nG41 G1 X10 F100\n";
    EXPECT_THAT(findings("SIN411", start + "CYCLE82(50,0,2,-10,,1)\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN411", start + "MCALL CYCLE82(50,0,2,-10,,1)\nX5\nMCALL\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN411", start + "G40 X30\nCYCLE82(50,0,2,-10,,1)\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN411", "%_N_A_MPF\n" + start + "CYCLE82(5)\nG40 X1\nM30\n" +
                                       "%_N_CYCLE82_SPF\nPROC CYCLE82(REAL DEPTH)\nM17\n"),
                IsEmpty()); // the shop's own
}

TEST(SinumerikCycles, ChangeWhatTheirRowsSay) {
    const std::string arc = "G0 X0 Y0\nG1 F100 X10\nG3 X10 Y20 CR=8\nM30\n";
    EXPECT_THAT(findings("MAC522", "G17 G90 G54\nCYCLE832(0.05,_ROUGH,1)\n" + arc), SizeIs(1));
    EXPECT_THAT(findings("MAC522", "G17 G90 G54\nCYCLE800()\n" + arc), SizeIs(1));
    EXPECT_THAT(findings("MAC522", "G17 G90 G54\nCYCLE977(101,,1)\n" + arc), SizeIs(1));
    EXPECT_THAT(findings("MAC522", "G17 G90 G54\nCYCLE197(1)\n" + arc), IsEmpty()); // the machine's
    EXPECT_THAT(findings("MAC522", "G17 G90 G54\nG0 X0 Y0\nCYCLE832()\nG3 X10 Y20 CR=8 F100\nM30\n"),
                IsEmpty()); // where the tool is then nobody knows
    EXPECT_THAT(findings("MAC502", "TRANS X5\nG0 X0\nCYCLE800()\nG0 X5\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC502", "TRANS X5\nG0 X0\nCYCLE832()\nG0 X5\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC502", "TRAORI\nG0 X0\nCYCLE832()\nG0 X5\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC502", "TRAORI\nG0 X0\nCYCLE800()\nG0 X5\nM30\n"), SizeIs(1));
}

TEST(SinumerikTaps, WantASpindleUnderPositionControl) {
    const std::string tap = "G331 Z-20 K1.5 S400\nG332 Z5 K1.5\nM30\n";
    EXPECT_THAT(findings("SIN506", "G17 G54\n; SPOS is missing\n" + tap), SizeIs(1));
    for (const char* block : {"SPOS=0", "spos=90", "SPOS[2]=0", "SPOSA=0", "M19", "M2=70", "PUT_IT_RIGHT"})
        EXPECT_THAT(findings("SIN506", "G17 G54\n" + std::string(block) + "\n" + tap), IsEmpty()) << block;
    EXPECT_THAT(findings("SIN506", "PROC TAP\nG331 Z-20 K1.5 S400\nG332 Z5 K1.5\nM17\n"), IsEmpty());
}

TEST(SinumerikMachine, WantsACentreOfEachArc) {
    const std::string start = "G17 G90 G54\nG0 X0 Y0\nG1 X10 F100\n";
    EXPECT_THAT(findings("MAC522", start + "G2 X20 Y10\nM30\n"), SizeIs(1));
    for (const char* arc : {"G2 X20 Y10 CR=10", "G2 X20 Y10 J10", "G2 X20 Y10 AR=90", "G2 AP=90 RP=5", "G2",
                            "CIP X20 Y10 I1=15 J1=2", "CT X20 Y10", "G2 X20 Y0 I=R1", "G2 X20 Y10 I=AC(20)"})
        EXPECT_THAT(findings("MAC522", start + arc + "\nM30\n"), IsEmpty()) << arc;
}

TEST(SinumerikMachine, CountsCentresFromTheZeroWhereTheySaySo) {
    const std::string start = "G17 G90 G54\nG0 X10 Y20\nG1 Z-2 F100\n";
    const auto arcs = [&](const std::string& arc) { return findings("MAC522", start + arc + "\nM30\n"); };
    EXPECT_THAT(arcs("G2 X30 Y20 I=AC(20) J=AC(20)"), IsEmpty());
    EXPECT_THAT(arcs("G2 X30 Y20 I=AC(20) J0"), IsEmpty());
    EXPECT_THAT(arcs("G2 X30 Y20 I=AC(15) J=AC(20)"), SizeIs(1));
    EXPECT_THAT(arcs("G2 X30 Y20 I=AC(10) J=AC(20)"), SizeIs(1)); // its start
    EXPECT_THAT(arcs("G2 X30 Y20 I=AC(-10) J=AC(20)"), SizeIs(1));
    EXPECT_THAT(arcs("G2 X30 Y20 I=AC(R1) J=AC(20)"), IsEmpty());
    // Nobody knows the start; lengths in X may be diameters.
    EXPECT_THAT(arcs("X=R1\nG2 X30 Y20 I=AC(15) J=AC(20)"), IsEmpty());
    EXPECT_THAT(arcs("G18 G0 X10 Z20\nG2 X30 Z20 I=AC(15) K=AC(20)"), IsEmpty());
}

TEST(SinumerikMachine, LosesItsPlaceWhereWordsDoNotSayIt) {
    const std::string start = "G17 G90 G54\nG0 X90 Y20\nG1 Z-2 F100\n";
    EXPECT_THAT(findings("MAC522", start + "G3 AR=180 I-5 J0\nG3 X78 Y20 CR=1.5\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC522", start + "G74 X1=0 Y1=0\nG3 X78 Y20 CR=1.5\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC522", start + "G3 X78 Y20 CR=1.5\nM30\n"), SizeIs(1));
}

TEST(SinumerikCodes, OfOtherControlsAreTold) {
    EXPECT_THAT(findings("SIN117", "G43 Z50 H1\nG80\nM30\n"), SizeIs(2));
    EXPECT_THAT(findings("SIN117", "G43 Z50 H1\nG43 Z20\nM30\n"), IsEmpty()); // the machine may have one
    EXPECT_THAT(findings("SIN117", "DEFINE G43 AS D1\nDEFINE G80 AS MCALL\nG43 Z50\nG80\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN117", "G291\nG43 Z50 H1\nG80\nG290\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC514", "G0 X5 M3 M8 M4\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC514", "S500 M3\nG0 X5 M8 M3\nG0 Z=R1 M9 M5\nM30\n"), IsEmpty());
}

TEST(SinumerikPrograms, BeginWithProc) {
    EXPECT_THAT(findings("SIN201", "G90\nPROC PART SAVE\nG0 X5\nM17\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN201", "; a part\nPROC PART SAVE\nG0 X5\nM17\n"), IsEmpty());
    EXPECT_THAT(findings("SIN113", "PROC A(REAL WIDTH)\nG0 X5\nM17\n"), SizeIs(1));
}

TEST(SinumerikSlips, AreToldOnceAndByTheirName) {
    EXPECT_THAT(findings("MAC106", "G0 X8O Y50\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC109", "G0 X8O Y50\nM30\n"), IsEmpty());
    const auto radius = findings("SIN105", "G17 G2 X5 Y5 CR10 F100\nM30\n");
    ASSERT_THAT(radius, SizeIs(1));
    EXPECT_THAT(radius.front().message(), HasSubstr("'CR=10'"));
    EXPECT_THAT(
        findings("MAC321",
                 "DEF REAL LEVEL\nREPEAT\nLEVEL=LEVEL+1.5\nG1 Z=LEVEL F200\nUNTIL LEVEL<=-5.5\nM30\n"),
        IsEmpty()); // MAC320 tells it
}

TEST(SinumerikCouplings, AreSwitchedOffAgain) {
    EXPECT_THAT(findings("MAC502", "TRANSMIT\nG1 X5 F100\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC502", "TRANSMIT\nG1 X5 F100\nTRAFOOF\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC502", "PROC PART\nRNDM=2\nG1 X5 F100\nM17\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC502", "PROC PART\nRNDM=2\nG1 X5 F100\nRNDM=0\nM17\n"), IsEmpty());
    EXPECT_THAT(findings("MAC502", "RNDM=2\nG1 X5 F100\nM30\n"), IsEmpty()); // gone with the job
    EXPECT_THAT(findings("MAC502", "COUPON(S2,S1)\nG0 X5\nCOUPOF(S2,S1)\nM30\n"), IsEmpty());
}

TEST(SinumerikMachine, RunsNoDefinitions) {
    EXPECT_THAT(findings("MAC510", "%_N_SHOP_DEF\nN1\nT=\"\n"), IsEmpty());
}

TEST(SinumerikNames, OneLetterOffAreTold) {
    const std::string define = "DEF REAL RIM_WIDTH, SIDE_1, BORE_[5]\nRIM_WIDTH=5\n";
    EXPECT_THAT(findings("SIN203", define + "G1 X=RIM_WIDHT F100\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN203", define + "RIM_WIDT=3\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN203", define + "G1 X=SIDE_2 F100\n"), IsEmpty()); // another one of a row
    EXPECT_THAT(findings("SIN203", define + "G1 X=RIM_WIDE F100\n"), IsEmpty());
    EXPECT_THAT(findings("SIN203", define + "R1=RIM_WIDHT R2=RIM_WIDHT\n"), IsEmpty()); // of the machine
}

TEST(SinumerikNames, AreThoseOfTheFile) {
    EXPECT_THAT(findings("SIN408", "%_N_SLOT_SPF\nPROC _N_SLOT_SPF\nM17\n"), IsEmpty());
    EXPECT_THAT(findings("SIN408", "%_N_SLOT_SPF\nPROC GROOVE\nM17\n"), SizeIs(1));
    const auto of_folders =
        findings("SIN408", "%_N_SHOP_CYCLES__GRINDING__RIGHT_GRIND_SPF\nPROC LEFT_GRIND\nM17\n");
    ASSERT_THAT(of_folders, SizeIs(1));
    EXPECT_THAT(of_folders.front().message(), HasSubstr("the program is RIGHT_GRIND"));
    EXPECT_THAT(findings("SIN408", "%_N_CMA__DRESS_SPF\nPROC DRESS\nM17\n"),
                IsEmpty()); // a folder's name before it
    EXPECT_THAT(findings("SIN408", "%_N_UNDRESS_SPF\nPROC DRESS\nM17\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN408", "%_N_DRESS_N_SPF\nPROC DRESS\nM17\n"), SizeIs(1)); // another program
    EXPECT_THAT(findings("SIN408", "PROC GROOVE\nM17\n"),
                IsEmpty()); // the text has no name as the control has
    EXPECT_THAT(findings("SIN201", "INI[2] \xE5\xB7\xA5\nDEF INT ROW\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN204", "R1=$MC_ANY_DATA[0] R2=$SA_ANY R3=$P_UIFR[1,X,TR]\n"), IsEmpty());
}

TEST(SinumerikSlips, WordsOfTheLanguageAreMeant) {
    EXPECT_THAT(findings("MAC118", "DFE INT ROW_NO\nROW_NO=1\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC118", "DE STRING[20] TEXT_\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC118", "PORC SLOT SAVE\nM17\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC118", "EXTREN SLOT(REAL)\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC118", "G0 X1\nPORC SLOT\nM17\n"), IsEmpty()); // no place for a PROC
    EXPECT_THAT(findings("MAC118", "DFE X40\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN201", "DFE INT ROW_NO\nDEF INT LAST_\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC106", "G0 Y5\nXO\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC106", "SO\nM30\n"), IsEmpty()); // a program
}

TEST(SinumerikSlips, WhatCannotBeReadMayHaveParametersAndSave) {
    const std::string main = "%_N_A_MPF\nSLOT(5)\nM30\n%_N_SLOT_SPF\n";
    EXPECT_THAT(findings("SIN407", main + "G91 G0 Z5\nM17\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN407", main + "PORC SLOT(REAL DEPTH) SAVE\nG91 G0 Z5\nM17\n"), IsEmpty());
    EXPECT_THAT(findings("SIN407", main + "PROC SLOT(REAL DEPTH SAVE\nG91 G0 Z5\nM17\n"), IsEmpty());
    EXPECT_THAT(findings("MAC501", "PORC STEP_UP SAVE\nG91 G0 Z10\nM17\n"), IsEmpty());
    EXPECT_THAT(findings("MAC501", "PORC STEP_UP\nG91 G0 Z10\nM17\n"), SizeIs(1));
}

TEST(SinumerikSlips, ACommandIsMeantWhereNoProgramHasTheName) {
    EXPECT_THAT(findings("SIN203", "TRNAS X40\nG0 X0\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN203", "STOPPRE\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN203", "ARTO RPL=45\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN203", "%_N_A_MPF\nSTOPPRE\nM30\n%_N_STOPPRE_SPF\nM17\n"), IsEmpty());
    EXPECT_THAT(findings("SIN203", "DEFINE STOPPRE AS M5\nSTOPPRE\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN203", "PROBES\nTRANS2\nM30\n"), IsEmpty());
}

TEST(SinumerikSlips, AProgramIsMeantThatExternNames) {
    EXPECT_THAT(findings("SIN203", "EXTERN DRILL_ROW(REAL)\nDRILL_RWO(5)\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN203", "EXTERN DRILL_1(REAL)\nDRILL_2(5)\nM30\n"), IsEmpty());
}

TEST(SinumerikSlips, AFunctionOrConstantIsMeantInACalculation) {
    const std::string text = "DEF STRING[9] NAME_\nDEF BOOL DONE\nDEF FRAME BASE_\n";
    EXPECT_THAT(findings("SIN203", text + "IF ISNUMER(NAME_) GOTOF ROW_1\nROW_1: M30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN203", text + "BASE_=CTRAN(X,5)\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN203", text + "DONE=FLASE\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN203", text + "DONE=TRUE R1=SIN(30)\nM30\n"), IsEmpty());
}

TEST(SinumerikWords, LoseTheEqualsSignBeforeANameToo) {
    const std::string text = "DEF REAL LENGTH\n";
    EXPECT_THAT(findings("SIN105", text + "G1 XLENGTH F500\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN105", text + "G1 XIC(20) F500\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN105", text + "XLENGTH\nM30\n"), IsEmpty()); // a program may have the name
    EXPECT_THAT(findings("SIN105", text + "G1 XWIDTH F500\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN203", text + "G1 XLENGTH F500\nM30\n"), IsEmpty());
}

TEST(SinumerikFunctions, TakeTextsOrNumbers) {
    const std::string text = "DEF STRING[9] NAME_\nDEF REAL WAY\nDEF INT STATE\n";
    EXPECT_THAT(findings("SIN209", text + "R1=STRLEN(WAY)\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN209", text + "R1=SIN(\"30\")\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN209", text + "R1=STRLEN(NAME_) R2=NUMBER(NAME_)\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN209", text + "WRITE(STATE,\"LOG\",WAY)\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC729", text + "WRITE(\"LOG\",NAME_)\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC729", text + "SETAL(65000,,\"LOG\")\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC729", text + "X=IC(5,2) Y=AC(5)\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC729", text + "WRITE(STATE,\"LOG\",NAME_)\nSETAL(65000)\nM30\n"), IsEmpty());
}

TEST(SinumerikDifferences, OfRoundedNumbersAreHardlyEverZero) {
    const auto told = [](const std::string& condition) {
        return findings("SIN701", "R1=R10/3\nR2=R11/7\nR3=R12\nIF " + condition +
                                      " GOTOF DONE\nG0 X=R1 Y=R2 Z=R3\nDONE: M30\n");
    };
    EXPECT_THAT(told("R1-R2==0"), SizeIs(1));
    EXPECT_THAT(told("0<>R1-R3"), SizeIs(1));
    EXPECT_THAT(told("R1==R2"), IsEmpty());     // within the tolerance
    EXPECT_THAT(told("R1-R2<=0"), IsEmpty());   // the one digit does not matter
    EXPECT_THAT(told("R3-R13==0"), IsEmpty());  // both as somebody has set them
    EXPECT_THAT(told("R1-R2==0.5"), IsEmpty()); // within the tolerance, too
    EXPECT_THAT(told("ABS(R1-R2)<0.001"), IsEmpty());
    EXPECT_THAT(told("R1/R2-TRUNC(R1/R2)==0"), IsEmpty()); // whether it is whole
    EXPECT_THAT(told("R1/R2-TRUNC(R1/R3)==0"), SizeIs(1));
}

TEST(SinumerikArrays, TakeNoMoreValuesThanThereArePlacesFromAnElementOn) {
    const std::string text = "DEF INT ROW[5], MAP[2,3]\n";
    const auto beyond = findings("SIN213", text + "ROW[3]=SET(1,2,3)\nM30\n");
    ASSERT_THAT(beyond, SizeIs(1));
    EXPECT_THAT(beyond.front().message(), HasSubstr("more than the 2 places from there on"));
    EXPECT_THAT(findings("SIN213", text + "ROW[2]=SET(1,2,3)\nROW[R1]=SET(1,2,3,4,5,6)\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN213", text + "MAP[1,1]=(1,2,3)\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN213", text + "MAP[0,1]=SET(1,2,3)\nM30\n"), IsEmpty());
}

TEST(SinumerikParameters, AreArraysOrSingleVariables) {
    const std::string sub =
        "%_N_SUM_UP_SPF\nPROC SUM_UP(VAR REAL ROW[5],VAR REAL TOTAL)\nTOTAL=ROW[0]\nM17\n";
    const auto called = [&](const std::string& arguments) {
        return findings("SIN404", "%_N_A_MPF\nDEF REAL ROW[5], SUM_\nSUM_UP(" + arguments + ")\nM30\n" + sub);
    };
    EXPECT_THAT(called("ROW,SUM_"), IsEmpty());
    EXPECT_THAT(called("SUM_,ROW"), SizeIs(2));
    EXPECT_THAT(called("ROW,ROW[1]"), IsEmpty());
}

TEST(SinumerikNames, HaveTwoLettersInDefinitions) {
    const auto told = findings("SIN113", "DEF INT G6_OLD,COUNT_\nM30\n");
    ASSERT_THAT(told, SizeIs(1));
    EXPECT_THAT(findings("MAC121", "DEF INT G6_OLD,COUNT_\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN113", "DEF INT COUNT_=5, LAST_\nDEF REAL WAY=-R1\nM30\n"), IsEmpty());
}

TEST(SinumerikNames, OfAxesAreTheMachines) {
    const std::string text =
        "R1=$AA_IW[LOADER] POS[LOADER]=5 RELEASE(LOADER)\nLOADER=10\nG0 X=_OVR[2]\nM30\n";
    EXPECT_THAT(test::analyse_text("sinumerik", text)->programs().front().program().unknown_names, IsEmpty());
    const auto read = test::analyse_text("sinumerik", "G0 X=LOADER Y=PLACES[2]\nM30\n");
    EXPECT_THAT(read->programs().front().program().unknown_names, SizeIs(2));
}

TEST(SinumerikCycles, LeaveModesAsTheyAre) {
    const std::string arc = "G0 X-30 Y-20\nG1 X0 Y-15 F200\nY20\nG2 X0 Y20 CR=20\nM30\n";
    EXPECT_THAT(findings("MAC558", "G17 G90 G54\nCYCLE82(20,0,2,-12,,0.3)\n" + arc), SizeIs(1));
    EXPECT_THAT(findings("MAC558", "G17 G90 G54\nOF_THE_SHOP(20)\n" + arc), IsEmpty());
}

TEST(SinumerikCycles, DrillAwayFromWhereTheyDrawBack) {
    const auto cycle = [](const std::string& planes) {
        return findings("SIN412", "G17 G90\nCYCLE82(" + planes + ",,0.3)\nM30\n");
    };
    EXPECT_THAT(cycle("50,0,2,20"), SizeIs(1));
    EXPECT_THAT(cycle("-50,0,2,-20"), SizeIs(1));
    EXPECT_THAT(cycle("50,0,2,-20"), IsEmpty());
    EXPECT_THAT(cycle("-50,0,2,20"), IsEmpty());
    EXPECT_THAT(cycle("50,0,2,0"), IsEmpty());
    EXPECT_THAT(cycle("0,0,2,20"), IsEmpty());
    EXPECT_THAT(cycle("50,0,2,R1"), IsEmpty());
    EXPECT_THAT(cycle("50,0,1,8,,0.6,10,1,12"), IsEmpty()); // a newer form, where 8 is a diameter
    EXPECT_THAT(findings("SIN412", "%_N_A_MPF\nCYCLE82(50,0,2,20)\nM30\n%_N_CYCLE82_SPF\n"
                                   "PROC CYCLE82(REAL A,REAL B,REAL C,REAL D)\nM17\n"),
                IsEmpty()); // the shop's own
}

TEST(SinumerikArcs, AreJudgedInPlanesWithoutDiameters) {
    EXPECT_THAT(findings("MAC522", "G17 G90 G0 X0 Y20\nG2 X20 Y40 CR=11.3\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC522", "G17 G90 G0 X0 Y20\nG2 X20 Y40 CR=14.2\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC522", "G17 G90 G0 X0 Y20\nG2 X20 Y40 I48 J0\nM30\n"), SizeIs(1));
    // X20 is 20 or 10 from X0: an arc that joins the ends for the one or the other.
    EXPECT_THAT(findings("MAC522", "G18 G90 G0 X0 Z20\nG2 X20 Z40 CR=11.3\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC522", "G18 G90 G0 X0 Z20\nG2 X20 Z40 CR=11.1\nM30\n"),
                SizeIs(1)); // 22.4 apart at least
    EXPECT_THAT(findings("MAC522", "G18 G90 G0 X0 Z0\nG2 X20 Z-10 I10 K0\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC522", "G18 G90 G0 X0 Z0\nG2 X10 Z-10 I10 K0\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("MAC522", "G18 G90 G0 X0 Z0\nG2 X30 Z-10 I10 K0\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC522", "G19 G90 G0 Y0 Z20\nG2 Y20 Z40 CR=11.3\nM30\n"), SizeIs(1)); // no X
    EXPECT_THAT(findings("MAC522", "TRANSMIT(1)\nG17 G90 G0 X0 Y20\nG2 X20 Y40 CR=11.3\nM30\n"), IsEmpty());
    // J is no letter of G18, whatever X is.
    EXPECT_THAT(findings("MAC522", "G18 G90 G0 X0 Z0\nG2 X10 Z-10 I0 J-10\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC522", "G18 G90 G0 X0 Y0 Z0\nG2 X10 Z-10 I0 K-10 J5 Y5\nM30\n"), IsEmpty());
}

TEST(SinumerikFunctions, AreFiveOfMAndThreeOfTheOthers) {
    const auto block = [](const std::string& words) { return findings("SIN120", words + "\nM30\n"); };
    EXPECT_THAT(block("G1 X5 M3 M8 M41 M21 M25"), IsEmpty());
    EXPECT_THAT(block("N10 M3 M8 M41 M21 M25 M31"), SizeIs(1));
    EXPECT_THAT(block("G1 X5 M3 M8 M41 M21 M1=3 M2=4 M3=5"), SizeIs(1)); // one finding for the block
    EXPECT_THAT(block("S500 S2=300 S3=100"), IsEmpty());
    EXPECT_THAT(block("S500 S2=300 S3=100 S4=100"), SizeIs(1));
    EXPECT_THAT(block("M3 M8 M41 M21 M25 MEAC[X]=1 H1=1 H2=2 H3=3 SF=30"), IsEmpty());
    EXPECT_THAT(block("H1=1 H2=2 H3=3 H4"), SizeIs(1));
}

TEST(SinumerikBlocks, HaveFewEnoughCharactersOfCode) {
    std::string sum = "R1=R2";
    while (sum.size() < 508) sum += "+R3"; // 509 characters
    EXPECT_THAT(findings("SIN116", sum + "   ; " + sum + "\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN116", sum + "+R4\nM30\n"), IsEmpty()); // 512
    EXPECT_THAT(findings("SIN116", sum + "+R44\nM30\n"), SizeIs(1));
}

TEST(SinumerikAlarms, HaveNumbersThatSetalTakes) {
    const auto raised = [](const std::string& number) {
        return findings("MAC601", "SETAL(" + number + ",\"X\")\nM30\n");
    };
    EXPECT_THAT(raised("65000"), IsEmpty());
    EXPECT_THAT(raised("69999"), IsEmpty());
    EXPECT_THAT(raised("60000"), IsEmpty()); // a cycle of the control's maker
    EXPECT_THAT(raised("R1"), IsEmpty());
    EXPECT_THAT(raised("70000"), SizeIs(1));
    EXPECT_THAT(raised("59999"), SizeIs(1));
}

TEST(SinumerikSystemVariables, AreReadWhereTheControlSaysWhatTheyHold) {
    EXPECT_THAT(findings("MAC203", "$A_IN[3]=1\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC203", "$P_GG[6]=1\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("MAC203", "$A_OUT[3]=1\n$AC_MARKER[1]=2\n$P_UIFR[1,X,TR]=5\nR1=$A_IN[3]\nM30\n"),
                IsEmpty());
}

TEST(SinumerikSystemVariables, AreRParametersInActions) {
    EXPECT_THAT(findings("SIN204", "ID=1 EVERY $R10>5 DO $RG1=$R[3]\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN204", "ID=1 EVERY $RX>5 DO M8\nM30\n"), SizeIs(1));
}

TEST(SinumerikActions, AreReplacedByTheNextOfTheirNumber) {
    const std::string first = "ID=1 WHENEVER $A_IN[1]==1 DO M8\n",
                      second = "ID=1 EVERY $A_IN[2]==1 DO M9\nM30\n";
    const auto again = [&](const std::string& between) {
        return findings("SIN602", "DEF REAL WAY\n" + first + between + second);
    };
    EXPECT_THAT(again(""), SizeIs(1));
    EXPECT_THAT(again("G1 X50 F100\nWAY=5\n"), SizeIs(1));
    for (const char* between :
         {"CANCEL(1)\n", "CHIPS\n", "NEXT:\n", "IF R1==1\n", "GOTOF NEXT\nNEXT: G0 X1\n"})
        EXPECT_THAT(again(between), IsEmpty()) << between;
}

TEST(SinumerikActions, AreEndedBeforeASubprogramReturns) {
    const auto left = [](const std::string& first, const std::string& then) {
        return findings("SIN603",
                        "PROC AIR_BLAST\n" + first + " WHENEVER $A_IN[1]==1 DO M8\n" + then + "M17\n");
    };
    EXPECT_THAT(left("ID=4", "G1 X5 F100\n"), SizeIs(1));
    EXPECT_THAT(left("ID=4", "G1 X5 F100\nCANCEL(4)\n"), IsEmpty());
    EXPECT_THAT(left("IDS=4", "G1 X5 F100\n"), IsEmpty());           // meant to run on
    EXPECT_THAT(left("ID=4", ""), IsEmpty());                        // a program that switches it on
    EXPECT_THAT(left("ID=4", "G1 X5 F100\nBLAST_OFF\n"), IsEmpty()); // may end it
    EXPECT_THAT(findings("SIN603", "ID=4 WHENEVER $A_IN[1]==1 DO M8\nG1 X5 F100\nM30\n"), IsEmpty());
}

TEST(SinumerikFrames, MayBeWrittenForTheCallersThatEndThem) {
    const std::string swivel = "%_N_SWIVEL_SPF\nPROC SWIVEL(REAL B_)\nTRANS X10\nAROT X=B_\nM17\n";
    const auto left = [&](const std::string& end) {
        return findings("MAC502", "%_N_A_MPF\nG54 G17\nSWIVEL(30)\nG0 X0 Y0\nCYCLE81(10,0,2,-5)\n" + end +
                                      "M30\n" + swivel + "%_N_SWIVEL_OFF_SPF\nPROC SWIVEL_OFF\nROT\nM17\n");
    };
    EXPECT_THAT(left("SWIVEL_OFF\n"), IsEmpty());
    EXPECT_THAT(left("TRANS\n"), IsEmpty());
    EXPECT_THAT(left(""), SizeIs(2)); // shift and rotation
}

TEST(SinumerikTransformations, AreCalledWhatTheyAre) {
    const auto found = findings("MAC502", "G54 G17\nTRAORI\nG1 X5 F1000\nM30\n");
    ASSERT_THAT(found, SizeIs(1));
    EXPECT_THAT(found.front().message(), HasSubstr("TRAORI is still active"));
    EXPECT_THAT(findings("MAC502", "G54 G17\nTRACYL(40)\nG1 X5 F1000\nTRAFOOF\nM30\n"), IsEmpty());
}

/// What a line becomes by the first fix of the rule.
std::string mended(std::string_view code, const std::string& line) {
    const auto found = findings(code, line + "\nREADY: M30\n");
    if (found.empty() || found.front().fixes.empty()) return "no fix";
    std::string text = line;
    const auto& edits = found.front().fixes.front().edits;
    for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit)
        text.replace(edit->span.begin, edit->span.length(), edit->text);
    return text;
}

TEST(SinumerikWords, LackTheirEqualsBeforeAVariable) {
    EXPECT_THAT(findings("SIN105", "G0 XR1 Y5\nG1 X10 FR2\nM30\n"), SizeIs(2));
    EXPECT_EQ(mended("SIN105", "G0 XR1"), "G0 X=R1");
    EXPECT_THAT(findings("SIN105", "XR1\nG1 X=R1 F=R2\nM30\n"), IsEmpty()); // a program may have the name
}

TEST(SinumerikTexts, FitIntoTheirVariables) {
    EXPECT_THAT(findings("SIN115", "DEF STRING[5] TXT_=\"ABCDEF\"\nTXT_=\"ABCDEFG\"\nM30\n"), SizeIs(2));
    EXPECT_THAT(findings("SIN115", "DEF STRING[5] TXT_=\"ABCDE\"\nTXT_=\"\"\nM30\n"), IsEmpty());
}

TEST(SinumerikCycles, HaveADepth) {
    EXPECT_THAT(findings("SIN412", "CYCLE81(50,0,2)\nCYCLE82(50,0,2,,,0.5)\nM30\n"), SizeIs(2));
    EXPECT_THAT(findings("SIN412",
                         "CYCLE81(50,0,2,R1)\nCYCLE82(50,0,2,,8,0.5)\nCYCLE81(50,0,2,,,0.6,10,1,12)\nM30\n"),
                IsEmpty());
}

TEST(SinumerikWords, OfProgramsAreNoSlips) {
    for (const char* name : {"LOOPS", "LOOK", "REPEATS"})
        EXPECT_THAT(findings("MAC118", std::string("G0 X0\n") + name + "\nM30\n"), IsEmpty()) << name;
    EXPECT_THAT(findings("MAC118", "LOPO\nG0 X0\nENDLOOP\nM30\n"), SizeIs(1));
}

TEST(SinumerikNames, OfOtherAxesAndProgramsAreNoSlips) {
    EXPECT_THAT(findings("SIN203", "DEF REAL X_POS\nX_POS=5\nG0 X=X_POS Y=Y_POS\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN203", "DEF REAL X_POS\nX_POS=5\nG0 X=X_PSO\nM30\n"), SizeIs(1));
    EXPECT_THAT(findings("SIN203", "DEF REAL COUNT_A\nCOUNT_A=5\nG0 X=COUNT_B\nM30\n"), IsEmpty());
    EXPECT_THAT(findings("SIN203", "DEF REAL COUNT_A\nCOUNT_A=5\nG0 X=COUMT_A\nM30\n"), SizeIs(1));
    for (const char* name : {"LIFT", "ROTA"})
        EXPECT_THAT(findings("SIN203", std::string("G0 X0\n") + name + "\nM30\n"), IsEmpty()) << name;
    for (const char* name : {"STOPPRE", "TRNAS X40", "TRAFOF", "CANCLE(1)"})
        EXPECT_THAT(findings("SIN203", std::string("G0 X0\n") + name + "\nM30\n"), SizeIs(1)) << name;
}

TEST(SinumerikSlips, OfCyclesAndOfNamesBesideWordsAreTold) {
    const auto told = [](const std::string& block) {
        return findings("SIN203", "G0 X0\n" + block + "\nM30\n");
    };
    for (const char* block :
         {"CYCEL81(50,0,2,-20,)", "CYLCE83(50,0,2,-20,)", "CYCL82(50,0,2,-20,)", "MCALL CYCEL81(50,0,2,-20,)",
          "MCAL CYCLE81(50,0,2,-20,)", "SUPPA G0 Z0", "G0 SUPPA Z0", "TRAN X5"})
        EXPECT_THAT(told(block), SizeIs(1)) << block;
    for (const char* block : {"CYCEL81", "CYCLE18(1)", "CYCLE212(1)", "CYCLE189(2)", "MCAL", "SUPPA",
                              "TRAN P3", "MCALL POCKET(5)", "HOLE2(5)", "POCKET(1)"})
        EXPECT_THAT(told(block), IsEmpty()) << block;
    EXPECT_THAT(findings("SIN203", "%_N_A_MPF\nG0 X0\nCYCEL81(5)\nM30\n%_N_CYCEL81_SPF\nM17\n"), IsEmpty());
}

TEST(SinumerikFunctions, TakeTheirArguments) {
    const auto told = [](const std::string& block) {
        return findings("MAC729", "DEF REAL A_, B_\n" + block + "\nM30\n");
    };
    for (const char* block : {"R1=SIN(1,2)", "R1=ATAN2(R2)", "R1=POT(2,3)", "R1=SQRT()", "R1=MAXVAL(A_)",
                              "R1=BOUND(1,2)", "R1=STRLEN(\"A\",\"B\")", "R1=ABS(A_,,B_)"})
        EXPECT_THAT(told(block), SizeIs(1)) << block;
    for (const char* block : {"R1=SIN(1)", "R1=ATAN2(R2,R3)", "R1=BOUND(1,2,3)", "R1=MAXVAL(A_,B_)",
                              "R1=ATAN2(BOTH)", "R1=SUBSTR(\"ABC\",1)", "R1=NOBODY(1,2,3,4)"})
        EXPECT_THAT(told(block), IsEmpty()) << block;
}

TEST(SinumerikFunctions, HaveNoResultForSomeNumbers) {
    for (const char* value : {"LN(0)", "LN(-1)", "SQRT(-1)", "ASIN(1.5)", "ACOS(-2)", "LN(A_)"})
        EXPECT_THAT(findings("MAC703", "DEF REAL A_=0\nR1=" + std::string(value) + "\nM30\n"), SizeIs(1))
            << value;
    for (const char* value : {"LN(1)", "SQRT(0)", "ASIN(1)", "LN(R2)", "SQRT(R2)"})
        EXPECT_THAT(findings("MAC703", "R1=" + std::string(value) + "\nM30\n"), IsEmpty()) << value;
    for (const char* value : {"5 DIV 0", "5 MOD 0", "R2 DIV (A_-2)", "5/0"})
        EXPECT_THAT(findings("MAC702", "DEF INT A_=2\nR1=" + std::string(value) + "\nM30\n"), SizeIs(1))
            << value;
    for (const char* value : {"5 DIV 2", "0 MOD 5", "R2 DIV R3"})
        EXPECT_THAT(findings("MAC702", "R1=" + std::string(value) + "\nM30\n"), IsEmpty()) << value;
}

TEST(SinumerikArrays, GiveBackWhatIsOfTheirType) {
    const auto told = [](const std::string& type, const std::string& parameter) {
        return findings("SIN404", "%_N_A_MPF\nDEF " + type +
                                      " ROW_[4]\nFILL(ROW_)\nM30\n%_N_FILL_SPF\nPROC FILL(" + parameter +
                                      ")\nPLACES[0]=1\nM17\n");
    };
    EXPECT_THAT(told("INT", "VAR REAL PLACES[]"), SizeIs(1));
    EXPECT_THAT(told("REAL", "VAR REAL PLACES[]"), IsEmpty());
    EXPECT_THAT(told("REAL", "VAR INT PLACES[4]"), SizeIs(1));
}

TEST(SinumerikAxes, MoveByPosEachOnce) {
    EXPECT_THAT(findings("MAC559", "POS[X]=10 POS[Y]=20 FA[X]=100\nM30\n"), IsEmpty());
}

TEST(SinumerikMacros, LeaveModesWhereTheyOnlySwitch) {
    const auto left = [](const std::string& macro) {
        return findings("MAC502", "DEFINE MIST AS " + macro + "\nG54 G17\nTRAORI\nG1 X5 F1000\nMIST\nM30\n");
    };
    EXPECT_THAT(left("M7 H12"), SizeIs(1));
    for (const char* macro : {"G40", "M6", "G0", "M7 G0", "SUPA G0 Z0 D0", "F300 S1000 M3"})
        EXPECT_THAT(left(macro), SizeIs(1)) << macro;
    for (const char* macro : {"M17", "M30", "TRAFOOF", "Z=R1", "G0 POCKET", "TRANS X5", "G4 F1", "M19", "T1"})
        EXPECT_THAT(left(macro), IsEmpty()) << macro;
}

TEST(SinumerikMacros, SetWhatTheirWordsSet) {
    const auto arcs = [](const std::string& macro, const std::string& blocks) {
        return findings("MAC522", "DEFINE WORD_ AS " + macro + "\nG17 G90 G54\nG0 X0 Y0\nG1 F500 X10\n" +
                                      blocks + "\nM30\n");
    };
    EXPECT_THAT(arcs("G91", "WORD_\nG3 X0 Y20 CR=8"), SizeIs(1));
    EXPECT_THAT(arcs("G91", "WORD_\nG3 X10 Y5 CR=8"), IsEmpty());
    EXPECT_THAT(arcs("G91", "G3 X10 Y20 CR=8"), SizeIs(1));
    EXPECT_THAT(arcs("SUPA G0 Z0", "WORD_\nG1 X0 Y0\nG3 X0 Y20 CR=8"), SizeIs(1));
    EXPECT_THAT(arcs("SUPA G0 X0", "WORD_\nG3 X10 Y20 CR=8"), IsEmpty()); // from nobody knows where
    EXPECT_THAT(arcs("M6", "WORD_\nG1 X0 Y0\nG3 X0 Y20 CR=8"), SizeIs(1));
    // Beside other words it may be any piece of the block.
    EXPECT_THAT(arcs("G0 Z9", "WORD_ X5\nG1 X0 Y0\nG3 X0 Y20 CR=8"), IsEmpty());
    EXPECT_THAT(findings("SIN502", "DEFINE TOOL_IN AS M6\nG17 G90\nG41 G1 X5 F100\nTOOL_IN\nG40 X0\nM30\n"),
                SizeIs(1));
}

TEST(SinumerikMachines, BeginWithTheirCodes) {
    const auto at_start = [](std::string_view control, ModalRole role) {
        const ControlModel& model = *find_control(control);
        const GroupId group = *model.group_with(role);
        const auto code = model.groups[group].reset;
        return code ? model.spell(group, *code) : "";
    };
    EXPECT_EQ(at_start("sinumerik", ModalRole::plane), "");
    EXPECT_EQ(at_start("sinumerik-mill", ModalRole::plane), "G17");
    EXPECT_EQ(at_start("sinumerik-lathe", ModalRole::plane), "G18");
    EXPECT_EQ(at_start("sinumerik-mill", ModalRole::feed_mode), "G94");
    EXPECT_EQ(at_start("sinumerik-lathe", ModalRole::feed_mode), "G95");
    EXPECT_EQ(at_start("sinumerik", ModalRole::cutter_compensation), "G40");
}

TEST(SinumerikMoves, CutUnderAFeed) {
    const auto cut = [](const std::string& blocks) {
        return findings("MAC553", "G17 G90 G54\nT1 D1\nM6\nS500 M3\nG0 X0 Y0 Z2\n" + blocks + "M30\n");
    };
    EXPECT_THAT(cut("G1 Z-5\n"), SizeIs(1));
    EXPECT_THAT(cut("G1 Z-5 F100\n"), IsEmpty());
    EXPECT_THAT(cut("F=R1\nG1 Z-5\n"), IsEmpty());
    EXPECT_THAT(cut("FEEDS\nG1 Z-5\n"), IsEmpty()); // the program may give one
    EXPECT_THAT(cut("G1 Z-5 FZ=0.1\n"), IsEmpty()); // the feed of a tooth
    EXPECT_THAT(cut("G4 F1\nG1 Z-5\n"), SizeIs(1)); // a time
}

TEST(SinumerikLoops, AreNotEndedByACycle) {
    const auto loop = [](const std::string& body) {
        return findings("MAC319", "DEF INT NR=1\nWHILE NR<5\n" + body + "ENDWHILE\nM30\n");
    };
    EXPECT_THAT(loop("G0 X=NR*10\nCYCLE82(50,0,2,-4.5,,0.5)\n"), SizeIs(1));
    EXPECT_THAT(loop("G0 X=NR*10\nCYCLE82(50,0,2,-4.5,,0.5)\nNR=NR+1\n"), IsEmpty());
    EXPECT_THAT(loop("G0 X=NR*10\nDRILL_ONE\n"), IsEmpty()); // it may end the program
}

TEST(SinumerikFixes, WriteWhatWasMeant) {
    EXPECT_EQ(mended("SIN105", "G1 Z-DEPTH"), "G1 Z=-DEPTH");
    EXPECT_EQ(mended("SIN105", "T\"DRILL\""), "T=\"DRILL\"");
    EXPECT_EQ(mended("SIN106", "-------- bore"), ";-------- bore");
    EXPECT_EQ(mended("SIN107", "G0 X5 (bore)"), "G0 X5 ; bore");
    EXPECT_EQ(mended("SIN107", "(bore) G0 X5"), "no fix");
    EXPECT_EQ(mended("SIN109", "GOTOF READY:"), "GOTOF READY");
    EXPECT_EQ(mended("MAC119", "IF R1 EQ 2 GOTOF READY"), "IF R1 == 2 GOTOF READY");
    EXPECT_EQ(mended("MAC129", "IF R1=2 GOTOF READY"), "IF R1==2 GOTOF READY");
    EXPECT_EQ(mended("MAC121", "X=-[R1+5]"), "X=-(R1+5)");
    EXPECT_EQ(mended("MAC121", "MSG(\xE2\x80\x9CRow\xE2\x80\x9D)"), "MSG(\"Row\")");
    EXPECT_EQ(mended("MAC301", "GOTOB READY"), "GOTOF READY");
    EXPECT_EQ(mended("MAC728", "IF R1==1 AND R2<>0 GOTOF READY"), "IF (R1==1) AND (R2<>0) GOTOF READY");
}

TEST(SinumerikRules, ThatWereNotTriedAreNotAsked) {
    EXPECT_FALSE(applies_to(*find_rule("MAC336"), *find_control("sinumerik")));
    EXPECT_TRUE(applies_to(*find_rule("MAC301"), *find_control("sinumerik")));
    EXPECT_TRUE(applies_to(*find_rule("MAC336"), *find_control("fanuc")));
    for (const std::string_view code : find_control("sinumerik")->rules_tried)
        EXPECT_NE(find_rule(code), nullptr) << code;
}

} // namespace
} // namespace maclint
