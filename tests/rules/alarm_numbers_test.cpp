//! The numbers of alarms that texts provoke, on each series of controls.
#include "tests/support/linted.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

/// "MAC121 006", a finding and its alarm.
std::vector<std::string> alarms(const std::vector<LintedText>& texts, std::string_view control) {
    cli::Overrides overrides;
    overrides.dialect = find_dialect("fanuc");
    if (control != "fanuc") overrides.control = control;
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] : lint_texts(texts, std::move(overrides)).findings)
        all.push_back(std::string(finding.rule->code) + " " + std::string(finding.alarm));
    return all;
}

std::vector<std::string> alarms_of_block(const std::string& block, std::string_view control) {
    return alarms({{"O9001.nc", "O9001(MACRO)\n" + block + "\nM99\n"}}, control);
}

struct Provoking {
    std::string block, on_16i, on_30i;
};

TEST(AlarmNumbers, AreThoseOfTheSeriesThatReadsTheBlock) {
    const std::vector<Provoking> blocks = {
        {"G1 X--5. F100", "MAC121 006", "MAC121 006"},
        {"G1 X5.2. F100", "MAC121 007", "MAC121 007"},
        {"G1 X5.{ F100", "MAC121 009", "MAC121 009"},
        {"G1 X20.&Y5. F100", "MAC121 009", "MAC121 009"},
        {"25.5 G0 X1.", "MAC121 004", "MAC121 "},
        {"N G1 X5. F100", "MAC121 ", "MAC121 1014"},
        {"N#3 G0 X5.", "MAC121 ", "MAC121 1014"},
        {"G1 X10.O1002 F100", "MAC121 ", "MAC121 1013"},
        {"#5 EQ 3", "MAC121 114", "MAC121 1133"},
        {"#5[#1+2]", "MAC121 114", "MAC121 1133"},
        {"#1=[#2][#3]", "MAC121 114", "MAC121 1125"},
        {"#1=ATAN[#2][#3]", "MAC121 114", "MAC121 1134"},
        {"#1=POW[#2]", "MAC121 114", "MAC121 1120"},
        {"#1=POW[#2,]", "MAC121 114", "MAC121 1120"},
        {"#1=POW[#2#3]", "MAC121 114", "MAC121 1134"},
        {"#1=ATAN[#2,#3,#4]", "MAC121 114", "MAC121 1120"},
        {"#1=SIN[#2,#3]", "MAC121 114", "MAC121 1125"},
        {"#1 5.", "MAC121 114", "MAC121 1133"},
        {"#1SIN[#2]", "MAC121 114", "MAC121 1133"},
        {"M9 O100", "MAC121 ", "MAC121 1013"},
        {"@5 G0 X1.", "MAC121 009", "MAC121 009"},
        {"#1=#2+", "MAC121 114", "MAC121 1125"},
        {"#1=#2=5", "MAC121 114", "MAC121 1125"},
        {"GOTO", "MAC121 125", "MAC121 125"},
        {"IF GOTO5", "MAC121 125", "MAC121 1137"},
        {"WHILE DO1", "MAC121 125", "MAC121 1138"},
        {"#1=[#2+1", "MAC117 114", "MAC117 1132"},
        {"DPRNT[Z#3[53]", "MAC117 114", "MAC117 1132"},
        {"#1=#2+1]", "MAC117 114", "MAC117 1131"},
        {"IF[#1LTE5]GOTO1", "MAC118 114", "MAC118 1125"},
        {"#3=LOG[#1]", "MAC118 199", "MAC118 199"},
        {"IF[#1<5]GOTO1", "MAC119 114", "MAC119 1125"},
        {"IF #1 EQ 5 GOTO1", "MAC324 114", "MAC324 1137"},
        {"WHILE #1 LT 5 DO1", "MAC324 114", "MAC324 1138"},
        {"IF[#1GT5]AND[#1LT9]GOTO1", "MAC329 125", "MAC329 1137"},
        {"IF[#1EQ5]", "MAC325 125", "MAC325 1137"},
        {"IF[#1EQ5]THEN", "MAC118 ", "MAC118 1137"},
        {"#1=SIN 30", "MAC706 114", "MAC706 1125"},
        {"#1=SIN(30)", "MAC116 114", "MAC116 1125"},
        {"G0 X(#1+2)", "MAC116 005", "MAC116 005"},
        {"G90 #1=5", "MAC332 127", "MAC332 127"},
        {"GOTO5 G0 X1.", "MAC307 127", "MAC307 127"},
        {"GOTO77", "MAC301 128", "MAC301 128"},
        {"GOTO0", "MAC301 128", "MAC301 1128"},
        {"#0=5", "MAC201 116", "MAC201 116"},
        {"#1003=1", "MAC203 116", "MAC203 116"},
        {"DO4\nEND4", "MAC314 126", "MAC314 126"},
        {"DO1", "MAC312 124", "MAC312 124"},
        {"END1", "MAC313 124", "MAC313 1124"},
        {"DPRNT[X#1[5]]", "MAC127 ", "MAC127 1143"},
        {"DPRNTX#1[53]", "MAC127 ", "MAC127 1143"},
        {"BPRNT[X#1[53]]", "MAC127 ", "MAC127 1143"},
        {"SETVN510[]", "MAC127 ", "MAC127 1139"},
        {"SETVN510[DEP:TH]", "MAC127 ", "MAC127 1141"},
        {"O0 G0 X1.", "MAC452 074", "MAC452 074"},
        {"#1=1234567890", "MAC121 003", ""},
    };
    for (const Provoking& provoking : blocks) {
        EXPECT_THAT(alarms_of_block(provoking.block, "fanuc-16i"), Contains(provoking.on_16i))
            << provoking.block;
        if (provoking.on_30i.empty())
            EXPECT_THAT(alarms_of_block(provoking.block, "fanuc-30i"), IsEmpty()) << provoking.block;
        else
            EXPECT_THAT(alarms_of_block(provoking.block, "fanuc-30i"), Contains(provoking.on_30i))
                << provoking.block;
    }
}

