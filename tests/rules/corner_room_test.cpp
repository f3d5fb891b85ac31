//! Chamfers and radii that are larger than the moves that they stand between, and angles without an end.
#include "tests/support/linted.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// "4 055 short", one a finding.
std::vector<std::string> corners(const std::string& blocks, std::string_view control = "fanuc-30i") {
    cli::Overrides overrides;
    overrides.control = std::string(control);
    overrides.select = {"MAC529"};
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] :
         lint_texts({{"O1.nc", "O1(PLATE)\nG17 G90 G54 G0 X0 Y0\n" + blocks + "G0 Z50.\nM30\n"}},
                    std::move(overrides))
             .findings)
        all.push_back(std::to_string(finding.source->position(finding.span.begin).line) + " " +
                      std::string(finding.alarm) + " " + std::string(finding.message_id));
    return all;
}

TEST(CornerRoom, IsMissingWhereAMoveIsShorterThanTheCorner) {
    EXPECT_THAT(corners("G91 G1 X1. ,C2. F100.\nY20.\n"), ElementsAre("3 055 short"));
    EXPECT_THAT(corners("G91 G1 X10. ,R2. F100.\nY-1.\n"), ElementsAre("3 055 short"));
    EXPECT_THAT(corners("G1 X1. ,C2. F100.\nY20.\n"), ElementsAre("3 055 short")) << "from X0";
    EXPECT_THAT(corners("G1 X10. Y5. F100.\nX30. ,C2.\nY6.\n"), ElementsAre("4 055 short")) << "from Y5";
    EXPECT_THAT(corners("G91 G1 X1. ,C2. F100.\nY20.\n", "fanuc-16i"), ElementsAre("3 055 short"));
}

TEST(CornerRoom, IsThereOrNotKnown) {
    EXPECT_THAT(corners("G91 G1 X10. ,C2. F100.\nY20.\n"), IsEmpty());
    EXPECT_THAT(corners("G91 G1 X2. ,C2. F100.\nY20.\n"), IsEmpty());
    EXPECT_THAT(corners("G1 X#1 ,C2. F100.\nY#2\n"), IsEmpty());
    EXPECT_THAT(corners("G91 G1 X1. Y9. ,R2. F100.\nY20.\n"), IsEmpty()) << "a slanting move";
    EXPECT_THAT(corners("G92 X0 Y0\nG1 X1. ,C2. F100.\nY20.\n"), ElementsAre("4 055 short"));
    EXPECT_THAT(corners("G52 X50.\nG1 X1. ,C2. F100.\nY20.\n"), IsEmpty()) << "from elsewhere";
    EXPECT_THAT(corners("M98 P2\nG1 X1. ,C2. F100.\nY20.\n"), IsEmpty());
    EXPECT_THAT(corners("N5 X1.\nN6 G1 X2. ,C2. F100.\nY20.\n"), ElementsAre("4 055 short"));
}

TEST(CornerRoom, IsMissingOnALatheByItsIncrements) {
    EXPECT_THAT(corners("G1 W-1. ,R2. F0.1\nU20.\n", "fanuc-30i-lathe"), ElementsAre("3 055 short"));
    EXPECT_THAT(corners("G1 W-10. ,R2. F0.1\nU20.\n", "fanuc-30i-lathe"), IsEmpty());
}

TEST(AngleOfALine, HasAnEndInTheNextBlock) {
    EXPECT_THAT(corners("G1 ,A30. F100.\nM8\n"), ElementsAre("3  no_end"));
    EXPECT_THAT(corners("G1 ,A30. F100.\nX20. Y10. ,A60.\n"), IsEmpty());
    EXPECT_THAT(corners("G1 X20. ,A30. F100.\nM8\n"), IsEmpty());
}

} // namespace
} // namespace maclint::test
