//! Contours on the face and the lateral surface, recesses on their lines, sizes of figures.
#include "tests/rules/din_findings.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::uint32_t> on_surface(std::string_view code, const std::string& heading,
                                      const std::string& blocks) {
    return din_lines(code, heading + "\n" + blocks + "MACHINING\nM30\nEND\n");
}

TEST(SurfaceContours, HoldArcsAgainstRadiusAndCentre) {
    const std::string face = "FACE_C Z0";
    EXPECT_THAT(on_surface("DIN662", face, "G100 XK40 YK0\nG103 XK40 YK16 R8\n"), IsEmpty());
    EXPECT_THAT(on_surface("DIN662", face, "G100 XK40 YK0\nG103 XK40 YK16 R7\n"), ElementsAre(3));
    EXPECT_THAT(on_surface("DIN662", face, "G100 XK40 YK0\nG103 XK40 YK16 I40 J8\n"), IsEmpty());
    EXPECT_THAT(on_surface("DIN662", face, "G100 XK40 YK0\nG103 XK40 YK16 I40 J2\n"), ElementsAre(3));
    EXPECT_THAT(on_surface("DIN662", face, "G100 X40 C0\nG103 XK40 YK16 R1\n"), IsEmpty()) << "polar";
    EXPECT_THAT(on_surface("DIN662", face, "G100 XK40 YK0\nG101 AN90\nG103 XK40 YK16 R1\n"), IsEmpty());
    EXPECT_THAT(on_surface("DIN662", "LATERAL_C X100", "G110 Z-85 CY110\nG112 Z-85 CY130 R8\n"),
                ElementsAre(3));
    EXPECT_THAT(on_surface("DIN662", "LATERAL_C X100", "G110 Z-85 CY110\nG112 Z-85 C9 R8\n"), IsEmpty());
    EXPECT_THAT(on_surface("DIN662", "LATERAL_Y X100", "G180 Y0 Z-10\nG182 Z-30 J0 K-22\n"), ElementsAre(3));
    EXPECT_THAT(on_surface("DIN229", face, "G100 XK40 YK0\nG103 XK40 YK0 I30 J0\n"), ElementsAre(3));
}

std::vector<std::uint32_t> pocket(const std::string& last, const std::string& cycle) {
    return din_lines("DIN241",
                     "FACE_C Z0\nG308 ID\"FREE\" P-3\nN3 G100 XK0 YK0\nN4 G101 XK20\nN5 G101 YK20\n" + last +
                         "G309\nMACHINING\n" + cycle + "\nM30\nEND\n");
}

TEST(SurfaceContours, AreClosedWherePocketsAreMilled) {
    EXPECT_THAT(pocket("N6 G101 XK0 YK0\n", "G845 ID\"FREE\" P1"), IsEmpty());
    EXPECT_THAT(pocket("", "G845 ID\"FREE\" P1"), ElementsAre(8));
    EXPECT_THAT(pocket("", "G846 NS3 P1"), ElementsAre(8));
    EXPECT_THAT(pocket("", "G845 NS4 P1"), ElementsAre(8));
    EXPECT_THAT(pocket("", "G845 NS4 NE5 P1"), IsEmpty()) << "a part of it";
    EXPECT_THAT(pocket("", "G840 ID\"FREE\" P1"), IsEmpty()) << "may be open";
    EXPECT_THAT(pocket("N6 G101 XK#x YK0\n", "G845 ID\"FREE\" P1"), IsEmpty()) << "nobody knows";
    EXPECT_THAT(pocket("L\"REST\" V1\n", "G845 ID\"FREE\" P1"), IsEmpty()) << "the program goes on with it";
}

std::vector<std::uint32_t> on_line(const std::string& form) {
    return din_lines("DIN213", "FINISHED\nG0 X40 Z0\nG1 Z-30\n" + form + "\nG1 X60\nMACHINING\nM30\nEND\n");
}

TEST(Recesses, LieOnTheirLine) {
    EXPECT_THAT(on_line("G22 Z-20 I36 Ki-5"), IsEmpty());
    EXPECT_THAT(on_line("G22 Z-20 I36 K-30"), IsEmpty()) << "to its end";
    EXPECT_THAT(on_line("G22 Z-20 I36 K-31"), ElementsAre(4));
    EXPECT_THAT(on_line("G22 Z-28 I36 Ki-5"), ElementsAre(4));
    EXPECT_THAT(on_line("G22 Z2 I36 Ki-5"), ElementsAre(4));
    EXPECT_THAT(on_line("G23 H0 Z-20 I-2 K4"), IsEmpty());
    EXPECT_THAT(on_line("G23 H0 Z-35 I-2 K4"), ElementsAre(4));
    EXPECT_THAT(on_line("G23 H0 Z-20 I-2 K31"), ElementsAre(4));
    EXPECT_THAT(on_line("G37 Q1 F2 K31"), IsEmpty()) << "no line of the manual bounds its run-out";
    EXPECT_THAT(on_line("L\"STEP\" V1\nG22 Z-50 I36 Ki-3"), IsEmpty()) << "the program may go on to there";
    EXPECT_THAT(on_line("/G1 Z-60\nG22 Z-50 I36 Ki-3"), IsEmpty());
    EXPECT_THAT(on_line("G24 F2 I1.5 K6 Z-50"), IsEmpty()) << "20 more along Z";
    EXPECT_THAT(on_line("G24 F2 I1.5 K21 Z-50"), ElementsAre(4));
    EXPECT_THAT(on_line("G1 X50 Z-40\nG22 Z-35 I36 Ki-2"), ElementsAre(5)) << "oblique";
    EXPECT_THAT(on_line("G1 X50\nG22 X46 I44 Ki-2"), IsEmpty());
    EXPECT_THAT(on_line("G1 X50\nG22 X52 I44 Ki-2"), ElementsAre(5));
}