TEST(AlarmNumbers, OfBlocksThatOnlyTheNewSeriesReads) {
    for (const auto& [block, alarm] : std::vector<std::pair<std::string, std::string>>{
             {"SETVN510[DEPTHOFCUT]", "MAC127 1142"},
             {"#3=[#WIDTHOFSLOT]/2", "MAC121 1097"},
             {"#3=[#_ABSMT]", "MAC121 1099"},
             {"#3=[#_ABSIO[99]]", "MAC121 1099"},
             {"#3=[#_ABSOLUTEPOSITIONOFTHEFIRSTAXIS]", "MAC121 1097"},
             {"M9 N80", "MAC465 1013"},
         })
        EXPECT_THAT(alarms_of_block(block, "fanuc-30i"), Contains(alarm)) << block;
    EXPECT_THAT(alarms_of_block("SETVN510[DEPTHOFCUT]", "fanuc-16i"), IsEmpty());
    EXPECT_THAT(alarms_of_block("G0 X[#_ABSMT[1]]", "fanuc-30i"), IsEmpty());
    EXPECT_THAT(alarms_of_block("M9 N80", "fanuc-16i"), ElementsAre("MAC465 "));
}

TEST(AlarmNumbers, OfNctAreThoseOfItsManual) {
    EXPECT_THAT(alarms_of_block("#1=#2+", "nct"), ElementsAre("MAC121 3064"));
    EXPECT_THAT(alarms_of_block("#1=[[[[[[#2]]]]]]", "nct"), ElementsAre("MAC701 3064"));
}

/// They say which form a macro statement lacks; words alone have alarms of their own.
TEST(AlarmNumbers, OfMacroStatementsAreNotToldOfWords) {
    EXPECT_THAT(alarms_of_block("G65 PXXXX", "fanuc-16i"), Contains("MAC118 "));
    EXPECT_THAT(alarms_of_block("G1 X-", "fanuc-16i"), Contains("MAC121 "));
}

TEST(AlarmNumbers, OfACallThatBeginsAtABlock) {
    const auto call = [](std::string_view block, std::string_view control) {
        return alarms({{"O1.nc", "O1\nM98P1002Q" + std::string(block) + "\nM30\n"},
                       {"O1002.nc", "O1002\nG0X1.\nN40X2.\nM99\n"}},
                      control);
    };
    EXPECT_THAT(call("50", "fanuc-30i"), ElementsAre("MAC426 078"));
    EXPECT_THAT(call("40", "fanuc-30i"), IsEmpty());
}

/// `O` alone begins no program, but it was to begin one: that no path leads there explains nothing.
TEST(AlarmNumbers, OfAProgramWithoutItsNumberBehindAnotherOne) {
    EXPECT_THAT(alarms({{"O1.nc", "O1\nG0X1.\nM99\nO(SPARE)\nG0Z5.\nM99\n"}}, "fanuc-30i"),
                Contains("MAC121 1014"));
}

/// Statements behind `//`, which the 30i runs beside the program.
TEST(AlarmNumbers, OfRealTimeMacros) {
    for (const auto& [block, alarm] : std::vector<std::pair<std::string, std::string>>{
             {"//1 #RV[0]=SIN[30]", "MAC128 402"},
             {"//2 IF[#RV[0]EQ1]THEN#RV[1]=2", "MAC128 402"},
             {"//1 #5001=#RV[0]", "MAC128 403"},
             {"//#RV[0]=1 #4001=5", "MAC128 403"},
             {"//1 #RV[0]=1 //2 #RV[1]=2", "MAC128 407"},
             {"////1 #RV[0]=1", "MAC128 407"},
             {"//1 G90G01X10.F100.", "MAC128 408"},
             {"//1 G91G33Z-10.F1.5", "MAC128 412"},
             {"//1 G91G01X10.F100.T2", "MAC128 413"},
             {"//1 G65P#RV[0]", "MAC128 420"},
             {"//1 M98P#1", "MAC128 420"},
             {"//2 G65 L3 P9010", "MAC128 421"},
             {"//1 G65P9010G54", "MAC128 422"},
         })
        EXPECT_THAT(alarms_of_block(block, "fanuc-30i"), ElementsAre(alarm)) << block;
}

TEST(RealTimeMacros, AreNothingUnreadable) {
    for (const std::string block : {"//1 ZONCE[#RV[0]EQ1]#RV[1]=2", "N10 //1 G91 G01 X10. F100"})
        EXPECT_THAT(alarms_of_block(block, "fanuc-30i"), IsEmpty()) << block;
}

TEST(RealTimeMacros, AreToldByTheirOwnWordsWhereNobodyNamesTheControl) {
    EXPECT_THAT(alarms_of_block("//1 ZONCE[#RV[0]EQ1]#RV[1]=SIN[2]", "fanuc"), ElementsAre("MAC128 "));
    EXPECT_THAT(alarms_of_block("//1 ZONCE[#RV[0]EQ1]#RV[1]=SIN[2]", "fanuc-16i"), IsEmpty());
    EXPECT_THAT(alarms_of_block("//1 G17", "fanuc"), IsEmpty()) << "two marks of skipping";
}

TEST(RealTimeMacros, AreNoRemarks) {
    EXPECT_THAT(alarms_of_block("// first side, clamp at the rear", "fanuc-30i"), ElementsAre("MAC121 "));
}

} // namespace
} // namespace maclint::test
