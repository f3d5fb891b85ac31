//! What is known of the machine in front of a block.
#include "analyzer/machine/states.hpp"
#include "analyzer/program/tables.hpp"
#include "tests/support/analysed.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::machine {
namespace {

/// Behind the first block that holds `text`, in the first program.
std::optional<State> behind(const std::string& program, std::string_view text) {
    const auto workspace = test::analyse_fanuc(program);
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::optional<State> found;
    analysis.machine().for_each_step([&](const Step& step) {
        const bool wanted = analysis.program().slice(step.block.span).find(text) != std::string_view::npos;
        if (wanted && !found) found = step.after;
    });
    return found;
}

/// "3000", "caller's", "?".
std::string spelled(const Known& known) {
    if (known.is_callers()) return "caller's";
    if (!known.is_known()) return "?";
    return std::to_string(static_cast<int>(known.value));
}

std::string tool_behind(const std::string& program, std::string_view text) {
    const auto state = behind(program, text);
    return state ? spelled(state->tool) : "unreached";
}

TEST(MachineStates, AreFollowedOverSoManyCallsAsAnyControlTakes) {
    std::string text = "O1\nT1 M6\nM98 P2\nX1.\nM30\n";
    for (int number = 2; number < 5000; ++number)
        text += "O" + std::to_string(number) + "\nM98 P" + std::to_string(number + 1) + "\nM99\n";
    EXPECT_EQ(tool_behind(text + "O5000\nM99\n", "X1."), "?");
    EXPECT_EQ(tool_behind("O1\nT1 M6\nM98 P2\nX1.\nM30\nO2\nM98 P3\nM99\nO3\nM99\n", "X1."), "1");
}

TEST(MachineStates, KnowTheToolThatAChangeBrings) {
    EXPECT_EQ(tool_behind("O1\nT1 M6\nX1.\nM30\n", "X1."), "1");
    EXPECT_EQ(tool_behind("O1\nM6 T1\nX1.\nM30\n", "X1."), "1");
    EXPECT_EQ(tool_behind("O1\nT1\nM6\nT2\nX1.\nM30\n", "X1."), "1") << "T2 is only prepared";
    EXPECT_EQ(tool_behind("O1\nT1\nM6\nT2\nX1.\nM6\nX2.\nM30\n", "X2."), "2");
    EXPECT_EQ(tool_behind("O1\nT1 M6\nT2 M6\nX2.\nM30\n", "X2."), "2");
    EXPECT_EQ(tool_behind("O1\nT1\nM6 T2\nX1.\nM30\n", "X1."), "?") << "machines differ";
    EXPECT_EQ(tool_behind("O1\nT#1 M6\nX1.\nM30\n", "X1."), "?");
    EXPECT_EQ(tool_behind("O1\nX1.\nM30\n", "X1."), "caller's");
}

TEST(MachineStates, MeetWherePathsMeet) {
    const std::string one_way = "O1\nT1 M6\nIF[#1EQ1]GOTO5\nT2 M6\nN5 X1.\nM30\n";
    EXPECT_EQ(tool_behind(one_way, "X1."), "?");
    const std::string both = "O1\nIF[#1EQ1]GOTO4\nT2 M6\nGOTO5\nN4 T2 M6\nN5 X1.\nM30\n";
    EXPECT_EQ(tool_behind(both, "X1."), "2");
    EXPECT_EQ(tool_behind("O1\nT1 M6\n/T2 M6\nX1.\nM30\n", "X1."), "?") << "the block may be skipped";
}

TEST(MachineStates, GoThroughCalls) {
    const std::string sets = "O1\nT1 M6\nM98 P2\nX1.\nM30\nO2\nS500 M3\nM99\n";
    const auto state = behind(sets, "X1.");
    ASSERT_TRUE(state);
    EXPECT_EQ(spelled(state->tool), "1") << "O2 does not touch it";
    EXPECT_EQ(spelled(state->of(ModalRole::spindle)), "3");
    EXPECT_EQ(spelled(state->of(ModalRole::speed)), "500");
    EXPECT_EQ(tool_behind("O1\nT1 M6\nM98 P3\nX1.\nM30\n", "X1."), "?") << "nobody has O3";
}

TEST(MachineStates, HaveTheSpindleStoppedByAToolChange) {
    const auto stopped = behind("O1\nS500 M3\nT1 M6\nX1.\nM30\n", "X1.");
    EXPECT_EQ(spelled(stopped->of(ModalRole::spindle)), "5");
    const auto foreign = behind("O1\nS500 M5\nM77\nX1.\nM30\n", "X1.");
    EXPECT_EQ(spelled(foreign->of(ModalRole::spindle)), "?") << "M77 may start it";
    const auto coolant = behind("O1\nS500 M3\nM8\nX1.\nM30\n", "X1.");
    EXPECT_EQ(spelled(coolant->of(ModalRole::spindle)), "3");
}

TEST(MachineStates, KnowWhereTheToolIs) {
    const auto z_behind = [](const std::string& blocks) {
        return behind("O1\nG90 G0 Z50.\n" + blocks + "\nM30\n", "Y9.")->position[2];
    };
    EXPECT_EQ(z_behind("Z5.\nY9."), 5);
    EXPECT_EQ(z_behind("G91 Z-5.\nY9."), 45);
    EXPECT_TRUE(std::isnan(z_behind("Z5\nY9."))) << "a word without a point may be thousandths";
    EXPECT_TRUE(std::isnan(z_behind("G91 G28 Z0\nY9.")));
    EXPECT_TRUE(std::isnan(z_behind("G53 Z0\nY9.")));
    EXPECT_TRUE(std::isnan(z_behind("G55\nY9."))) << "it counts from elsewhere now";
    EXPECT_EQ(z_behind("G98 G81 X1. Z-5. R2.\nG80 Y9."), 50) << "the depth is no position";
    EXPECT_EQ(z_behind("G99 G81 X1. Z-5. R2.\nG80 Y9."), 2);
}

TEST(MachineStates, OfALongPlainRunAreThoseOfWhatBeginsSomething) {
    std::string program = "O1\nG90 G17\nT1 M6\nS500 M3\n";
    for (int i = 0; i < 60'000; ++i) program += "X" + std::to_string(i % 100) + ".\n";
    const auto state = behind(program + "T2\nX1000.\nM30\n", "X1000.");
    ASSERT_TRUE(state);
    EXPECT_EQ(spelled(state->prepared), "2");
    EXPECT_EQ(spelled(state->of(ModalRole::spindle)), "3");
}

TEST(MachineStates, LeaveToCallersWhatCutsByTheirSpindle) {
    const auto workspace =
        test::analyse_fanuc("O1\nM98 P2\nM98 P3\nM30\nO2\nG1 X5. F200.\nM99\nO3\nS500 M3\nG1 X5.\nM99\n");
    const auto& called = workspace->programs()[1].machine().left();
    EXPECT_TRUE(called.cuts_with_spindle);
    EXPECT_FALSE(called.cuts_with_feed);
    const auto& starts = workspace->programs()[2].machine().left();
    EXPECT_FALSE(starts.cuts_with_spindle);
    EXPECT_TRUE(starts.cuts_with_feed);
}

} // namespace
} // namespace maclint::machine