std::vector<std::uint32_t> figure(const std::string& blocks) {
    return din_lines("DIN243", "FACE_C Z0\nG308 ID\"A\" P-3\n" + blocks + "\nG309\nMACHINING\nM30\nEND\n");
}

TEST(Corners, FitTheLinesOfAClosedContour) {
    const auto lines = [](const std::string& corner) {
        return din_lines("DIN239", "FINISHED\nG0 X20 Z0\nG1 X40\nG1 Z-40\nG1 X20\nG1 Z0 BR" + corner +
                                       "\nMACHINING\nM30\nEND\n");
    };
    EXPECT_THAT(lines("-8"), IsEmpty());
    EXPECT_THAT(lines("-12"), ElementsAre(6)) << "the first line is 10 long";
    EXPECT_THAT(din_lines("DIN239", "FINISHED\nG0 X20 Z0\nG1 X40 Z-20 BR5\nG1 X20 Z0\nMACHINING\nM30\nEND\n"),
                IsEmpty())
        << "it turns back";
}

TEST(Undercuts, StandAtAShoulder) {
    const auto lines = [](const std::string& before, const std::string& behind) {
        return din_lines("DIN217", "FINISHED\nG0 X0 Z0\n" + before + "\nG25 H6 I2 K5 R1\n" + behind +
                                       "\nMACHINING\nM30\nEND\n");
    };
    EXPECT_THAT(lines("G1 X40\nG1 Z-30", "G1 X60"), IsEmpty());
    EXPECT_THAT(lines("G1 X40\nG1 Z-30", "G1 X60 Z-50"), ElementsAre(5));
    EXPECT_THAT(lines("G1 X40", "G1 X44 Z-60"), IsEmpty()) << "the shoulder is the line before";
}

TEST(Figures, HaveSizesThatGoTogether) {
    EXPECT_THAT(figure("G301 XK0 YK0 K20 B8"), IsEmpty());
    EXPECT_THAT(figure("G301 XK0 YK0 K6 B8"), ElementsAre(3));
    EXPECT_THAT(figure("G305 XK0 YK0 K60 B36 R18"), IsEmpty());
    EXPECT_THAT(figure("G305 XK0 YK0 K60 B36 R19"), ElementsAre(3));
    EXPECT_THAT(figure("G303 I0 J0 R10 A0 W90 B21"), ElementsAre(3));
    EXPECT_THAT(figure("G307 XK0 YK0 Q2 K20"), ElementsAre(3));
}

std::vector<std::uint32_t> pattern(const std::string& blocks) {
    return din_lines("DIN244", "FACE_C Z0\nG308 ID\"A\" P-3\n" + blocks + "\nG309\nMACHINING\nM30\nEND\n");
}

TEST(Figures, OfPatternsAreApart) {
    EXPECT_THAT(pattern("G402 Q8 K120 A0 XK0 YK0\nG300 B9 P5"), IsEmpty());
    EXPECT_THAT(pattern("G402 Q48 K120 A0 XK0 YK0\nG300 B9 P5"), ElementsAre(3));
    EXPECT_THAT(pattern("G402 Q48 K120 A0 Wi90 XK0 YK0\nG300 B9 P5"), IsEmpty()) << "steps of 90 degrees";
    EXPECT_THAT(pattern("G401 Q3 XK0 YK0 Ii10 Ji0\nG300 B9 P5"), IsEmpty());
    EXPECT_THAT(pattern("G401 Q3 XK0 YK0 Ii6 Ji6\nG300 B9 P5"), ElementsAre(3));
    EXPECT_THAT(pattern("G401 Q3 XK0 YK0 I6 J0\nG300 B9 P5"), IsEmpty()) << "the last one lies there";
}

TEST(Outline, HoldsRoundingsAgainstTheirLines) {
    const auto rounding = [](const std::string& blocks) {
        return din_lines("DIN239", "FINISHED\nG0 X40 Z0\n" + blocks + "MACHINING\nM30\nEND\n");
    };
    EXPECT_THAT(rounding("G1 Z-20 BR5\nG1 X50\n"), IsEmpty());
    EXPECT_THAT(rounding("G1 Z-20 BR6\nG1 X50\n"), ElementsAre(3));
    EXPECT_THAT(rounding("G1 Z-20 BR6\nG1 X50 Z-40\n"), IsEmpty()) << "a flat corner takes less";
}

TEST(AuxiliaryContours, BeginOnce) {
    const std::string rest = "G1 Z-10\nMACHINING\nM30\nEND\n";
    EXPECT_THAT(din_lines("DIN204", "AUXIL_CONTOUR ID\"A\"\nG0 X40 Z0\n" + rest), IsEmpty());
    EXPECT_THAT(din_lines("DIN204", "AUXIL_CONTOUR ID\"A\"\nG0 X40 Z0\nG1 Z-5\nG0 X50 Z-9\n" + rest),
                ElementsAre(4));
    EXPECT_THAT(din_lines("DIN204", "FINISHED\nG0 X40 Z0\nG1 Z-5\nG0 X50 Z-9\n" + rest), IsEmpty());
}

} // namespace
} // namespace maclint::test
