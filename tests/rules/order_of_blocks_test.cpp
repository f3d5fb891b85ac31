//! What stands behind what: contours behind cycles, measuring moves, threads and undercuts, names of
//! contours.
#include "tests/rules/din_findings.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::uint32_t> machined(std::string_view code, const std::string& blocks) {
    return din_lines(code, "MACHINING\n" + blocks + "M30\nEND\n");
}

TEST(ContoursBehindCycles, AreThereAndEnd) {
    const std::string contour = "G0 X50 Z0\nG1 Z-30\n";
    EXPECT_THAT(machined("DIN246", "G810 P2\n" + contour + "G80\nG14 Q0\n"), IsEmpty());
    EXPECT_THAT(machined("DIN246", "G810 P2\n" + contour + "G14 Q0\n"), ElementsAre(5));
    EXPECT_THAT(machined("DIN246", "G810 P2\n" + contour), ElementsAre(5)) << "the end of the program";
    EXPECT_THAT(machined("DIN246", "G810 P2\nG0 X50 Z0\nG14 Q0\n"), ElementsAre(4)) << "of one element";
    EXPECT_THAT(machined("DIN246", "G890 V1\nG14 Q0\n"), IsEmpty()) << "the cycle says that none is there";
    EXPECT_THAT(machined("DIN246", "G890 V1\nG80 XS50 ZS0 XE60 ZE-20\nG14 Q0\n"), IsEmpty());
    EXPECT_THAT(machined("DIN246", "G890 V1\nL\"SHAPE\" V1\nG14 Q0\n"), IsEmpty()) << "the program has it";
    EXPECT_THAT(machined("DIN246", "G810 NS3 NE5 P2\nG14 Q0\n"), IsEmpty());
    EXPECT_THAT(machined("DIN246", "G870 NS3 I0.1\nG80\n"), ElementsAre(3)) << "nothing to end";
    EXPECT_THAT(machined("DIN246", "G83 XE40\nG870 NS3 I0.1\nG80\n"), IsEmpty()) << "it ends G83";
}

TEST(MeasuringMoves, AreOneUnderTheirMonitoring) {
    const std::string begin = "G910 V0 D1\nG911 V0\n";
    EXPECT_THAT(machined("DIN951", begin + "G1 Xi-10\nG914\n"), IsEmpty());
    EXPECT_THAT(machined("DIN951", begin + "G1 Xi-10\nG1 Zi-1\nG914\n"), ElementsAre(5));
    EXPECT_THAT(machined("DIN951", begin + "G1 Xi-10\nG914\nG1 Zi-1\n"), IsEmpty());
    EXPECT_THAT(machined("DIN951", begin + "G914\nG1 Xi-10\n"), IsEmpty()) << "MAC580 asks for the move";
    EXPECT_THAT(machined("DIN951", begin + "G94 F400 G1 Xi-10\nG914\n"), IsEmpty());
    EXPECT_THAT(machined("DIN951", "G94 F400 G1 X90\n" + begin + "Xi-10\nG914\n"), IsEmpty());
    EXPECT_THAT(machined("DIN951", "G94 F400 G1 X90\n" + begin + "Xi-10\nZi-1\nG914\n"), ElementsAre(6));
    EXPECT_THAT(machined("DIN951", "G94 F400 G1 X90\n" + begin + "G0 Xi-10\nZi-1\nG914\n"), IsEmpty());
    EXPECT_THAT(machined("DIN951", begin + "L\"TOUCH\" V1\nG914\n"), IsEmpty()) << "it moves there";
}

TEST(Choices, HaveOneElse) {
    const std::string begin = "IF #g1>3\nTHEN\nG4 F1\nELSE\nG4 F2\n";
    EXPECT_THAT(machined("DIN423", begin + "ENDIF\n"), IsEmpty());
    EXPECT_THAT(machined("DIN423", begin + "ELSE\nG4 F3\nENDIF\n"), ElementsAre(7));
    EXPECT_THAT(machined("DIN423", begin + "IF #g1>4\nTHEN\nG4 F3\nELSE\nG4 F4\nENDIF\nENDIF\n"), IsEmpty());
}

