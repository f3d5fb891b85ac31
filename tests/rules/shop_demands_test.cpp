//! What a shop demands of programs: limits, and blocks that must stand there.
#include "analyzer/dialect/dialect.hpp"
#include "cli/config/shop_demands.hpp"
#include "tests/support/linted.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// "4 S9000 9000": line, first two arguments, of a control with these keys.
std::vector<std::string> told(const std::string& code, const std::string& keys, const std::string& text) {
    cli::Overrides overrides;
    overrides.dialect = find_dialect("fanuc");
    overrides.select = {code};
    overrides.machine = cli::facts_of_example(keys);
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] : lint_texts({{"O1.nc", text}}, std::move(overrides)).findings)
        all.push_back(std::to_string(finding.source->position(finding.span.begin).line) + " " +
                      finding.arguments.front() + " " + std::string(finding.message_id));
    return all;
}

const std::string begins = "O1\nG90 G17 G21 G54\nT1 M6\n"; // three lines

std::vector<std::string> beyond(const std::string& limits, const std::string& blocks) {
    return told("MAC587", "\"limits\": {" + limits + "}", begins + blocks + "M30\n");
}

TEST(ShopLimits, HoldSpeedsThatTheSpindleTurnsAt) {
    const std::string limits = "\"speed\": [50, 8000]";
    EXPECT_THAT(beyond(limits, "S9000 M3\nG43 H1 Z5.\n"), ElementsAre("4 the speed above"));
    EXPECT_THAT(beyond(limits, "S20 M3\nG43 H1 Z5.\n"), ElementsAre("4 the speed below"));
    EXPECT_THAT(beyond(limits, "S8000 M3\nG43 H1 Z5.\nS0\n"), IsEmpty());
    EXPECT_THAT(beyond(limits, "#1=9000\nS#1 M3\nG43 H1 Z5.\n"), IsEmpty());
    EXPECT_THAT(beyond("\"speed\": 8000", "S20 M3\nG43 H1 Z5.\n"), IsEmpty());
    const std::string lathe = "O1\nG28 U0 W0\nT0101\n";
    EXPECT_THAT(told("MAC587", "\"limits\": {\"speed\": [50, 3000], \"tool\": 8}",
                     lathe + "G50 S4000\nG96 S20 M3\nG0 X50. Z2.\nG97 S3500\nT0903\nM30\n"),
                ElementsAre("7 the speed above", "8 the tool above"))
        << "a surface speed, and a clamp, are no revolutions";
}

TEST(ShopLimits, HoldFeedsOfTheirMode) {
    const std::string limits = "\"feed-per-minute\": [20, 2000], \"feed-per-revolution\": 1";
    const std::string before = "S900 M3\nG43 H1 Z5.\n";
    EXPECT_THAT(beyond(limits, before + "G1 Z-5. F3000.\n"), ElementsAre("6 the feed per minute above"));
    EXPECT_THAT(beyond(limits, before + "G95 G1 Z-5. F3.\n"), ElementsAre("6 the feed per revolution above"));
    EXPECT_THAT(beyond(limits, before + "G95 G1 Z-5. F0.2\n"), IsEmpty());
    EXPECT_THAT(beyond(limits, before + "G93 G1 Z-5. F3000.\n"), IsEmpty());
    EXPECT_THAT(beyond(limits, before + "G33 Z-5. F3000.\n"), IsEmpty()) << "a lead";
    EXPECT_THAT(beyond(limits, before + "G20\nG1 Z-1. F100.\n"), ElementsAre("7 the feed per minute above"));
}

TEST(ShopLimits, HoldPositionsOnce) {
    const std::string limits = "\"X\": [0, 600], \"Z\": [-50, 300]";
    EXPECT_THAT(beyond(limits, "G43 H1 Z5.\nG0 X610.\nX620.\n"), ElementsAre("5 the position along X above"));
    EXPECT_THAT(beyond(limits, "G43 H1 Z5.\nG0 X590.\nG91 X20.\n"),
                ElementsAre("6 the position along X above"));
    EXPECT_THAT(beyond(limits, "G43 H1 Z5.\nG81 X10. Y10. Z-60. R2. F100.\nG80\n"),
                ElementsAre("5 the position along Z below"));
    EXPECT_THAT(beyond(limits, "G43 H1 Z5.\nG68 X0 Y0 R30.\nG0 X610.\nG69\n"), IsEmpty());
    EXPECT_THAT(beyond(limits, "G43 H1 Z5.\nG53 X-610.\n"), IsEmpty());
    EXPECT_THAT(beyond(limits, "G43 H1 Z5.\nG0 X610\n"), IsEmpty()) << "thousandths, where no point is";
    EXPECT_THAT(beyond(limits, "G43 H1 Z5.\nG20\nG0 X25.\n"), ElementsAre("6 the position along X above"));
}

