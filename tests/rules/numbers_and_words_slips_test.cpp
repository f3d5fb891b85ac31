//! Slips in numbers and words, each beside what is right.
#include "analyzer/dialect/dialect.hpp"
#include "tests/rules/raised.hpp"
#include "tests/support/linted.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::lines_raised;
using test::messages_raised;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(AngleConvertedTwice, WhicheverAssignmentRan) {
    const auto told = [](const std::string& turned, const std::string& use) {
        return lines_raised("MAC707", "O9171\n#10=ATAN[#9]/[#8]\nIF[#10GT180]THEN#10=" + turned + "\n" + use +
                                          "\nM99\n");
    };
    EXPECT_THAT(told("#10-360", "#10=#10*57.2958\nG0X[COS[#10]]"), ElementsAre(4));
    EXPECT_THAT(told("#10-360", "G0X[COS[#10*180/3.14159]]"), ElementsAre(4));
    EXPECT_THAT(told("#10-360", "G0A[#10*57.2958+5.]"), ElementsAre(4));
    EXPECT_THAT(told("#10-360", "G0X[#18*#10/57.2958]"), IsEmpty());          // the length of an arc
    EXPECT_THAT(told("#18/#7", "#10=#10*57.2958\nG0X[COS[#10]]"), IsEmpty()); // radians on one way
}

TEST(AngleConvertedTwice, ByTheFactorForTheOtherWay) {
    const auto told = [](const std::string& argument) {
        return lines_raised("MAC707",
                            "O9174\n#30=3.14159265/180\n#33=ACOS[#11/#18]\n#31=#33*#30\nG0X[#18*SIN[" +
                                argument + "]]Y[#18*#31]\nM99\n");
    };
    EXPECT_THAT(told("#33/#30"), ElementsAre(5));
    EXPECT_THAT(told("#33"), IsEmpty());
    EXPECT_THAT(told("#31/#30"), IsEmpty()); // back again
}

TEST(AngleInRadians, IsPassedToAProgramThatTakesDegrees) {
    const auto told = [](const std::string& argument, const std::string& use) {
        return messages_raised("MAC707", "O0173\n#101=8.5\n#102=3.14159265\nG65P9173A" + argument +
                                             "\nM30\nO9173\n#30=" + use + "\nG0X#30\nM99\n");
    };
    EXPECT_THAT(told("[#101*#102/180]", "TAN[#1]"),
                ElementsAre(HasSubstr("'[#101*#102/180]' is passed in radians, and O9173 takes degrees in "
                                      "'TAN[#1]'")));
    EXPECT_THAT(told("#101", "TAN[#1]"), IsEmpty());
    EXPECT_THAT(told("[#101*#102/180]", "TAN[#1*57.2958]"), IsEmpty());
    EXPECT_THAT(told("[#101*#102/180]", "TAN[#2]"), IsEmpty());
    EXPECT_THAT(told("[#101*#102/180]", "#1*5."), IsEmpty()); // an arc
}

TEST(ToleranceInsideAbs, IsWhatARemarkCallsSo) {
    const auto told = [](const std::string& remark, const std::string& difference) {
        return lines_raised("MAC727", "O9192(" + remark + ")\n#30=" + difference +
                                          "\nIF[ABS[#30]GT0]GOTO1\nM99\nN1#3000=1(OUT)\n");
    };
    EXPECT_THAT(told("X Y NOMINAL, E TOLERANCE", "#135-#24-#8"), ElementsAre(3));
    EXPECT_THAT(told("E=TOL.", "#135-#24+#8"), ElementsAre(3));
    EXPECT_THAT(told("#8 MARGIN", "#135-#24-#8"), ElementsAre(3));
    EXPECT_THAT(told("#8 MARGIN", "#135-[#24+#8]"), ElementsAre(3));
    EXPECT_THAT(told("E OFFSET", "#135-#24-#8"), IsEmpty());
    EXPECT_THAT(told("X E TOLERANCE", "#135-#24-#8"), IsEmpty()); // of both
    EXPECT_THAT(told("ONE TOLERANCE", "#135-#24-#8"), IsEmpty());
    EXPECT_THAT(told("X NOMINAL, E TOLERANCE", "ABS[#135-#24]-#8"), IsEmpty());
}

TEST(ToleranceInsideAbs, IsANumberThatAVariableHolds) {
    const auto told = [](const std::string& number, const std::string& condition) {
        return lines_raised("MAC727", "O0193\n#501=" + number + "\n#1=40.1\nWHILE[" + condition +
                                          "]DO1\n#1=#1-.05\nG0X#1\nEND1\nM30\n");
    };
    EXPECT_THAT(told(".02", "ABS[#1-#500-#501]GT0"), ElementsAre(4));
    EXPECT_THAT(told("2.", "ABS[#1-#500-#501]GT0"), IsEmpty());
    EXPECT_THAT(told(".02", "[ABS[#1-#500]-#501]GT0"), IsEmpty());
}

TEST(ConditionOnAnAmount, IsNeverBelowZero) {
    const auto told = [](const std::string& condition) {
        return lines_raised("MAC718", "O9191\nG31Z[#26-5.]F300.\nIF[" + condition +
                                          "]GOTO50\n#3000=92(TOOL CHIPPED)\nN50G0Z50.\nM99\n");
    };
    EXPECT_THAT(told("ABS[#5063-#26-.2]LT0"), ElementsAre(3));
    EXPECT_THAT(told("[ABS[#5063-#26]-.2]LT0"), IsEmpty());
    EXPECT_THAT(told("ABS[#5063-#26-.2]LE0"), IsEmpty());
    EXPECT_THAT(told("1-#26*#26/900LT0"), IsEmpty());
}

