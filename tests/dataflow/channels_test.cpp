//! Programs that run in several channels (slides) at the same time: what one slide sets, another does not
//! have.
#include "analyzer/dataflow/facts/point_state.hpp"
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/program/tables.hpp"
#include "rules/rule.hpp"
#include "tests/support/analysed.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// 1-based lines on which DIN619 (G41 or G42 still on at a tool change or at the end) speaks.
std::vector<std::uint32_t> still_compensated(const std::string& text) {
    const auto workspace = test::analyse_text("dinplus", text);
    std::vector<std::uint32_t> lines;
    for (const Finding& finding : run_rules(*workspace, {{find_rule("DIN619")}}, 1))
        lines.push_back(finding.source->position(finding.span.begin).line);
    return lines;
}

Channels channels_of_line(const std::string& text, std::uint32_t line) {
    const auto workspace = test::analyse_text("dinplus", text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    for (flow::NodeId node = 0; node < analysis.graph().nodes.size(); ++node)
        if (test::line_of(analysis, analysis.graph().nodes[node].part.begin) == line)
            return analysis.graph().channels_at(node).running;
    return 0;
}

constexpr Channels first = 1U << 1U, second = 1U << 2U, both = first | second;

TEST(Channels, ABlockRunsInTheSlidesThatItNames) {
    const std::string text = "MACHINING\n$1 N1 G0 X1\n$2 N2 G0 X2\n$1$2 N3 G0 X3\nN4 M30\nEND\n";
    EXPECT_EQ(channels_of_line(text, 2), first);
    EXPECT_EQ(channels_of_line(text, 3), second);
    EXPECT_EQ(channels_of_line(text, 4), both);
    EXPECT_EQ(channels_of_line(text, 5), both);
}

TEST(Channels, ABlockWithoutAMarkRunsInTheSlidesOfTheHead) {
    const std::string text = "PROGRAM HEAD\n#SLIDE $1\nMACHINING\nN1 G0 X1\n$2 N2 G0 X2\nN3 M30\nEND\n";
    EXPECT_EQ(channels_of_line(text, 4), first);
    EXPECT_EQ(channels_of_line(text, 5), second);
}

TEST(Channels, AnAssignmentHoldsUntilTheNextOne) {
    const std::string text = "PROGRAM HEAD\n#SLIDE $1$2\nASSIGNMENT $2\nN1 G0 X1\nMACHINING\nN2 G0 X2\n"
                             "$1 N3 G0 X2\nASSIGNMENT\nN4 G0 X3\nN5 M30\nEND\n";
    EXPECT_EQ(channels_of_line(text, 4), second);
    EXPECT_EQ(channels_of_line(text, 6), second);
    EXPECT_EQ(channels_of_line(text, 7), first);
    EXPECT_EQ(channels_of_line(text, 9), both);
}

TEST(Channels, ABlockThatCannotBeReadHasItsMarksToo) {
    EXPECT_EQ(channels_of_line("MACHINING\n$1 N1 G0 X(1\n$2 N2 G0 X2\nN3 M30\nEND\n", 2), first);
}

TEST(Channels, WhatOneSlideSwitchesOnIsNotOnInAnother) {
    EXPECT_THAT(still_compensated("MACHINING\n$1 N1 G42\n$2 N2 T2\n$1 N3 G40\nN4 M30\nEND\n"), IsEmpty());
}

TEST(Channels, WhatASlideSwitchesOnIsOnInItsOwnBlocksAndInThoseOfAll) {
    EXPECT_THAT(still_compensated("MACHINING\n$1 N1 G42\n$2 N2 G0 X1\n$1 N3 T2\n$1 N4 G40\nN5 M30\nEND\n"),
                ElementsAre(2));
    EXPECT_THAT(still_compensated("MACHINING\n$1 N1 G42\n$2 N2 G0 X1\nN3 T2\n$1 N4 G40\nN5 M30\nEND\n"),
                ElementsAre(2));
}

TEST(Channels, WhatOneSlideSwitchesOffStaysOnInAnother) {
    EXPECT_THAT(still_compensated("MACHINING\n$1 N1 G42\n$2 N2 G40\n$1 N3 T2\n$1 N4 G40\nN5 M30\nEND\n"),
                ElementsAre(2));
}

TEST(Channels, AProgramThatEndsForOneSlideGoesOnForTheOthers) {
    EXPECT_THAT(still_compensated("MACHINING\n$2 N1 G42\n$1 N2 M30\n$2 N3 T2\n$2 N4 G40\n$2 N5 M30\nEND\n"),
                ElementsAre(2));
}

TEST(Channels, AProgramThatEndsForOneSlideSaysNothingOfWhatAnotherHasOn) {
    EXPECT_THAT(still_compensated("MACHINING\n$2 N1 G42\n$1 N2 M30\n$2 N3 G40\n$2 N4 M30\nEND\n"), IsEmpty());
    EXPECT_THAT(still_compensated("MACHINING\n$2 N1 G42\n$2 N2 M30\n$1 N3 M30\nEND\n"), ElementsAre(2));
}

TEST(Channels, NothingIsSaidOfASlideInWhatAnotherDecides) {
    // No manual says whether slide 2 runs its blocks in an IF of slide 1.
    EXPECT_THAT(still_compensated("MACHINING\n$1 N1 IF #l1==1\nN2 THEN\n$2 N3 G42\nN4 ENDIF\n$2 N5 T2\n"
                                  "$2 N6 G40\nN7 M30\nEND\n"),
                IsEmpty());
    EXPECT_THAT(still_compensated("MACHINING\n$1 N1 IF #l1==1\nN2 THEN\n$1 N3 G42\nN4 ENDIF\n$1 N5 T2\n"
                                  "$1 N6 G40\n$2 N7 G0 X1\nN8 M30\nEND\n"),
                ElementsAre(4));
}

TEST(Channels, NothingIsSaidOfAToolChangeOfASlideInWhatAnotherDecides) {
    EXPECT_THAT(still_compensated("MACHINING\n$2 N1 G42\n$1 N2 IF #l1==1\nN3 THEN\n$2 N4 T2\nN5 ENDIF\n"
                                  "$2 N6 G40\nN7 M30\nEND\n"),
                IsEmpty());
}

TEST(Channels, AConditionOfOneSlideDoesNotKeepAnotherFromItsBlocks) {
    // #l1 is 1 in every slide, so slide 1 does not come into its IF. What slide 2 does there nobody knows.
    EXPECT_THAT(still_compensated("MACHINING\nN1 #l1=1\n$2 N2 G42\n$1 N3 IF #l1==2\nN4 THEN\n$2 N5 G40\n"
                                  "N6 ENDIF\n$2 N7 T2\n$2 N8 G40\nN9 M30\nEND\n"),
                IsEmpty());
}

/// What the compensation can be at the only tool change, in the slides that make it.
dataflow::ModalValue at_tool_change(const std::string& text) {
    const auto workspace = test::analyse_text("dinplus", text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto group = analysis.control().group_with(ModalRole::cutter_compensation);
    return analysis.data().modal(analysis.facts().all<dataflow::BeforeToolChange>()[0], group.value());
}

TEST(Channels, ASlideThatHasEndedHasNothingOnAnyMore) {
    // G42 of slide 1 and G40 of slide 2; only G40 when slide 1 has ended.
    EXPECT_EQ(at_tool_change("MACHINING\n$1 N1 G42\n$2 N2 G40\nN3 T2\nN4 M30\nEND\n").parts.size(), 2U);
    EXPECT_EQ(at_tool_change("MACHINING\n$1 N1 G42\n$2 N2 G40\n$1 N3 M30\nN4 T2\nN5 M30\nEND\n").parts.size(),
              1U);
}

TEST(Channels, ASlideThatHasEndedHasNoCodeOfAnyGroup) {
    const auto workspace = test::analyse_text(
        "dinplus", "MACHINING\n$1 N1 G1 G42 G95 F1\n$2 N2 G0 G40 G94 F2\n$1 N3 M30\nN4 T2\n"
                   "N5 M30\nEND\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    for (const ModalRole role :
         {ModalRole::motion, ModalRole::cutter_compensation, ModalRole::feed_mode, ModalRole::feed}) {
        const GroupId group = *analysis.control().group_with(role);
        EXPECT_EQ(
            analysis.data().modal(analysis.facts().all<dataflow::BeforeToolChange>()[0], group).parts.size(),
            1U)
            << analysis.control().groups[group].name;
    }
}

TEST(Channels, WhatASlideHasOnIsUnknownWhereItMayNotCome) {
    const std::string before = "MACHINING\n$2 N1 G42\n$1 N2 IF #l1==1\nN3 THEN\n";
    EXPECT_TRUE(at_tool_change(before + "$2 N4 T2\nN5 ENDIF\nN6 M30\nEND\n").unknown);
    EXPECT_FALSE(at_tool_change(before + "$1 N4 T2\nN5 ENDIF\nN6 M30\nEND\n").unknown);
}

TEST(Channels, NothingIsKnownOfAVariableThatOnlySomeSlidesStoreIn) {
    const auto workspace = test::analyse_text(
        "dinplus", "MACHINING\n$1 N1 #l1=5\n$2 N2 #l2=#l1\nN3 #l3=7\n$2 N4 #l4=#l3\nN5 M30\nEND\n");
    const auto& reads = workspace->programs().front().facts().all<dataflow::Read>();
    ASSERT_EQ(reads.size(), 2U);
    EXPECT_FALSE(reads[0].value.constant());
    EXPECT_EQ(reads[1].value.constant(), 7);
}

TEST(Channels, WhatACalledProgramSwitchesOnForOneSlideIsOnInThatOne) {
    const std::string sub = "SUBPROGRAM \"on\"\n$1 N100 G42\n$2 N101 G0 X1\nRETURN\nEND\n";
    const std::string main = "MACHINING\n$1 N1 G40\n$2 N2 G40\nN3 L\"on\"\n";
    const auto in_first = at_tool_change(main + "$1 N4 T2\nN5 M30\n" + sub);
    const auto in_second = at_tool_change(main + "$2 N4 T2\nN5 M30\n" + sub);
    EXPECT_FALSE(in_first.unknown);
    EXPECT_FALSE(in_second.unknown);
    EXPECT_EQ(in_first.parts.size(), 1U);
    EXPECT_EQ(in_second.parts.size(), 1U);
    EXPECT_NE(in_first.parts, in_second.parts);
    // A caller that names no slide may be the one.
    EXPECT_TRUE(at_tool_change("MACHINING\nN1 G40\nN2 L\"on\"\nN3 T2\nN4 M30\n" + sub).unknown);
}

TEST(Channels, ACallOfOneSlideChangesNothingForAnother) {
    const std::string sub = "SUBPROGRAM \"on\"\nN100 G42\nRETURN\n";
    EXPECT_THAT(still_compensated("MACHINING\n$1 N1 L\"on\"\n$2 N2 T2\n$1 N3 G40\nN4 M30\n" + sub + "END\n"),
                IsEmpty());
}

} // namespace
} // namespace maclint