TEST(InterpolationValues, AreTakenOverBeforeTheyAreRead) {
    EXPECT_THAT(machined("DIN317", "G904\nG909\n#l7=#a1(Z,1)\n"), IsEmpty());
    EXPECT_THAT(machined("DIN317", "G904\n#l7=#a1(Z,1)\n"), ElementsAre(3)) << "read ahead";
    EXPECT_THAT(machined("DIN317", "G909\n#l7=#a1(Z,1)\n"), ElementsAre(3));
    EXPECT_THAT(machined("DIN317", "G912 Q1\n#l7=#a9(X,0)\n"), IsEmpty());
    EXPECT_THAT(machined("DIN317", "G901\nG909\n#l7=#a9(X,0)\n"), ElementsAre(4));
    EXPECT_THAT(machined("DIN317", "G905 Q1\nG909\n#l7=#a0(C,1)\n"), IsEmpty());
    EXPECT_THAT(machined("DIN317", "G909\nIF #a1(Z,1)>5\nTHEN\nG4 F1\nENDIF\n"), ElementsAre(3)) << "once";
    EXPECT_THAT(machined("DIN317", "#l1=0\nWHILE #l1<3\nIF #l1>0\nTHEN\n#l7=#a1(Z,1)\nENDIF\nG904\nG909\n"
                                   "#l1=#l1+1\nENDWHILE\n"),
                IsEmpty())
        << "the pass before has filled it";
    std::string moves;
    for (int i = 0; i < 6000; ++i) moves += "G1 X" + std::to_string(i % 90) + ".5 Z-1\n";
    EXPECT_THAT(machined("DIN317", moves + "G904\nG909\n#l7=#a1(Z,1)\n"), IsEmpty()) << "too long to be kept";
    EXPECT_THAT(machined("DIN317", "L\"FILL\" V1\n#l7=#a1(Z,1)\n"), IsEmpty()) << "filled there";
}

TEST(BlocksBehindAnEnd, AreReachedWhereTheProgramBeginsThere) {
    EXPECT_THAT(machined("MAC460", "N5 G14 Q0\nN6 M30\nN7 G14 Q1\n"), ElementsAre(4));
    EXPECT_THAT(machined("MAC460", "N5 G14 Q0\nIF #g1>1\nTHEN\nN8 M99 NS40\nENDIF\nN10 M30\nN40 G14 Q0\n"),
                IsEmpty());
}

TEST(NamesOfContours, AreThoseOfOneKind) {
    const auto lines = [](std::string_view code, const std::string& contours, const std::string& cycle) {
        return din_lines(code, contours + "MACHINING\nT1\n" + cycle + "\nM30\nEND\n");
    };
    const std::string contour = "AUXIL_CONTOUR ID\"A\"\nG0 X40 Z0\nG1 Z-20\n";
    EXPECT_THAT(lines("DIN247", contour + "AUXIL_CONTOUR ID\"A\"\nG0 X30 Z0\nG1 Z-9\n", "G810 ID\"A\" P2"),
                ElementsAre(4));
    EXPECT_THAT(lines("DIN247", "AUXIL_BLANK ID\"A\"\nG20 X60 Z50\n" + contour, "G810 ID\"A\" P2"),
                IsEmpty());
    EXPECT_THAT(lines("DIN247", "FACE_C Z0\nG308 ID\"A\" P-2\nG405 ID\"A\" XK0 YK0\nG300 B2 P2\nG309\n",
                      "G72 ID\"A\""),
                IsEmpty())
        << "a text to be engraved";
    const std::string unnamed = "AUXIL_CONTOUR\nG0 X40 Z0\nG1 Z-20\n";
    EXPECT_THAT(lines("DIN205", unnamed, "G810 ID\"A\" P2"), ElementsAre(6));
    EXPECT_THAT(lines("DIN205", unnamed, "G67 ID\"SHAFT\""), IsEmpty()) << "a blank";
    EXPECT_THAT(lines("DIN204",
                      "AUXIL_CONTOUR ID\"A\"\nIF #g1>1\nTHEN\nG0 X60 Z0\nELSE\nG0 X62 Z0\nENDIF\nG1 Z-20\n",
                      ""),
                IsEmpty());
}

std::vector<std::uint32_t> with_contours(std::string_view code, const std::string& cycle) {
    return din_lines(code, "FINISHED\nN2 G0 X0 Z0\nN3 G1 X50\nN4 G1 Z-40\nN5 G34 F2\nN6 G1 X60\nN7 G1 Z-60\n"
                           "AUXIL_CONTOUR ID\"A\"\nN8 G0 X40 Z0\nN9 G1 Z-20\nLATERAL_Y X60\n"
                           "N10 G380 Z-20 Y0 B8 P9\nMACHINING\nT1\n" +
                               cycle + "\nM30\nEND\n");
}

TEST(ContourReferences, StayInOneContour) {
    EXPECT_THAT(with_contours("DIN705", "G810 NS3 NE4 P2"), IsEmpty());
    EXPECT_THAT(with_contours("DIN705", "G810 NS3 NE9 P2"), ElementsAre(15));
    EXPECT_THAT(with_contours("DIN705", "G810 NS3 NE99 P2"), IsEmpty()) << "told elsewhere";
}

