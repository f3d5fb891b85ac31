//! Calls that end in an alarm for what they are given, and those that are taken to come back.
#include "tests/support/analysed.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace maclint {
namespace {

/// Whether the block M08 of the main program is reached. Nothing else is on the control.
bool reaches_m08(const std::string& main_text, const std::string& called) {
    const auto workspace =
        test::analyse_files({{"O0001.nc", "O0001\n" + main_text}, {"O0002.nc", "O0002\n" + called}},
                            {.complete = true, .jobs = 1});
    const ProgramAnalysis& main = workspace->programs().front();
    const auto& nodes = main.graph().nodes;
    const auto m08 = std::ranges::find_if(nodes, [&](const flow::Node& node) {
        return test::text_of(main, node.part).find("M08") != std::string::npos;
    });
    return main.data().reached(static_cast<flow::NodeId>(m08 - nodes.begin()));
}

/// Whether the main program goes on after the call, which a test leads around: it may be made to stop.
bool comes_back(const std::string& call, const std::string& called) {
    return reaches_m08("IF[#501EQ1]GOTO8\n" + call + "\nM08\nN8M30\n", called);
}

/// The same of a call that every path comes by.
bool counts_as_coming_back(const std::string& call, const std::string& called) {
    return reaches_m08(call + "\nM08\nM30\n", called);
}

const std::string alarm = "#3000=1(WRONG)\n";

TEST(KnownCalls, EndInAnAlarmForANumberThatTheCalledProgramSees) {
    const std::string common = "IF[#149NE260]GOTO9\n" + alarm + "N9M99\n";
    EXPECT_FALSE(comes_back("#149=260\nG65P2", common));
    EXPECT_FALSE(comes_back("#149=260\nM98P2", common));
    EXPECT_TRUE(comes_back("#149=261\nG65P2", common));
    EXPECT_TRUE(comes_back("#149=#500\nG65P2", common));
    EXPECT_TRUE(comes_back("#148=260\nG65P2", common));
    const std::string local = "IF[#8NE260]GOTO9\n" + alarm + "N9M99\n";
    EXPECT_FALSE(comes_back("G65P2E260", local));
    EXPECT_TRUE(comes_back("G65P2E261", local));
    EXPECT_FALSE(comes_back("#8=260\nM98P2", local)); // a subprogram has the locals of its caller
    EXPECT_TRUE(comes_back("#8=260\nG65P2", local));  // a macro has its own
    EXPECT_TRUE(comes_back("#8=260\nG65P2E5", local));
}

TEST(KnownCalls, EndInAnAlarmForAVacantVariable) {
    const std::string called = "IF[#149NE#0]GOTO9\n" + alarm + "N9M99\n";
    EXPECT_FALSE(comes_back("#149=#0\nG65P2", called));
    EXPECT_TRUE(comes_back("#149=0\nG65P2", called));
    EXPECT_TRUE(comes_back("#149=#500\nG65P2", called));
    const std::string local = "IF[#8NE#0]GOTO9\n" + alarm + "N9M99\n";
    EXPECT_FALSE(comes_back("G65P2E#0", local));
    EXPECT_TRUE(comes_back("G65P2E1.", local));
    EXPECT_FALSE(comes_back("G65P2", local));
    // Where others pass E, a call that leaves it out is no reason to look: that it does is reported.
    EXPECT_TRUE(comes_back("G65P2", local + "O0003\nG65P2E1.\nM30\n"));
}

TEST(KnownCalls, ComeBackWhereverTheCalledProgramIsLeftWithoutAnAlarm) {
    EXPECT_FALSE(comes_back("#149=260\nG65P2", "IF[#149NE260]GOTO9\n" + alarm + "N9#2=1\n"));
    EXPECT_TRUE(comes_back("#149=5\nG65P2", "IF[#149NE260]GOTO9\n" + alarm + "N9#2=1\n")); // runs off its end
    EXPECT_TRUE(comes_back("#149=5\nG65P2", "IF[#149EQ260]THEN" + alarm + "M99\n"));
}

TEST(KnownCalls, ComeBackWhereTheCalledProgramReturnsToALabel) {
    // The caller goes on at N5, not behind the call: its last block is behind N5.
    const std::string called = "IF[#149EQ260]GOTO9\n" + alarm + "N9M99P5\n";
    EXPECT_TRUE(comes_back("#149=260\nG65P2\nM30\nN5", called));
    const std::string maybe = "IF[#500EQ1]GOTO9\nIF[#149EQ260]THEN" + alarm + "M99\nN9M99P5\n";
    EXPECT_TRUE(comes_back("#149=260\nG65P2\nM30\nN5", maybe));
    EXPECT_FALSE(comes_back("#149=260\nG65P2\nM30\nN5", alarm + "N9M99P5\n"));
}

TEST(KnownCalls, ThatEveryPathComesByAreNotMadeToStop) {
    const std::string called = "IF[#149NE260]GOTO9\n" + alarm + "N9M99\n";
    EXPECT_TRUE(counts_as_coming_back("#149=260\nG65P2", called));
    EXPECT_TRUE(counts_as_coming_back("G65P2", alarm));
    EXPECT_TRUE(counts_as_coming_back("M98P2", "#1=5.\n" + alarm + "M99\n"));
    EXPECT_FALSE(comes_back("G65P2", alarm));
    // Around the call leads nothing but an alarm, or another call of the kind.
    EXPECT_TRUE(reaches_m08("IF[#501EQ1]GOTO9\nG65P2\nM08\nM30\nN9" + alarm, alarm));
    EXPECT_TRUE(reaches_m08("IF[#501EQ1]GOTO5\nG1Y1.\nN5G65P2\nM08\nM30\n", alarm));
    EXPECT_FALSE(reaches_m08("IF[#501EQ1]GOTO5\nG65P2\nM08\nN5M30\n", alarm));
    // What does nothing but call a program that stops is there to stop as well.
    EXPECT_FALSE(comes_back("G65P2", "#149=7\nM98P3\nM99\nO0003\n" + alarm));
    EXPECT_TRUE(comes_back("G65P2", "G0X1.\nM98P3\nM99\nO0003\n" + alarm));
    // A program that ends without an alarm has ended.
    EXPECT_FALSE(counts_as_coming_back("G65P2", "M30\n"));
}

TEST(KnownCalls, WithWorkBehindThatOnlyTheyLeadToAreNotMadeToStop) {
    const auto reaches = [](const std::string& behind) {
        return reaches_m08("IF[#501EQ1]GOTO8\nG65P2\n" + behind + "M08\nN8M30\n", alarm);
    };
    EXPECT_TRUE(reaches("G0X1.\n"));
    EXPECT_TRUE(reaches("#103=1/0\n"));
    EXPECT_TRUE(reaches("M5\n#103=#1+1\n"));
    EXPECT_TRUE(reaches("G65P3\n"));
    EXPECT_FALSE(reaches(""));
    EXPECT_FALSE(reaches("#149=#0\n#150=1\n"));
    EXPECT_FALSE(reaches_m08("IF[#501EQ1]GOTO8\nG65P2\nM08\nN8X1.\nM30\n", alarm)); // others lead there, too
}

TEST(KnownCalls, OfProgramsThatWorkAreNotMadeToStop) {
    const std::string moves = "IF[#149NE260]GOTO9\n" + alarm + "N9G0X1.\nM99\n";
    EXPECT_TRUE(comes_back("#149=260\nG65P2", moves));
    // It parks the machine and stops, but for no test of its own.
    EXPECT_FALSE(comes_back("G65P2", "G0Z100.\n" + alarm));
    // The M99 in front of its alarm is missing.
    EXPECT_TRUE(comes_back("G65P2", "IF[#1EQ#0]GOTO9\nG0X#1\nN9" + alarm + "M99\n"));
    EXPECT_TRUE(comes_back("G65P2", "IF[#1EQ#0]GOTO9\nG0X#1\nN9M5\n" + alarm + "M99\n"));
    // Each test of a helper has an alarm of its own, none of which is run into.
    EXPECT_FALSE(comes_back("G65P2", "IF[#1EQ#0]GOTO9\nG0Z100.\n#3000=#1\nN9" + alarm));
}

TEST(KnownCalls, LeaveWhatTheirProgramHasSetWhereItAlwaysAlarms) {
    const auto workspace = test::analyse_files(
        {{"O0001.nc", "O0001\nM98P2\n#2=#101\nM30\n"}, {"O0002.nc", "O0002\n#101=5.\n" + alarm}},
        {.complete = true, .jobs = 1});
    EXPECT_EQ(test::last_read(workspace->programs().front()).constant(), 5.);
}

TEST(KnownCalls, AreFollowedThroughLoops) {
    const std::string ten = "#33=0\nWHILE[#33LT20]DO1\n#33=#33+1\nEND1\n";
    const std::string called = ten + "IF[#149EQ260]THEN" + alarm + "M99\n";
    EXPECT_FALSE(comes_back("#149=260\nG65P2", called));
    EXPECT_TRUE(comes_back("#149=5\nG65P2", called));
    // Only after many rounds does it come to its M99.
    const std::string late = "IF[#149EQ260]THEN" + alarm +
                             "#33=0\nN1#33=#33+1\nIF[#33LT#500]GOTO1\n"
                             "IF[#33LT30]GOTO1\nM99\n";
    EXPECT_TRUE(comes_back("#149=5\nG65P2", late));
    EXPECT_FALSE(comes_back("#149=260\nG65P2", late));
}

/// So many calls, each with a number of its own, before one for which the program ends in an alarm.
std::string after_other_calls(int count) {
    std::string calls;
    for (int i = 0; i < count; ++i) calls += "#149=" + std::to_string(1000 + i) + "\nG65P2\n";
    return calls + "#149=260\nG65P2";
}

TEST(KnownCalls, AreTakenToComeBackWhereFollowingThemWouldTakeTooLong) {
    const std::string called = "IF[#149NE260]GOTO9\n" + alarm + "N9M99\n";
    EXPECT_FALSE(comes_back(after_other_calls(40), called));
    EXPECT_TRUE(comes_back(after_other_calls(100), called));
    const auto longer = [&](int blocks) {
        std::string text;
        for (int i = 0; i < blocks; ++i) text += "#150=#500\n";
        return text + called;
    };
    EXPECT_FALSE(comes_back("#149=260\nG65P2", longer(500)));
    EXPECT_TRUE(comes_back("#149=260\nG65P2", longer(3000)));
}

} // namespace
} // namespace maclint
