//! Which dialect a file is for, and what else it may be: one small text for each kind. The files of other
//! people are in detect_corpus_test.cpp.
#include "tests/dialect/detecting.hpp"

#include <chrono>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::reported;
using ::testing::HasSubstr;

Detection detect(std::string path, std::string_view text) {
    return detect_dialect(Source::from_bytes(std::move(path), std::string(text)));
}

std::string reported_of(std::string path, std::string_view text) {
    return reported(detect(std::move(path), text));
}
std::string reported_of(std::string_view text) { return reported_of("a.nc", text); }

TEST(Detection, FanucProgramsAreOursWhateverTheirExtension) {
    for (const char* path : {"O9100.nc", "O9100", "part.txt", "job.tap", "x.cnc", "x.ngc", "x.gcode"})
        EXPECT_EQ(reported_of(path, "%\nO9100(DRILL)\n#1=#2\nM99\n%"), "fanuc") << path;
    EXPECT_EQ(reported_of("(ONLY A COMMENT)\n"), "fanuc");
    EXPECT_EQ(reported_of("#100=5\nG0X#100\nM99\n"), "fanuc");
    EXPECT_EQ(reported_of("G0 X0 Y0\nG1 Z-1. F100.\nM30\n"), "fanuc");
    EXPECT_EQ(reported_of(""), "fanuc");
}

/// Rows of bare positions are blocks beside others, and what begins and ends as a program is one.
TEST(Detection, ProgramsWithManyMistakesStayPrograms) {
    std::string rows;
    for (int i = 0; i < 500; ++i) rows += "X" + std::to_string(i) + ". Y2.\n";
    EXPECT_EQ(reported_of("%\nO8000\nG90 G54 G0 X0\n" + rows +
                          "T4 BORING BAR\nT5 CENTER DRILL\nCLAMP IN VISE\nZERO FRONT LEFT\nSTOCK 60 X 40\n" +
                          rows + "M30\n%\n"),
              "fanuc");
    EXPECT_EQ(reported_of("G90 G54 G0 X0\n" + rows + "BORING BAR HERE\nCLAMP IN VISE\nCENTER DRILL\n"),
              "fanuc");
    EXPECT_EQ(reported_of("%\nO8000\nGOTO START\nPRINT X\nSTOP HERE\nM30\n%\n"), "fanuc");
    EXPECT_EQ(reported_of("%\nO8000\n#1=#500\nIF [#1 LT 5] GOTTO 9\nIF [#1 LT 6] GOO 9\nIF [#1 LT 7] GOTP 9\n"
                          "N9 M30\n%\n"),
              "fanuc");
}

TEST(Detection, SemicolonsThatEndABlockSpeakForNobody) {
    EXPECT_EQ(reported_of("G0 X0 Y0;\nG1 Z-1. F100.;\n;\n;\n(TEXT);\nM30;\n"), "fanuc");
    EXPECT_EQ(reported_of("G0 X0; G1 Z-1. F100.; (DOWN)\n#1=5; IF[#1EQ5]GOTO10\nN10 M30\n"), "fanuc");
}

TEST(Detection, OneSlipDoesNotMakeAFanucProgramForeign) {
    const std::string head = "%\nO0100(FLANGE)\nG90 G54 G0 X0 Y0\n";
    const std::string tail = "\nG65 P9100 A1.\nIF[#1EQ#0]GOTO99\nN99 M30\n%\n";
    for (const char* slip : {"; DRILL THE HOLES",
                             "#<DEPTH>=5",
                             "(MSG, LOAD TOOL 5)",
                             "G64 P0.01",
                             "END",
                             "ENDIF",
                             "#I=5",
                             "G1 X5 *",
                             "R1=5",
                             "[TOOL CHANGE]",
                             "G1 X50 BR2",
                             "FRONT",
                             "T=\"DRILL\"",
                             "G1 X5. E0.5",
                             "// DEBURR",
                             "STOPRE",
                             "L X+10 R0 FMAX",
                             "G810 X5.",
                             "%\nprose between two tapes\n%",
                             "TOOL CALL 5",
                             "X?"}) {
        std::string text = head;
        text.append(slip).append(tail);
        EXPECT_EQ(reported_of(text), "fanuc") << slip;
    }
}

