//! Profiles between P and Q of turning cycles, and the chamfers of their moves: what each message is told
//! for.
#include "tests/support/linted.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Message and line of what a rule finds in the program: "order 3".
std::vector<std::string> told(const std::string& rule, const std::string& text,
                              const std::string& control = "fanuc-16i-lathe") {
    cli::Overrides overrides;
    overrides.control = control;
    overrides.select = {rule};
    const auto result = lint_texts({{"O1.nc", text}}, std::move(overrides));
    std::vector<std::string> all;
    for (const auto& evaluated : result.findings) {
        const Finding& finding = evaluated.finding;
        all.push_back(std::string(finding.message_id) + " " +
                      std::to_string(finding.source->position(finding.span.begin).line));
    }
    return all;
}

const std::string start = "O1\nG99 G21 G40\nG0 X52. Z2.\n";

TEST(Profiles, AreSilentWhereTheyAreWhole) {
    EXPECT_THAT(told("MAC338", start + "G71 P10 Q20 U0.4 W0.1\nN10 G0 X20.\nG1 Z-5.\nN20 X52.\nM30\n"),
                IsEmpty());
}

TEST(Profiles, EndBehindTheirBeginning) {
    EXPECT_THAT(told("MAC338", start + "G71 P20 Q10 U0.4 W0.1\nN10 G0 X20.\nG1 Z-5.\nN20 G1 X52.\nM30\n"),
                ElementsAre("order 4"));
}

TEST(Profiles, HaveBothBlocksOnce) {
    EXPECT_THAT(told("MAC338", start + "G71 P10 Q30 U0.4 W0.1\nN10 G0 X20.\nN20 X52.\nM30\n"),
                ElementsAre("missing 4"));
    EXPECT_THAT(told("MAC338", start + "G71 P10 Q20 U0.4 W0.1\nN10 G0 X20.\nN20 X52.\nN10 X3.\nM30\n"),
                ElementsAre("twice 4"));
}

TEST(Profiles, BeginWithAMoveOfTheirOwnAndHoldNoCyclesToolsOrCalls) {
    const std::string cycle = start + "G71 P10 Q20 U0.4 W0.1\n";
    EXPECT_THAT(told("MAC338", cycle + "N10 X20.\nN20 G1 X52.\nM30\n"), ElementsAre("first 4"));
    EXPECT_THAT(told("MAC338", cycle + "N10 G0 X20.\nG32 Z-5. F1.\nN20 G1 X52.\nM30\n"),
                ElementsAre("inside 6"));
    EXPECT_THAT(told("MAC338", cycle + "N10 G0 X20.\nT0202\nN20 G1 X52.\nG32 Z-5. F1.\nM30\n"),
                ElementsAre("inside 6"))
        << "what stands behind it is free";
}

TEST(Corners, WantAStraightMoveBehindThem) {
    const std::string cut = start + "G1 Z-5. F0.2\n";
    EXPECT_THAT(told("MAC529", cut + "X40. ,C2.\nZ-20.\nM30\n"), IsEmpty());
    EXPECT_THAT(told("MAC529", cut + "X40. ,R2.\n,A90.\nM30\n"), IsEmpty()) << "a line by its angle";
    EXPECT_THAT(told("MAC529", cut + "X40. ,C2.\nM9\nM30\n"), ElementsAre("no_move 5"));
    EXPECT_THAT(told("MAC529", cut + "X40. ,C2.\nG0 X90.\nM30\n"), ElementsAre("rapid 5"));
}

TEST(Corners, WithoutACommaStandInAStraightCutOfOneAxis) {
    const std::string cut = start + "G1 Z-5. F0.2\n";
    EXPECT_THAT(told("MAC529", cut + "X40. R2.\nZ-20.\nM30\n"), IsEmpty());
    EXPECT_THAT(told("MAC529", cut + "X40. Z-9. R2.\nZ-20.\nM30\n"), ElementsAre("taper 5"));
    EXPECT_THAT(told("MAC529", cut + "G2 X40. Z-9. R4.\nG1 Z-20.\nM30\n"), IsEmpty()) << "an arc";
    EXPECT_THAT(told("MAC529", cut + "X40. Z-9. R2.\nZ-20.\nM30\n", "fanuc-16i"), IsEmpty()) << "of a mill";
}

} // namespace
} // namespace maclint::test
