//! Who uses a label, where a jump can lead, and which modal calls of a program are still active.
#include "analyzer/dataflow/facts/exit_state.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "analyzer/workspace/written_as_macro.hpp"
#include "tests/support/analysed.hpp"

#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// 1-based line of the first block that uses the label; 0: none does.
std::uint32_t user_of(std::int64_t label, const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto user = analysis.user_of_label(Label{label});
    return user ? test::line_of_effect(analysis, *user) : 0;
}

/// "main", "macro", or "called" for a subprogram.
std::string kind_of(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    if (analysis.is_macro()) return "macro";
    return analysis.is_main() ? "main" : "called";
}

TEST(Kind, OfAProgramThatReturnsIsCalled) {
    EXPECT_EQ(kind_of("O1\nX#1\nM99\n"), "macro");
    EXPECT_EQ(kind_of("O1\nX1.\nM99\n"), "called");
    EXPECT_EQ(kind_of("O1\nX#1\nM30\n"), "main");
}

TEST(Kind, OfAProgramWithANumberOfMacrosThatReadsArgumentsIsAMacro) {
    EXPECT_EQ(kind_of("O9993\n#100=#1\nIF[#100EQ#0]GOTO9\nM30\nN9#3000=1\n"), "macro");
    EXPECT_EQ(kind_of("O8000\nX#1\nM30\n"), "macro");
    EXPECT_EQ(kind_of("O7999\nX#1\nM30\n"), "main");
    EXPECT_EQ(kind_of("O9993\n#1=5\nX#1\nM30\n"), "main"); // it sets what it reads
    EXPECT_EQ(kind_of("O9993\nX#33\nM30\n"), "main");      // no letter reaches #33
}

TEST(Kind, OfAProgramThatAsksWhetherAnArgumentWasPassedIsAMacro) {
    EXPECT_EQ(kind_of("O1\nIF[#24EQ#0]GOTO9\nX#24\nM30\nN9#3000=1\n"), "macro");
    EXPECT_EQ(kind_of("O1\nIF[#33EQ#0]GOTO9\nX#33\nM30\nN9#3000=1\n"), "main");
    EXPECT_EQ(kind_of("O1\n#24=#0\nIF[#24EQ#0]GOTO9\nX#24\nM30\nN9#3000=1\n"), "main");
    EXPECT_EQ(kind_of("O1\nIF[#24EQ0]GOTO9\nX#24\nM30\nN9#3000=1\n"), "main");
}

TEST(Kind, OfAProgramWhoseRemarkShowsItsCallIsAMacro) {
    EXPECT_EQ(kind_of("O12(G65 P12 A B C)\nX#1\nM30\n"), "macro");
    EXPECT_EQ(kind_of("O12\n(CALL WITH G65P0012 A1.)\nX#1\nM30\n"), "macro");
    EXPECT_EQ(kind_of("O12(G65 P13 A B C)\nX#1\nM30\n"), "main");
    EXPECT_EQ(kind_of("O12(G65)\nG65 P12 A#1\nM30\n"), kind_of("O12\nG65 P12 A#1\nM30\n"));
}

TEST(UserOfLabel, IsTheFirstJumpInTheText) {
    EXPECT_EQ(user_of(10, "N10#1=1\nIF[#1EQ1]GOTO10\nIF[#1EQ2]GOTO10\nM30\n"), 2U);
    EXPECT_EQ(user_of(10, "IF[#1EQ2]GOTO10\n#1=1\nN10#1=1\nIF[#1EQ1]GOTO10\nM30\n"), 1U);
    EXPECT_EQ(user_of(20, "N10#1=1\nIF[#1EQ1]GOTO10\nN20M30\n"), 0U);
    EXPECT_EQ(user_of(10, "GOTO3\nGOTO10\nN3M30\nN10M30\n"), 2U); // no path leads to the jump, but it says so
}

TEST(UserOfLabel, MayComputeIt) {
    const std::string known = "#1=20\nGOTO#1\nN10#2=1\nN20M30\n";
    EXPECT_EQ(user_of(20, known), 2U);
    EXPECT_EQ(user_of(10, known), 0U);
    EXPECT_EQ(user_of(10, "#1=20\nGOTO#100\nN10#2=1\nN20M30\n"), 2U);
}

TEST(UserOfLabel, MayBeACallThatReturnsThere) {
    EXPECT_EQ(user_of(30, "O1\nM98P2\n#1=5\nN30M30\nO2\nM99P30\n"), 2U);
    EXPECT_EQ(user_of(30, "O1\nM98P2\n#1=5\nN30M30\nO2\nM99\n"), 0U);
}

TEST(UserOfLabel, IsNoBlockThatCannotBeRead) {
    EXPECT_EQ(user_of(4, "IF[#1EQ1 GOTO4\n#2=2\nIF[#1EQ1]GOTO4\nN4M30\n"), 3U);
    EXPECT_EQ(user_of(4, "IF[#1EQ1 GOTO4\n#2=2\nN4M30\n"), 0U);
}