TEST(ContourReferences, NameThreadsForG31) {
    EXPECT_THAT(with_contours("DIN720", "G31 NS4 NE4 B5"), IsEmpty());
    EXPECT_THAT(with_contours("DIN720", "G31 NS7 B5"), ElementsAre(15)) << "the last one";
    EXPECT_THAT(with_contours("DIN720", "G31 NS3 B5"), ElementsAre(15));
    EXPECT_THAT(with_contours("DIN720", "G31 NS3 B5 F2"), IsEmpty());
    EXPECT_THAT(with_contours("DIN720", "G31 NS3 NE4 B5"), IsEmpty());
}

TEST(ContourReferences, KeepThePlaneOfTheContour) {
    EXPECT_THAT(with_contours("DIN833", "G19\nG71 NS10 V2"), IsEmpty());
    EXPECT_THAT(with_contours("DIN833", "G17\nG71 NS10 V2"), ElementsAre(16));
    EXPECT_THAT(with_contours("DIN833", "L\"PLANE\" V1\nG71 NS10 V2"), IsEmpty());
    EXPECT_THAT(with_contours("DIN833", "G17\nG810 NS3 P2"), IsEmpty());
}

TEST(ContourGroups, AreDescribedWhereTheyAreChosen) {
    const std::string groups = "CONTOUR Q1 X0 Z0\nFINISHED\nG0 X0 Z0\nCONTOUR Q2 X0 Z0\nFINISHED\nG0 X0 Z0\n";
    EXPECT_THAT(din_lines("DIN108", groups + "MACHINING\nG99 Q2\nM30\nEND\n"), IsEmpty());
    EXPECT_THAT(din_lines("DIN108", groups + "MACHINING\nG99 Q3\nM30\nEND\n"), ElementsAre(8));
    EXPECT_THAT(din_lines("DIN108", "FINISHED\nG0 X0 Z0\nMACHINING\nG99 Q1\nM30\nEND\n"), IsEmpty());
}

TEST(Undercuts, HaveAShoulderAlongX) {
    const auto corner = [](const std::string& next) {
        return din_lines("DIN217",
                         "FINISHED\nG0 X40 Z0\nG1 Z-30\nG25 H6\n" + next + "\nMACHINING\nM30\nEND\n");
    };
    EXPECT_THAT(corner("G1 X60"), IsEmpty());
    EXPECT_THAT(corner("G1 X60 Z-34"), ElementsAre(4));
    EXPECT_THAT(corner("G37 Q1 F2\nG1 X60"), IsEmpty());
    EXPECT_THAT(corner("G1 AN100"), IsEmpty()) << "nobody knows";
}

TEST(ContourNames, AreOfOneContour) {
    const auto names = [](const std::string& second, const std::string& wanted) {
        return din_lines("DIN247", "FACE_C Z0\nG308 ID\"A\" P-3\nG304 XK0 YK0 R5\nG309\nG308 ID\"" + second +
                                       "\" P-3\nG304 XK30 YK0 R5\nG309\nMACHINING\nG845 ID\"" + wanted +
                                       "\" P1\nM30\nEND\n");
    };
    EXPECT_THAT(names("B", "A"), IsEmpty());
    EXPECT_THAT(names("A", "A"), ElementsAre(5));
    EXPECT_THAT(names("A", "C"), IsEmpty()) << "nobody asks";
}

TEST(ContourNames, AreMissedWhereTheOnlyContourHasNone) {
    const auto asked = [](const std::string& heading) {
        return din_lines("DIN205", heading + "\nG0 X60 Z0\nG1 X50\nMACHINING\nG810 ID\"A\" P2\nM30\nEND\n");
    };
    EXPECT_THAT(asked("AUXIL_CONTOUR"), ElementsAre(5));
    EXPECT_THAT(asked("AUXIL_CONTOUR ID\"A\""), IsEmpty());
    EXPECT_THAT(asked("FINISHED"), IsEmpty()) << "the contour may stand in another file";
}

TEST(Blanks, HaveMaterialOutsideTheirBore) {
    const auto bore = [](const std::string& blank) {
        return din_lines("DIN209",
                         "BLANK\n" + blank + "\nFINISHED\nG0 X30 Z0\nG1 X60\nG1 Z-40\nMACHINING\nM30\nEND\n");
    };
    EXPECT_THAT(bore("G20 X70 Z60 K1 I28"), IsEmpty());
    EXPECT_THAT(bore("G20 X70 Z60 K1 I36"), ElementsAre(4));
}

} // namespace
} // namespace maclint::test
