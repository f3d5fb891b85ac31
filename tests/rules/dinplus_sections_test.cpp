//! The sections of DIN PLUS programs: their order and number, the words of their descriptions, block numbers.
#include "tests/support/linted.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> found(const std::string& text) {
    cli::Overrides overrides;
    overrides.dialect = find_dialect("dinplus");
    overrides.select = {"DIN004", "DIN105", "DIN106", "DIN109"};
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] : lint_texts({{"part.nc", text}}, std::move(overrides)).findings)
        all.push_back(std::string(finding.rule->code) + " " +
                      std::to_string(finding.source->position(finding.span.begin).line));
    return all;
}
const std::string rest = "MACHINING\nN9 M30\nEND\n";

TEST(SectionWords, StandBesideTheNameOrBelowIt) {
    EXPECT_THAT(found("FACE_C Z0 X50\n" + rest), ElementsAre("DIN109 1"));
    EXPECT_THAT(found("N1 FACE_C Z0 X50\n" + rest), ElementsAre("DIN109 1")) << "behind a block number";
    EXPECT_THAT(found("CHUCKING EQUIPMENT 1\nH0 D0 Q6 V0\n" + rest), ElementsAre("DIN109 2"));
    EXPECT_THAT(found("SPANNMITTEL 1\nH0 D0 Q4 V3\n" + rest), ElementsAre("DIN109 2"));
    EXPECT_THAT(found("TURRET 1\nT1 ID\"ROUGH 80\"\nT2\n" + rest), ElementsAre("DIN109 3"));
}

TEST(SectionWords, ThatTheManualHasAreTaken) {
    EXPECT_THAT(
        found("CONTOUR Q1 X0 Z600 V2 [left]\nCHUCKING EQUIPMENT 1\nH0 D0 Z150 B20 O-100 X35 K12 Q4\n"
              "TURRET 1\nT1 ID\"A\" AT\"B\" AS1\nLATERAL_Y X118 C0 B130 I59 K0 H1\nFACE_Y Z0 C0 X60\n" +
              rest),
        IsEmpty());
    EXPECT_THAT(found("LATERAL_Y X#l1 C0 H2\n" + rest), IsEmpty()) << "a heading that is calculated";
    EXPECT_THAT(found("FACE_C\nN1 G308 ID\"A\"\nN2 G309\n" + rest), IsEmpty());
}

TEST(SectionOrder, IsThatOfTheFirstOfEachKind) {
    EXPECT_THAT(found("FACE_C Z0\nFINISHED\n" + rest), ElementsAre("DIN105 1"));
    EXPECT_THAT(found("CONTOUR Q1\nFINISHED\nFACE_C Z0\nCONTOUR Q2\nFINISHED\nFACE_C Z0\n" + rest),
                IsEmpty());
    EXPECT_THAT(found("MACHINING\nN1 M30\nFINISHED\nEND\n"), ElementsAre("DIN105 1"));
}

TEST(SectionCount, IsOfTheProgramOrOfAContourGroup) {
    EXPECT_THAT(found("FINISHED\nFINISHED\nFINISHED\n" + rest), ElementsAre("DIN106 2"));
    EXPECT_THAT(found("CONTOUR Q1\nFINISHED\nCONTOUR Q2\nFINISHED\n" + rest), IsEmpty());
    EXPECT_THAT(found("CONTOUR Q1\nCONTOUR Q2\nCONTOUR Q3\nCONTOUR Q4\n" + rest), IsEmpty());
    EXPECT_THAT(found("CONTOUR Q1\nCONTOUR Q2\nCONTOUR Q3\nCONTOUR Q4\nCONTOUR Q4\n" + rest),
                ElementsAre("DIN106 5"));
    EXPECT_THAT(found("AUXIL_CONTOUR ID\"A\"\nAUXIL_CONTOUR ID\"B\"\n" + rest), IsEmpty());
}

TEST(BlockNumbers, HaveFiveDigitsAtMost) {
    EXPECT_THAT(found("MACHINING\nN99999 G0 X1\nN100000 G0 X2\nN100001 G0 X3\nEND\n"),
                ElementsAre("DIN004 3"));
    EXPECT_THAT(found("MACHINING\nN1 G0 X1\nN123456 #l1=5\nEND\n"), ElementsAre("DIN004 3"));
}

} // namespace
} // namespace maclint::test