TEST(Detection, NctIsToldByItsForms) {
    EXPECT_EQ(reported_of("%O9601(POCKET)\nG1ZI#23F#9\nM99%"), "nct");
    EXPECT_EQ(reported_of("%O9601(POCKET)\nG1Z#23F#9\nM99%"), "fanuc");
}

TEST(Detection, KlartextIsToldByItsWords) {
    EXPECT_EQ(reported_of("a.h", "0 BEGIN PGM DEMO MM\n1 TOOL CALL 5 Z S2000\n"), "HEIDENHAIN Klartext");
    EXPECT_EQ(reported_of("12 TOOL CALL 5 Z S2000\n13 L Z+100 R0 FMAX M3\n"), "HEIDENHAIN Klartext");
    EXPECT_EQ(reported_of("5 FN 0: Q1 = +5\n6 LBL 1\n7 CALL LBL 1 REP 3\n"), "HEIDENHAIN Klartext");
    EXPECT_EQ(reported_of("%PART G71 *\nN10 T1 G17 S2000 *\nN20 G00 G40 G90 Z+100 *\n"),
              "HEIDENHAIN DIN/ISO");
}

TEST(Detection, SinumerikIsToldByItsExtensionOrItsWords) {
    EXPECT_EQ(reported_of("a.MPF", "G0 X10\nM30"), "sinumerik");
    EXPECT_EQ(reported_of("DEF REAL DEPTH\nR1=5 R2=R1+3\nMSG(\"HELLO\")\nM17"), "sinumerik");
    EXPECT_EQ(reported_of("%_N_PART_MPF\nG0 X10\nM30"), "sinumerik");
    EXPECT_EQ(reported_of("; rough\nG0 X=R1\nIF R1>5 GOTOF NEXT\nR3=R1\nNEXT:\nM30 ; done"), "sinumerik");
    for (const char* text :
         {"G17 G54\nT=\"MILL_D10\" D1 M6\nM30\n", "DEF INT COUNT\nG0 X5\nM30\n",
          "G0 Z=IC(20)\nG0 X20 Z=AC(10)\n", "TRANS X50 Y20\nAROT Z30\nG0 X0\n", "DEFINE MIST AS M27\nM30\n",
          "G1 X25 RND=2 F300\nG1 Y5 CHF=1\n", "G0 X0 SPOS=0\nG331 Z-15 K1.25\nG0 Z5 SPOS=90\n"})
        EXPECT_EQ(reported_of(text), "sinumerik") << text;
}

TEST(Detection, LinuxCncIsToldByOWordsNamesAndItsExtension) {
    EXPECT_EQ(reported_of("o100 sub\nG1 X#1\no100 endsub\n"), "LinuxCNC");
    EXPECT_EQ(reported_of("o<probe> call [1] [2]\nM2\n"), "LinuxCNC");
    EXPECT_EQ(reported_of("#<depth> = 5\nG1 Z#<depth>\nM2\n"), "LinuxCNC");
    EXPECT_EQ(reported_of("G21 G64 P0.01\nG1 X5 F100\nM2\n"), "LinuxCNC");
    EXPECT_EQ(reported_of("(debug, x is #1)\nG1 X5 F100\n(print, done)\nM2\n"), "LinuxCNC");
    EXPECT_EQ(reported_of("a.ngc", "G1 X5 F100\nM2\n"), "LinuxCNC");
}

TEST(Detection, GcodeWithRemarksAfterSemicolonsIsNotOurs) {
    EXPECT_EQ(reported_of("G28 ; home all axes\nM104 S200 ; hot end\nG92 E0\nG1 X5 Y5 E2.5 F1500\n"),
              "a 3D printer");
    EXPECT_EQ(reported_of("; pocket for the hinge\nG21 ; metric\nG0 X5\nM5 ; stop\n"),
              "G-code for LinuxCNC, GRBL, a 3D printer or the like");
    EXPECT_EQ(reported_of("$H\n$120=50\nG0 X5\n"), "GRBL");
}