TEST(NumberForAVariable, IsAllThatAWordCalculates) {
    const auto told = [](const std::string& word, const std::string& read) {
        return lines_raised("MAC229", "O9114\nG65P9115Z#26" + read + "\nG65P9115Z#26" + word + "\nM99\n");
    };
    EXPECT_THAT(told("Q[17/2]", "Q[#17*2]"), ElementsAre(3));
    EXPECT_THAT(told("Z[26+.2]", ""), ElementsAre(3));
    EXPECT_THAT(told("F[9/2]", "F#9"), ElementsAre(3));
    EXPECT_THAT(told("F[9/2]", "F[#9+1]"), IsEmpty()); // a small number
    EXPECT_THAT(told("Q[17./2]", "Q#17"), IsEmpty());
    EXPECT_THAT(told("R[17/2]", "Q#17"), IsEmpty()); // the number of another letter
    EXPECT_THAT(told("Q[17/2]", "Q3."), IsEmpty());
}

TEST(NumberForAVariable, IsThatOfTheOneBesideItsNeighbour) {
    const auto told = [](const std::string& block) {
        return lines_raised("MAC229", "O112\n#101=25.\n#102=14.\n#103=3.\n" + block + "\nG0X[#102*2]\nM30\n");
    };
    EXPECT_THAT(told("G0X[#101*#4]Y[102+#5]"), ElementsAre(5));
    EXPECT_THAT(told("G65P8112X[#103*#4]Y[#5-102]"), ElementsAre(5));
    EXPECT_THAT(told("G0X[101*#4]Y[2.-#102/2]"), ElementsAre(5));
    EXPECT_THAT(told("G0X[#101*#4]Y[102.+#5]"), IsEmpty());
    EXPECT_THAT(told("G0X[#101*#4]Y[105+#5]"), IsEmpty()); // no variable of the program's
    EXPECT_THAT(told("G0X[#4*2]Y[102+#5]"), IsEmpty());
}

TEST(SystemVariable, LiesBetweenTheListsOfModalValues) {
    for (const char* number : {"4150", "4035", "4250", "4340", "4460"})
        EXPECT_THAT(messages_raised("MAC202", "O9151\nIF[#" + std::string(number) + "NE#20]GOTO9\nN9M99\n"),
                    ElementsAre(HasSubstr("no list of system variables holds '#" + std::string(number))));
    for (const char* number : {"4120", "4030", "4130", "4230", "4330", "4430"})
        EXPECT_THAT(lines_raised("MAC202", "O9151\nIF[#" + std::string(number) + "NE#20]GOTO9\nN9M99\n"),
                    IsEmpty());
}

TEST(SystemVariable, IsNoneOfTheNamedControlsBetweenTheLists) {
    const auto told = [](const std::string& number, const std::string& control) {
        cli::Overrides overrides;
        overrides.dialect = find_dialect("fanuc");
        overrides.control = control;
        return test::codes(test::lint_texts({{"O9152", "O9152\nG0X[#" + number + "-1.]\nM30\n"}}, overrides));
    };
    for (const char* number : {"5161", "3112"}) {
        EXPECT_THAT(told(number, "fanuc-30i"), ElementsAre("MAC202")) << number;
        EXPECT_THAT(told(number, "haas"), IsEmpty()) << number;
    }
    EXPECT_THAT(told("5061", "fanuc-30i"), IsEmpty());
}

TEST(PointInAWholeNumber, OfACallOrAnOffset) {
    const auto told = [](const std::string& block) {
        return lines_raised("MAC551", "O0374\nG0X0\n" + block + "\nM30\nO8374\nM99\n");
    };
    EXPECT_THAT(told("M98P8374L3.0"), ElementsAre(3));
    EXPECT_THAT(told("G65P8374L3."), ElementsAre(3));
    EXPECT_THAT(told("G41D5.G1X0F400."), ElementsAre(3));
    EXPECT_THAT(told("G43H2.Z50."), ElementsAre(3));
    EXPECT_THAT(told("M98P8374L3"), IsEmpty());
    EXPECT_THAT(told("G65P8374L3D5.H2."), IsEmpty()); // arguments
    EXPECT_THAT(told("G41D5G1X0F400."), IsEmpty());
}

TEST(MacroA, JumpsTestsAndRaisesAlarmsWithG65) {
    const auto told = [](const std::string& block) {
        return messages_raised("MAC124", "O0472\n#530=#530+1\n" + block + "\nG0X0\nN50G0X1.\nM30\n");
    };
    EXPECT_THAT(told("G65H81P50Q#530R25"), ElementsAre(HasSubstr("is a statement of macro A")));
    EXPECT_THAT(told("G65 H86 P50 Q#530 R#531"), ElementsAre(HasSubstr("'G65 H86 P50 Q#530 R#531'")));
    EXPECT_THAT(told("G65 H80 P50"), ElementsAre(HasSubstr("'G65 H80 P50'")));
    EXPECT_THAT(told("G65 H99 P5"), ElementsAre(HasSubstr("'G65 H99 P5'")));
    EXPECT_THAT(told("G65 P50 H81 Q#530 R25"), IsEmpty()); // P first, as in a call
    EXPECT_THAT(told("G65 H81. P50 Q#530 R25"), IsEmpty());
    EXPECT_THAT(told("G65 H81 P9050 Q#530 R25"), IsEmpty()); // the number of a program
    EXPECT_THAT(told("G65 H99 P5 R1."), IsEmpty());
    EXPECT_THAT(told("G65 H87 P50 Q#530 R25"), IsEmpty());
}

} // namespace
} // namespace maclint
