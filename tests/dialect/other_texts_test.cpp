//! What shops keep beside their programs, and programs for controls that maclint does not read.
#include "tests/dialect/detecting.hpp"

#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

namespace maclint {
namespace {

std::string reported_of(std::string_view text, std::string path = "a.nc") {
    return test::reported(detect_dialect(Source::from_bytes(std::move(path), std::string(text))));
}

constexpr std::string_view other = "text of another kind";
constexpr std::string_view data = "data, no program";

TEST(OtherTexts, ToolListsAndSetupSheetsAreNoPrograms) {
    for (const std::string_view text :
         {"T1  END MILL D20    H1\nT2  CENTRE DRILL    H2\nT4  REAMER 12H7     H4\n",
          "Werkzeugliste Welle 12\nT1  Schaftfraeser D20   L=98.5\nT2  Bohrer D6,8\n",
          "Lista utensili\nT1 fresa a candela D20\nT2 punta elicoidale D6.8\n",
          "LISTE D'OUTILS\nT1 FRAISE D20\nT2 FORET D6.8\n",
          "Setup for part 12\nG54 X0 Y0 is the pin\nT1 end mill\n",
          "\xE5\x88\x80\xE5\x85\xB7\xE6\xB8\x85\xE5\x8D\x95\nT1 \xE9\x92\xBB\xE5\xA4\xB4 6.8\n",
          "N10 Saegen\nN20 Drehen\nN30 Schleifen\n", "BOHREN\nD8 TIEFE 20\nSENKEN 90\n"})
        EXPECT_EQ(reported_of(text), other) << text;
}

TEST(OtherTexts, TablesLogsListsOfCodesAndLettersAreNoPrograms) {
    for (const std::string_view text :
         {"A,B,C\n1.5,2.5,3.5\n", "1.5;2.5;3.5\n2.5;3.5;4.5\n", "1.5 2.5\n2.5 3.5\n",
          "T1\t20.0\t98.5\nT2\t6.8\t80.0\n", "2023-11-02 07:01 O77 started\n2023-11-02 07:09 O77 ALARM 010\n",
          "G00 Eilgang\nG01 Gerade\nG04 Verweilzeit\n", "M03 - spindle on\nM05 - spindle off\n",
          "#101 = width of the pocket\n#102 = depth of the pocket\n",
          "010 IMPROPER G-CODE\n011 NO FEEDRATE COMMANDED\n", "O0077 (COVER)   1320\nO0078 (BASE)    640\n",
          "Hi Tom,\nplease set N40 in O77 to\nG01 Z-3. F80\nthanks\n", "[SERIAL]\nPort=COM2\nBaud=4800\n",
          "DIA 12.004\nX 10.001 Y 20.002\nX 10.002 Y 20.001\n", "D1=10.5\nD2=8.25\n",
          "X = 10.01\nY = 20.02\nZ = -5.\n", "G0 X1<br>\nG1 X2<br>\n",
          "--| |----( )--\n  X0001.0 Y0080.0\n--|/|----( )--\n",
          "ROHTEIL\nD80 L200 42CrMo4\nFERTIGTEIL\nFlansch nach Zeichnung\nMenge zwanzig\n",
          "[Result]\n(none)\n"})
        EXPECT_EQ(reported_of(text), other) << text;
}

TEST(OtherTexts, MarkupAndDocumentsAreNamed) {
    EXPECT_EQ(reported_of("<p class=\"a\">G0 X5</p>"), "XML or HTML");
    EXPECT_EQ(reported_of("<!doctype html>\nG0 X5"), "XML or HTML");
    EXPECT_EQ(reported_of("{\\rtf1 G0 X5}"), "RTF");
    EXPECT_EQ(reported_of("<COVER>\nG0 X5.\nM30\n"), "fanuc"); // a program's name
}

TEST(OtherTexts, WhatHoldsOnlyValuesIsData) {
    for (const std::string_view text :
         {"%\nG10 L10 P1 R98.5\nG10 L10 P2 R80.\n%\n",
          "%\nG10 P1 X-5.5 Z0. R0.8\nG10 P2 X-5. Z0. R0.4\nG11\n%\n",
          "%\nN0001P00000010\nN1320A1P99999A2P99999\nN03111Q1L1P00000001\n%\n",
          "%\n#500=12.5\n#501=#0\nSETVN500[LEN,WID]\n#502=\n%\n",
          "%\n#100=[25283*65536+65536]/134217728\n#101=0\nM02\n%\n", "%\n(#100)=1.5\nN500 #500=2.5\n%\n"}) {
        EXPECT_EQ(reported_of(text), data) << text;
        EXPECT_FALSE(detect_dialect(Source::from_bytes("a.nc", std::string(text))).not_nc_text) << text;
    }
}

TEST(OtherTexts, DataInAProgramIsAProgram) {
    for (const std::string_view text :
         {"%\nO12\n#500=12.5\n#501=3.\nM99\n%\n", "G10 L2 P1 X5.\nG10 L2 P2 X6.\nM30\n",
          "#500=#501+1\n#501=2.\n", "#500=5.\n", "#3000=1(STOP)\n#500=2.\n",
          "G10 L2 P1 X#500\nG10 L2 P2 X#501\n"})
        EXPECT_EQ(reported_of(text), "fanuc") << text;
    EXPECT_EQ(reported_of("#500=12.5\n#501=3.\n", "O0012"), "fanuc"); // a program by its name
    std::string dump = "%\n";
    while (dump.size() < 70'000) dump += "N6000P00100000\n";
    EXPECT_EQ(reported_of(dump + "%\n"), data);
    EXPECT_EQ(reported_of(dump + "%\nO12\nG0X5.\nM30\n%\n"), "fanuc");
}

TEST(OtherTexts, AProgramWithRemarksThatNobodyBracketedStaysOne) {
    EXPECT_EQ(reported_of("O12\nCOVER PLATE\nMADE BY TOM\nG0 X5.\nG1 Z-1. F100\nM30\n"), "fanuc");
    EXPECT_EQ(reported_of("G0 X5.\nG1 X 10 FEED 100\n"), "fanuc");
    EXPECT_EQ(reported_of("# cover plate\nG0 X5.\n# the hole\nG1 Z-1. F100\nM30\n"), "fanuc");
    EXPECT_EQ(reported_of("G0 X5. # move to the left\nG1 Z-1. F100 # down slowly\n"), "fanuc");
    EXPECT_EQ(reported_of("O12\nG0 X5. // move to the left\nG1 Z-1. F100 // down slowly\n"), "fanuc");
    EXPECT_EQ(reported_of("G1 X 10 FEED 100\n"), "fanuc"); // one line that begins like a block
}

TEST(OtherControls, AreToldByWhatNoOtherWrites) {
    EXPECT_EQ(reported_of("O5\n[BILLET X50 Z60\nG21\nG0 X52 Z2\nM30\n"), "Denford");
    EXPECT_EQ(reported_of("%\nO6(PIN)\nL1=20\nL2=3.5\nG59X0ZL1\nG0XL2Z2.\nM30\n%\n"), "TRAUB");
    for (const std::string_view text : {"O7\n$1\nG99 M6\nT200\nM2\n", "O7\nG0 X1.\n!L1\nG0 X2.\n!2L2\nM2\n",
                                        "G600\nT300 (END MILL)\nG650\nG999\nM2\n"})
        EXPECT_EQ(reported_of(text), "CITIZEN or another lathe of several paths") << text;
    EXPECT_EQ(reported_of("%\nO8\nG291\nG65P2A1.\nG0 X5\nM30\n%\n"), "SINUMERIK in ISO mode");
    EXPECT_EQ(reported_of("G0 X5\nG291\nM30\n", "a.mpf"), "sinumerik");
    EXPECT_EQ(reported_of("%PIN,MX,\n(P1=5)\nG0 X5\nM30\n"), "FAGOR");
    EXPECT_EQ(reported_of("(P1=5)\nG0 X5\n(IF P1 EQ 0 GOTO N100)\n(CALL 12)\nM30\n"), "FAGOR");
    EXPECT_EQ(reported_of("N10 P1=K5\nN20 G0 X5\nN30 P2=P1\n"), "FAGOR");
    EXPECT_EQ(reported_of(":G70 G90\n:20 T5 M6\nG0 X5 Y6\n"), "Acramatic");
    EXPECT_EQ(reported_of("UNO MAT INITIAL-Z\n 0 S45C 50\nUNO UNIT DEPTH\n"), "MAZATROL");
    EXPECT_EQ(reported_of("(ID,PROG,PIN)\n:10 G0 X5 Y6\nM2\n"), "Acramatic");
    EXPECT_EQ(reported_of("UNo. MAT.  INITIAL-Z ATC MODE\n 0   S45C   50.      0\n"), "MAZATROL");
}

TEST(OtherControls, RemarksAndSingleMarksOfAFanucProgramNameNobody) {
    EXPECT_EQ(reported_of("O9\n(CALL PROGRAM 12)\n(P1=DEPTH)\n(MSG TO TOM)\n(RET)\nG0 X5.\nM99\n"), "fanuc");
    EXPECT_EQ(reported_of("O9\nG600\nT200\nG0 X5.\nM30\n"), "fanuc");
    EXPECT_EQ(reported_of(":9\nG0 X5.\nM30\n"), "fanuc");
    EXPECT_EQ(reported_of("O9\nM98 P5 L2\nG0 X5.\nM30\n"), "fanuc");
    EXPECT_EQ(reported_of("N1 T3 G95 F0.25 G96 S200 M3\nN2 G0 X62 Z2\nIF (#l1 == 1)\nN3 G810 P2\nENDIF\n"),
              test::din_plus);
}

} // namespace
} // namespace maclint