std::vector<std::string> missing(const std::string& demands, const std::string& text) {
    return told("MAC562", demands, text);
}

const std::string works = "S900 M3\nG43 H1 Z5. M8\nG1 Z-5. F200.\nG0 Z50.\n"; // four lines

TEST(DemandedBlocks, StandBeforeTheFirstMove) {
    const std::string start = "\"at-start\": [\"G17 G40 G80\"]";
    EXPECT_THAT(missing(start, begins + works + "M30\n"), ElementsAre("5 G17 G40 G80 start"));
    EXPECT_THAT(missing(start, "O1\nG80 G17\nG28 Z0\nG40\n" + works + "M30\n"), IsEmpty());
    EXPECT_THAT(missing(start, "O1\nG17 G40\nT1 M6\n" + works + "G80\nM30\n"),
                ElementsAre("5 G17 G40 G80 start"));
    EXPECT_THAT(missing(start, begins + works + "M99\n"), IsEmpty()) << "no main program";
    EXPECT_THAT(missing(start, "O1\nM98 P9000\nT1 M6\n" + works + "M30\n"), IsEmpty()) << "nobody has it";
    EXPECT_THAT(missing(start, "O1\nM98 P2\nT1 M6\n" + works + "M30\nO2\nG40 G17 G80\nM99\n"), IsEmpty());
    EXPECT_THAT(missing(start, "O1\n/ G17 G40 G80\nT1 M6\n" + works + "M30\n"), IsEmpty()) << "may stand";
}

TEST(DemandedBlocks, StandBeforeTheChangeOfAToolThatHasWorked) {
    const std::string change = R"("before-tool-change": ["M5", "M9", "G40", "G91 G28 Z0"])";
    const std::string next = "T2 M6\nM30\n";
    EXPECT_THAT(missing(change, begins + works + next),
                UnorderedElementsAre("8 M5 change_under", "8 M9 change_under", "8 G91 G28 Z0 change"));
    EXPECT_THAT(missing(change, begins + works + "M9\nM5\nG91 G28 Z0\n" + next), IsEmpty());
    EXPECT_THAT(missing(change, begins + works + "M09 M05\nG91\nG0 G28 Z0.\n" + next), IsEmpty());
    EXPECT_THAT(missing(change, begins + works + "M9\nM5\nG28 Z0\n" + next),
                ElementsAre("11 G91 G28 Z0 change"))
        << "under G90";
    EXPECT_THAT(missing(change, begins + "G91 G28 Z0\nG90\n" + works + "M9\nM5\n" + next),
                ElementsAre("12 G91 G28 Z0 change"))
        << "before the cut";
    EXPECT_THAT(missing(change, begins + works + "M9\nM19\nG91 G28 Z0\n" + next), IsEmpty())
        << "it stands under M19, too";
    EXPECT_THAT(missing(change, begins + works + "M98 P9000\n" + next), IsEmpty());
    EXPECT_THAT(missing(change, begins + "T2 M6\nM30\n"), IsEmpty()) << "it has not worked";
}

TEST(DemandedBlocks, StandBehindTheLastCut) {
    const std::string end = R"("at-end": ["M9", "G28 Z0", "G90"])";
    EXPECT_THAT(missing(end, begins + works + "M30\n"),
                UnorderedElementsAre("8 M9 end_under", "8 G28 Z0 end"));
    EXPECT_THAT(missing(end, begins + works + "G28 Z0 M9\nM30\n"), IsEmpty());
    EXPECT_THAT(missing(end, begins + works + "G28 Z0\nM9 M30\n"), IsEmpty());
    EXPECT_THAT(missing(end, begins + works + "G91 G28 Z0 M9\nM30\n"), ElementsAre("9 G90 end_under"));
    EXPECT_THAT(missing(end, begins + works + "IF[#1EQ1]GOTO9\nM9\nG28 Z0\nN9 M30\n"), IsEmpty())
        << "on one of two paths";
    EXPECT_THAT(missing("\"at-end\": [\"G49\", \"T\"]", begins + works + "M30\n"),
                UnorderedElementsAre("8 G49 end_under", "8 T end"));
}

TEST(DemandedBlocks, AreShown) {
    ShopDemands demands;
    demands.limits.speed = {50, 8000};
    demands.limits.tool.greatest = 24;
    demands.blocks = {{DemandedBlock::Place::end, "M9", {}}};
    EXPECT_THAT(cli::words_of(demands), ElementsAre("speed 50 to 8000", "tool up to 24", "at-end M9"));
}

} // namespace
} // namespace maclint::test
