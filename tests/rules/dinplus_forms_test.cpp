//! DIN PLUS: forms of other languages, slips of typing and words that exclude each other, beyond the
//! examples.
#include "tests/rules/din_findings.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>

namespace maclint {
namespace {

using test::din_findings;
using test::din_lines;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A block of MACHINING, its own line being the second.
std::vector<std::uint32_t> lines_in_machining(std::string_view code, const std::string& block) {
    return din_lines(code, "MACHINING\n" + block + "\nM30\nEND\n");
}

// ---- words that exclude each other

TEST(DinplusContradictions, AreCodesOfOneKindWhateverTheWordsBetweenThem) {
    EXPECT_THAT(lines_in_machining("MAC514", "N5 M3 M4"), ElementsAre(2));
    EXPECT_THAT(lines_in_machining("MAC514", "N5 G1 X60 G2 Z-5 R5"), ElementsAre(2));
    EXPECT_THAT(lines_in_machining("MAC514", "N5 G95 F#l1 M5 M3"), ElementsAre(2));
    EXPECT_THAT(lines_in_machining("MAC514", "N5 M103 M105"), ElementsAre(2));
}

TEST(DinplusContradictions, AreNoneOfTwoSpindlesNorOfFeedAndSpeed) {
    EXPECT_THAT(lines_in_machining("MAC514", "N5 M3 M104"), IsEmpty());
    EXPECT_THAT(lines_in_machining("MAC514", "N5 G97 S1061 G95 F0.25 M4"), IsEmpty());
    EXPECT_THAT(lines_in_machining("MAC514", "N5 M105 M109 M8"), IsEmpty());
    EXPECT_THAT(lines_in_machining("MAC514", "N5 M3 M3"), IsEmpty());
}

TEST(DinplusContradictions, AreFoundAmongManyPlainBlocks) {
    std::string text = "MACHINING\n";
    for (int i = 0; i < 50; ++i) text += "N5 G1 X60 Z-5 M8\nN6 M9\nN7 M3\nN8 M4\n";
    EXPECT_THAT(din_lines("MAC514", text + "N9 M8 M9\nM30\nEND\n"), ElementsAre(202));
}

TEST(DinplusDuplicateAddress, TakesAnIncrementForTheSameAddress) {
    EXPECT_THAT(lines_in_machining("MAC559", "N5 G1 X60 Z2 Xi5"), ElementsAre(2));
    EXPECT_THAT(lines_in_machining("MAC559", "N5 G1 X60 XK2 Z5"), IsEmpty());
    EXPECT_THAT(lines_in_machining("MAC559", "N5 L\"A\" LA1 LB2 LA3"), ElementsAre(2));
}

// ---- forms

TEST(DinplusLetterO, IsTheFigureInCodesAndTools) {
    EXPECT_THAT(lines_in_machining("MAC106", "N5 GO X5"), ElementsAre(2));
    EXPECT_THAT(lines_in_machining("MAC106", "N5 TO1"), ElementsAre(2));
    EXPECT_THAT(lines_in_machining("MAC106", "N5 G14 QO"), ElementsAre(2));
    EXPECT_THAT(lines_in_machining("MAC106", "N5 G14 QO5"), IsEmpty()); // an address of two letters
}

TEST(DinplusForeignRemark, IsTakenInAnyOfItsForms) {
    EXPECT_THAT(lines_in_machining("DIN013", "N5 G0 X5 (ROUGH)"), ElementsAre(2));
    EXPECT_THAT(lines_in_machining("DIN013", "N5 G0 X5 ; rough"), ElementsAre(2));
    EXPECT_THAT(lines_in_machining("DIN013", "// rough"), ElementsAre(2));
    EXPECT_THAT(lines_in_machining("DIN013", "N5 G0 X(#l1) [; rough // (none)]"), IsEmpty());
}

TEST(DinplusForeignRemark, IsShownAsTheLanguageHasIt) {
    const auto found = din_findings("DIN013", "MACHINING\nN5 G0 X5 // rough (80)\nM30\nEND\n");
    ASSERT_EQ(found.size(), 1U);
    EXPECT_THAT(found.front().message(), HasSubstr("[rough (80]"));
}

TEST(DinplusSmallLetters, AreToldOnceAFile) {
    EXPECT_THAT(din_lines("MAC104", "MACHINING\nG0 X5\nif #l1==1\nthen\ng0 x3\nendif\nEND\n"),
                ElementsAre(3));
    EXPECT_THAT(lines_in_machining("MAC104", "N5 G0 Xi5 Z#l1"), IsEmpty());
}

TEST(DinplusComparison, IsNoValueAnywhereButInAConditionAndATest) {
    EXPECT_THAT(lines_in_machining("MAC709", "N5 #l1=#l2==5"), ElementsAre(2));
    EXPECT_THAT(lines_in_machining("MAC709", "N5 #l1=(#l2<5)*3"), ElementsAre(2));
    EXPECT_THAT(lines_in_machining("MAC709", "N5 G0 X(#l2>5)"), ElementsAre(2));
    EXPECT_THAT(lines_in_machining("MAC709", "N5 WHILE (#l2<5) AND (#l3>2)\nENDWHILE"), IsEmpty());
    EXPECT_THAT(lines_in_machining("MAC709", "N5 IF (#l2<5)\nTHEN\nENDIF"), IsEmpty());
}

TEST(DinplusEmptyWord, IsAnAddressAloneAndNoUnknownCoordinate) {
    EXPECT_THAT(lines_in_machining("MAC109", "N5 G0 X Z5"), ElementsAre(2));
    EXPECT_THAT(lines_in_machining("MAC109", "N5 G0 Xi"), ElementsAre(2));
    EXPECT_THAT(lines_in_machining("MAC109", "N5 G0 X? Z?>"), IsEmpty());
    EXPECT_THAT(lines_in_machining("MAC109", "N5 G14 QO"), IsEmpty()); // MAC106's
}

// ---- flow

TEST(CaseWithoutBreak, IsNoneWhereTwoCasesShareABranch) {
    const std::string head = "MACHINING\nSWITCH #g1\nCASE 1\n";
    const std::string tail = "CASE 2\nG0 X5\nBREAK\nENDSWITCH\nM30\nEND\n";
    EXPECT_THAT(din_lines("DIN410", head + tail), IsEmpty());
    EXPECT_THAT(din_lines("DIN410", head + "[the same]\n" + tail), IsEmpty());
    EXPECT_THAT(din_lines("DIN410", head + "G0 X3\n" + tail), ElementsAre(3));
    EXPECT_THAT(din_lines("DIN410", head + "#l1=3\n" + tail), ElementsAre(3));
}

TEST(DuplicateCase, ComparesTheValuesOfOneSelection) {
    const std::string both =
        "MACHINING\nSWITCH #g1\nCASE 1\nG0 X5\nBREAK\nCASE 1.0\nG0 X6\nBREAK\nENDSWITCH\n";
    EXPECT_THAT(din_lines("DIN411", both + "M30\nEND\n"), ElementsAre(6));
    const std::string one =
        "SWITCH #g1\nCASE 1\nG0 X5\nBREAK\nCASE -1\nG0 X6\nBREAK\nCASE #l1\nBREAK\nENDSWITCH\n";
    EXPECT_THAT(din_lines("DIN411", "MACHINING\n" + one + one + "M30\nEND\n"), IsEmpty());
}

TEST(UnreachableCode, SeesBlocksBehindTheReturnOfASubprogram) {
    const std::string main = "MACHINING\nL\"S\" LA1\nM30\n";
    EXPECT_THAT(din_lines("MAC460", main + "SUBPROGRAM \"S\"\nN5 RETURN\nN6 G4 F2\nRETURN\nEND\n"),
                ElementsAre(6));
    EXPECT_THAT(din_lines("MAC460",
                          main + "SUBPROGRAM \"S\"\nIF #g1==1\nTHEN\nRETURN\nENDIF\nN6 G4 F2\nRETURN\nEND\n"),
                IsEmpty());
}

TEST(ConstantCondition, SeesAnIfThatIsAlwaysTrue) {
    const std::string tail = "\nTHEN\nG0 X5\nENDIF\nM30\nEND\n";
    EXPECT_THAT(din_lines("MAC718", "MACHINING\n#l1=#c1\nIF #l1<>5 OR #l1<>3" + tail), ElementsAre(3));
    EXPECT_THAT(din_lines("MAC718", "MACHINING\n#l1=#c1\nIF #l1<>5 AND #l1<>3" + tail), IsEmpty());
    EXPECT_THAT(din_lines("MAC718", "MACHINING\n#l1=#c1\nIF #l1<>5 OR #l2<>3" + tail), IsEmpty());
}

} // namespace
} // namespace maclint