TEST(Detection, WireErosionAndOkumaAreNamed) {
    EXPECT_EQ(reported_of("//\n//CUTTING CONDITIONS\nE001=10 16 15 09\nE002=09 23 03 07\nG92 X0 Y0\nE1\n"),
              "wire erosion");
    EXPECT_EQ(reported_of("$PART.MIN%\nG15 H1\nVC1=5\nCALL O1000\nM02\n"), "OKUMA OSP");
}

TEST(Detection, DinPlusIsToldBySectionsAndFilesOfSubprograms) {
    const std::string din_plus(test::din_plus);
    for (const char* text : {"PROGRAM HEAD\n#UNIT METRIC\nMACHINING\nN1 G0 X5\nEND",
                             "BEARBEITUNG\nN1 G0 X5\nENDE", "CHUCKING EQUIPMENT 2\nH0 D0 Z200\n",
                             "FACE_C Z-25\nN1 G0 X5\n", "AUXIL_CONTOUR ID\"path\"\nN1 G0 X5 Z0\n",
                             "SUBPROGRAM \"1\"\nN1 G0 X5\nRETURN\n", "%851.nc\nN1 G0 X60 Z2\nEND\n"})
        EXPECT_EQ(reported_of(text), din_plus) << text;
    EXPECT_EQ(reported_of("MEASURE.ncs", "N1 G0 X5\nRETURN\n"), din_plus);
    EXPECT_EQ(reported_of("MEASURE.ncs", ""), din_plus);
}

TEST(Detection, FragmentsOfDinPlusAreToldByVariablesAddressesAndCalls) {
    const std::string din_plus(test::din_plus);
    for (const char* text :
         {"N1 #l1=#l1+1\nN2 IF #l1 < 5\nN3 THEN\n", "#g200=5\n", "N5 IF NDEF(#__la)\nN6 THEN\n",
          "N1 L\"GROOVE\" V1 LA5\n", "N1 T3 G95 F0.25 G96 S200 M3\nN2 G0 X62 Z2\n",
          "N9 G1 X50 BR-2\nN10 G1 Zi-5 BR2\n", "N1 G810 NS7 NE12 P5\nN2 G14 Q0\n",
          "$1$2 N1 M97\n$1 N2 M97 H1\n", "[//]\n[la=1; s=diameter]\n[//]\n",
          "N1 UNIT ID\"START\"\nN2 END_OF_UNIT\n", "N10 G13 X? Z? R15\nN20 G12 X?\n"})
        EXPECT_EQ(reported_of(text), din_plus) << text;
}

TEST(Detection, CommentsBetweenWordsOfDinPlusHideNoWord) {
    const std::string din_plus(test::din_plus);
    for (const char* text : {"N1 T3 G95 [feed] F0.25 G96 S200 M3\nN2 G0 X62 Z2\n",
                             "N1 [tool]T3 G95 F0.25 G96 S200 M3[on]\nN2 G0 X62 Z2\n"})
        EXPECT_EQ(reported_of(text), din_plus) << text;
    // Brackets of others hold a variable, or stand before a sign of equality.
    EXPECT_NE(reported_of("N1 T3 G95 F0.25 G96 [#1] S200 M3\nN2 G0 X62 Z2\n"), din_plus);
}

TEST(Detection, ACommentAtTheHeadOfDinPlusIsNoJson) {
    const std::string program = "\nPROGRAM HEAD\n#UNIT METRIC\nMACHINING\nN1 G0 X5\nEND\n";
    for (const char* comment : {"[Part \"A1\"]", "[{ shaft }]", "[\"A1\"]", "[5]", "[]", "[ {\"A\"} ]"})
        EXPECT_EQ(reported_of(comment + program), test::din_plus) << comment;
    for (const char* json : {"[{\"a\": [1, -2.5e3]}, {\"b\": null}]", "[\n  \"a\\\"b\",\n  true\n]\n",
                             "{\"a\": 1}", "[{\"cut\": \"off"})
        EXPECT_EQ(reported_of(json), "JSON") << json;
}

TEST(Detection, VariablesWithNamesAreBlocks) {
    EXPECT_EQ(reported_of("O1\n[#_DEPTH]=1\n[#_WIDTH]=2\nN3[#FEED]=3\n[ #SPEED]=4\n[#_MAX]=5\n"), "fanuc");
}

