//! Which slides run a block, and of which it is not known whether they come to it.
#include "tests/support/analysed.hpp"

#include <map>
#include <string>

#include <gtest/gtest.h>

namespace maclint {
namespace {

constexpr Channels none = 0, first = 1U << 1U, second = 1U << 2U, both = first | second;

/// By the 1-based line of the block, for the last node of each line.
std::map<std::uint32_t, flow::NodeChannels> channels_in(const std::string& machining) {
    const auto workspace = test::analyse_text("dinplus", "MACHINING\n" + machining);
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::map<std::uint32_t, flow::NodeChannels> channels;
    for (flow::NodeId node = 0; node < analysis.graph().nodes.size(); ++node)
        channels.insert_or_assign(test::line_of(analysis, analysis.graph().nodes[node].part.begin),
                                  analysis.graph().channels_at(node));
    return channels;
}

TEST(NodeChannels, WhatOneSlideDecidesIsUnknownOfTheOther) {
    auto channels = channels_in("$1 N1 IF #g201>3\n" // line 2
                                "$1 N2 THEN\n"
                                "N3 G0 X#l1\n"
                                "$2 N4 G0 X#l1\n"
                                "$1 N5 G0 X#l1\n"
                                "$1 N6 ENDIF\n"
                                "N7 G0 X#l1\n"
                                "N8 M30\n");
    EXPECT_EQ(channels[2].running, first);
    EXPECT_EQ(channels[2].uncertain, none);
    EXPECT_EQ(channels[4].running, both);
    EXPECT_EQ(channels[4].uncertain, second);
    EXPECT_EQ(channels[5].running, second);
    EXPECT_EQ(channels[5].uncertain, second);
    EXPECT_EQ(channels[6].running, first);
    EXPECT_EQ(channels[6].uncertain, none);
    EXPECT_EQ(channels[8].running, both);
    EXPECT_EQ(channels[8].uncertain, none);
}

TEST(NodeChannels, WhatBothSlidesDecideIsKnownOfBoth) {
    auto channels = channels_in("N1 WHILE #g201>3\n$1 N2 G0 X#l1\n$2 N3 G0 X#l1\nN4 ENDWHILE\nN5 M30\n");
    for (const auto& [line, there] : channels) EXPECT_EQ(there.uncertain, none) << line;
}

TEST(NodeChannels, AnElseOfOneSlideDecidesForThatOneOnly) {
    auto channels = channels_in("N1 IF #g201>3\nN2 THEN\nN3 G0 X#l1\n$1 N4 ELSE\nN5 G0 X#l1\nN6 ENDIF\n"
                                "$2 N7 M30\nN8 M30\n");
    EXPECT_EQ(channels[4].uncertain, second);
    EXPECT_EQ(channels[6].uncertain, second);
    EXPECT_EQ(channels[9].uncertain, none);
}

TEST(NodeChannels, WithinALoopOfOneSlideTheOtherStaysUnknown) {
    auto channels = channels_in("$1 N1 WHILE #g201>3\n" // line 2
                                "N2 IF #g202>3\n"
                                "N3 THEN\n"
                                "N4 G0 X#l1\n"
                                "N5 ENDIF\n"
                                "N6 G0 X#l1\n"
                                "$1 N7 ENDWHILE\n"
                                "$2 N8 IF #g202>3\n"
                                "$2 N9 THEN\n"
                                "N10 G0 X#l1\n"
                                "$2 N11 ENDIF\n"
                                "N12 M30\n");
    EXPECT_EQ(channels[5].uncertain, second);
    EXPECT_EQ(channels[7].uncertain, second);
    EXPECT_EQ(channels[11].uncertain, first);
    EXPECT_EQ(channels[13].uncertain, none);
}

TEST(NodeChannels, AnIfThatIsNeverClosedDecidesNothing) {
    auto channels = channels_in("$1 N1 IF #g201>3\n$1 N2 THEN\n$2 N3 G0 X#l1\nN4 M30\n");
    EXPECT_EQ(channels[4].uncertain, none);
    EXPECT_EQ(channels[5].uncertain, none);
}

TEST(NodeChannels, AProgramOfOneSlideRunsInThatOne) {
    auto channels = channels_in("$1 N1 G0 X#l1\nN2 M30\n");
    EXPECT_EQ(channels[2].running, first);
    EXPECT_EQ(channels[3].running, first);
    EXPECT_EQ(channels_in("N1 G0 X#l1\nN2 M30\n")[2].running, 1U); // it names none
}

} // namespace
} // namespace maclint