/// 1-based lines to which the first jump of a program can lead.
std::set<std::uint32_t> targets(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::set<std::uint32_t> lines;
    for (const flow::LabelledBlock& target : analysis.targets_of(analysis.graph().jumps.front()))
        lines.insert(test::line_of(analysis, target.block.begin));
    return lines;
}

TEST(TargetsOfAJump, AreTheBlocksThatItsValueAllows) {
    EXPECT_THAT(targets("GOTO20\nN10#2=1\nN20M30\n"), ElementsAre(3));
    EXPECT_THAT(targets("GOTO30\nN10#2=1\nN20M30\n"), IsEmpty());
    EXPECT_THAT(targets("GOTO#100\nN10#2=1\nN20M30\n"), ElementsAre(2, 3));
    EXPECT_THAT(targets("#1=20\nGOTO#1\nN10#2=1\nN20M30\n"), ElementsAre(4));
    // Two jumps from one node are two jumps.
    EXPECT_THAT(targets("IF[#100EQ1]GOTO#101\n#1=20\nGOTO#1\nN10#2=1\nN20M30\n"), ElementsAre(4, 5));
}

TEST(TargetsOfAJump, AreNotListedWhereVeryManyJumpsAreComputed) {
    std::string text;
    constexpr int jumps = 150;
    for (int i = 1; i <= jumps; ++i)
        text += "IF[#100EQ1]GOTO#101\nN" + std::to_string(i) + "#1=" + std::to_string(i) + "\n";
    const auto workspace = test::analyse_fanuc(text + "M30\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    EXPECT_LT(analysis.graph().edges.size(), 10U * jumps);
    EXPECT_TRUE(analysis.targets_of(analysis.graph().jumps.front()).empty());
    // Every label is still reached by every jump, over at most one node between.
    const auto computed = [&](flow::EdgeId id) {
        return analysis.graph().edges[id].kind == flow::EdgeKind::computed;
    };
    ASSERT_EQ(analysis.graph().jumps.size(), std::size_t{jumps});
    ASSERT_EQ(analysis.graph().labels.size(), std::size_t{jumps});
    for (const flow::ResolvedJump& jump : analysis.graph().jumps)
        for (const flow::LabelledBlock& label : analysis.graph().labels) {
            const auto path = analysis.graph().path(jump.node, label.node, computed, 1000);
            ASSERT_TRUE(path);
            EXPECT_LE(path->size(), 2U);
        }
}

/// 1-based lines of the modal calls that are active where the first program is left.
std::vector<std::uint32_t> active_calls(std::string_view dialect, const std::string& text) {
    const auto workspace = test::analyse_text(dialect, text);
    const ProgramAnalysis& analysis = workspace->programs().front();
    std::set<std::uint32_t> lines;
    for (const dataflow::ExitState& exit : analysis.facts().all<dataflow::ExitState>())
        for (const dataflow::OriginId call : analysis.own_modal_calls(exit.state, exit.exit.node))
            lines.insert(test::line_of_effect(analysis, analysis.data().origin(call).id));
    return {lines.begin(), lines.end()};
}

TEST(ModalCalls, AreActiveUntilCancelled) {
    EXPECT_THAT(active_calls("fanuc", "O1\nG66P9010A1.\nX1.\nM30\n"), ElementsAre(2));
    EXPECT_THAT(active_calls("fanuc", "O1\nG66P9010A1.\nX1.\nG67\nM30\n"), IsEmpty());
    EXPECT_THAT(active_calls("fanuc", "O1\nG65P9010A1.\nX1.\nM30\n"), IsEmpty());
    EXPECT_THAT(active_calls("fanuc", "O1\nIF[#100EQ1]GOTO5\nG66P9010A1.\nGOTO6\nN5G66P9020A1.\nN6M30\n"),
                ElementsAre(3, 5));
}

TEST(ModalCalls, ThatAnotherProgramMadeOrMayHaveCancelledAreNotOwn) {
    EXPECT_THAT(active_calls("fanuc", "O1\nM98P2\nM30\nO2\nG66P9010A1.\nM99\n"), IsEmpty());
    EXPECT_THAT(active_calls("fanuc", "O2\nX1.\nM99\nO1\nG66P9010A1.\nM98P2\nM30\n"), IsEmpty());
    EXPECT_THAT(active_calls("fanuc", "O1\nG66P9010A1.\nM98P77\nM30\n"), IsEmpty());
}

TEST(ModalCalls, AreUnknownToControlsThatHaveNone) {
    EXPECT_THAT(active_calls("dinplus", "MACHINING\nL\"S\"\nM30\nSUBPROGRAM \"S\"\nRETURN\n"), IsEmpty());
}

} // namespace
} // namespace maclint
