//! Arcs, chamfers and blanks of turning contours.
#include "tests/rules/din_findings.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::uint32_t> of_contour(std::string_view code, const std::string& blocks) {
    return din_lines(code, "FINISHED\n" + blocks + "MACHINING\nM30\nEND\n");
}

TEST(Outline, HoldsArcsAgainstTheirRadius) {
    // From radius 20 to 30, and 10 along Z: the ends are 14.14 apart.
    EXPECT_THAT(of_contour("DIN662", "G0 X40 Z0\nG3 X60 Z-10 R10\n"), IsEmpty());
    EXPECT_THAT(of_contour("DIN662", "G0 X40 Z0\nG3 X60 Z-10 R7\n"), ElementsAre(3));
    EXPECT_THAT(of_contour("DIN662", "G0 X40 Z0\nG3 X60 Z-10 R7.05\n"), IsEmpty()) << "rounded";
    EXPECT_THAT(of_contour("DIN662", "G0 X40 Z0\nG3 X60 Zi-10 R10\n"), IsEmpty());
    EXPECT_THAT(of_contour("DIN662", "G0 X40 Z0\nG3 Xi20 Z-10 R1\n"), IsEmpty()) << "a radius or a diameter";
}

TEST(Outline, HoldsArcsAgainstTheirCentre) {
    EXPECT_THAT(of_contour("DIN662", "G0 X40 Z0\nG3 X60 Z-10 I0 K-10\n"), IsEmpty());
    EXPECT_THAT(of_contour("DIN662", "G0 X40 Z0\nG3 X60 Z-10 I0 K-12\n"), ElementsAre(3));
    EXPECT_THAT(of_contour("DIN662", "G0 X40 Z0\nG13 X60 Z-10 I20 K-10\n"), IsEmpty()) << "absolute";
    EXPECT_THAT(of_contour("DIN662", "G0 X40 Z0\nG13 X60 Z-10 I0 K-10\n"), ElementsAre(3));
    EXPECT_THAT(of_contour("DIN662", "G0 X40 Z0\nG3 X60 Z-10 I4\n"), IsEmpty()) << "the control finds K";
}

TEST(Outline, PassesFormElementsAndUnknownPoints) {
    EXPECT_THAT(of_contour("DIN662", "G0 X40 Z0\nG1 Z-30\nG22 Z-10 I16 K-12\nG3 X60 Z-40 R10\n"), IsEmpty())
        << "the recess lies on the line";
    EXPECT_THAT(of_contour("DIN662", "G0 X40 Z0\nG1 AN170\nG3 X90 Z-40 R1\n"), IsEmpty());
    EXPECT_THAT(din_lines("DIN662", "MACHINING\nT1\nG0 X40 Z0\nG3 X60 Z-10 R5\nM30\nEND\n"), ElementsAre(4));
    EXPECT_THAT(din_lines("DIN662", "MACHINING\nT1\nG0 X40 Z0\nG14 Q0\nG3 X60 Z-10 R5\nM30\nEND\n"),
                IsEmpty());
}

TEST(Outline, BeginsWithAStartPointUnlessACallMayHoldIt) {
    EXPECT_THAT(of_contour("MAC527", "G1 X40 Z0\nG1 Z-30\n"), ElementsAre(2));
    EXPECT_THAT(of_contour("MAC527", "L\"PART\" V1\nG1 X40 Z0\n"), IsEmpty());
    EXPECT_THAT(of_contour("MAC527", "G0 X0 Z0\n" + std::string(300, '\n') + "G1 X40 Z0\n"), IsEmpty())
        << "far above";
}

TEST(Outline, HoldsTheFinishedPartAgainstTheBar) {
    const auto part = [](const std::string& blank, const std::string& contour) {
        return din_lines("DIN209", "BLANK\n" + blank + "FINISHED\n" + contour + "MACHINING\nM30\nEND\n");
    };
    EXPECT_THAT(part("G20 X60 Z50 K1\n", "G0 X0 Z0\nG1 X60\nG1 Z-49\n"), IsEmpty());
    EXPECT_THAT(part("G20 X60 Z50 K1\n", "G0 X0 Z0\nG1 X60\nG1 Z-49.5\n"), ElementsAre(6));
    EXPECT_THAT(part("G20 X60 Z50 K1\n", "G0 X0 Z0\nG1 X60.5\nG1 Z-40\n"), ElementsAre(5));
    EXPECT_THAT(part("G20 X60 Z50 K1\n", "G0 X0 Z1.5\nG1 X40\nG1 Z-40\n"), ElementsAre(4));
    EXPECT_THAT(part("G0 X70 Z0\nG1 Z-80\n", "G0 X0 Z0\nG1 X90\nG1 Z-40\n"), IsEmpty()) << "no bar";
}

} // namespace
} // namespace maclint::test