TEST(Detection, ALineOfManyWordsTakesNoTime) {
    std::string line = "AA";
    while (line.size() < 64'000) line += " B";
    const auto start = std::chrono::steady_clock::now();
    (void)detect("a.nc", line);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::milliseconds(500));
    EXPECT_EQ(reported_of("FINISHED PART X5 Z\nN1 G0 X5\n"), test::din_plus);
    EXPECT_NE(reported_of("FINISHED PARTS LIST\nN1 G0 X5\n"), test::din_plus);
}

TEST(Detection, TheNoteSaysWhatGaveTheLanguageAwayAndWhere) {
    EXPECT_EQ(detect("a.nc", "G0 X5\n\no100 sub\no100 endsub\n").reason, "LinuxCNC (an o-word on line 3)");
    EXPECT_EQ(detect("a.nc", "G0\n\r\rG1\n\r\r0 BEGIN PGM A MM\n").reason,
              "HEIDENHAIN Klartext (BEGIN PGM on line 3)");
    EXPECT_EQ(detect("a.nc", "G0\n\rG1\n\r0 BEGIN PGM A MM\n").reason,
              "HEIDENHAIN Klartext (BEGIN PGM on line 3)");
    EXPECT_EQ(detect("a.spf", "G0 X5\n").reason, "extension .spf");
    EXPECT_FALSE(detect("a.nc", "o100 sub\no100 endsub\n").not_nc_text);
}

TEST(Detection, OnlyMarksOfFanucMakeItCertain) {
    EXPECT_TRUE(detect("a.nc", "O1\nG0 X5\n").certain);
    EXPECT_FALSE(detect("a.nc", "G0 X5\n").certain);
}

TEST(Detection, EveryLineEndIsOne) {
    for (const char* text : {"%\n\r\rO1\n\r\rG0 X5\n\r\rM30\n\r\r%\n\r\r", "%\rO1\rG0 X5\rM30\r%\r"})
        EXPECT_EQ(reported_of(text), "fanuc");
}

TEST(Detection, WhatIsNoNcTextIsToldSo) {
    const auto expect_none = [](std::string_view text, std::string_view reason) {
        const Detection detection = detect("a.nc", text);
        EXPECT_EQ(detection.dialect, nullptr);
        EXPECT_TRUE(detection.not_nc_text);
        EXPECT_THAT(detection.reason, HasSubstr(std::string(reason)));
    };
    expect_none("{\"a\": 1}", "JSON");
    expect_none("#include <stdio.h>\nint main() {\n  return 0;\n}\n", "C source");
    expect_none("%PDF-1.7\nG0 X1.\n", "PDF");
    expect_none("from a import b\n\nclass C:\n    pass\n", "Python source");
    expect_none("# Title\n\n## Part\n\n```\nG0 X1.\n```\n", "Markdown");
    expect_none("<?xml version=\"1.0\"?>\n<a/>", "XML");
    expect_none(std::string_view("\x7F"
                                 "ELF\x02\x01\x01\0\0\0\0\0\0\0\0\0\x03\0>\0\x01\0\0\0",
                                 24),
                "binary");
    expect_none(
        "Dear customer,\nplease find attached; thanks again\nthe drawing; it is final\nKind regards\n",
        "text of another kind");
}

TEST(Detection, ExtensionsWorthOpening) {
    for (const char* path : {"parts/A.NC", "O9100", "a.ncs", "a.MPF", "plan.h"})
        EXPECT_TRUE(has_nc_extension(path)) << path;
    for (const char* path : {"O9010_TORUS", "o12 (A)", "nc40", "1234", "a.din", "a.MIN", "a.eia"})
        EXPECT_TRUE(has_nc_extension(path)) << path;
    for (const char* path : {"README", "a.cpp", "a.json", "Oil", "O1A", "123456789", "nc", "ncx"})
        EXPECT_FALSE(has_nc_extension(path)) << path;
    EXPECT_TRUE(is_worth_a_note("noise.nc"));
    EXPECT_TRUE(is_worth_a_note("O9010_TORUS"));
    for (const char* path : {"README.txt", "2024", "nc40"}) EXPECT_FALSE(is_worth_a_note(path)) << path;
}

} // namespace
} // namespace maclint
