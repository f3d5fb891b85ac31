//! Two programs that do the same are told from two that do not.
#include "tests/execution/compared_runs.hpp"

#include <gtest/gtest.h>

namespace maclint::test {
namespace {

/// The program of two texts, and the lines from 1 on that differ.
Comparison compared(const std::string& before, const std::string& after, std::vector<std::uint32_t> lines) {
    RunsOf runs(std::vector<NamedText>{{"O9001.nc", "O9001\n" + before}});
    return runs.compare("O9001\n" + after, {}, {"O9001.nc", std::move(lines), {}});
}

TEST(ComparedRuns, DropsAWordThatAVacantVariableWouldHaveDropped) {
    const std::string text = "IF[#24%#0]THEN#24=5.\nG0X#24\nM99";
    const auto with = [&](const std::string& what) {
        std::string changed = text;
        return changed.replace(changed.find("%#0"), 3, what);
    };
    EXPECT_TRUE(compared(with("EQ#0"), with("EQ0"), {2}).values);
    EXPECT_TRUE(compared(with("EQ#0"), with("EQ #0"), {2}).same());
}

TEST(ComparedRuns, TakesVacantForZeroWhereAComparisonFollows) {
    const Comparison found = compared("IF[#24EQ#0]GOTO8\nIF[#24LT10]GOTO8\nG0X#24\nN8M99",
                                      "IF[#24EQ0]GOTO8\nIF[#24LT10]GOTO8\nG0X#24\nN8M99", {2});
    EXPECT_TRUE(found.same());
    EXPECT_TRUE(found.blocks); // the second test is passed only in one of them
    EXPECT_GT(found.touching, 10U);
}

TEST(ComparedRuns, FindsWhatManyTestsGuard) {
    const std::string guards =
        "IF[#24LT100]GOTO8\nIF[#25LT30]GOTO8\nIF[#26GE-3]GOTO8\nIF[#6NE7]GOTO8\nIF[#9LE700]GOTO8\n";
    EXPECT_TRUE(compared(guards + "G1X1.\nN8M99", guards + "G1X2.\nN8M99", {7}).values);
}

TEST(ComparedRuns, TellsWhatIsLeftAtTheEndFromWhatIsDone) {
    const Comparison left = compared("#3=#4003\nG91G0X1.\nG#3\nM99", "#3=#4003\nG91G0X1.\n\nM99", {4});
    EXPECT_TRUE(left.codes_at_end);
    EXPECT_FALSE(left.values);
    const Comparison done = compared("G91G0X1.\nG90\nM99", "G91G0X2.\nG90\nM99", {2});
    EXPECT_TRUE(done.values);
    EXPECT_FALSE(done.codes_at_end);
}

TEST(ComparedRuns, SeesVariablesThatProgramsShare) {
    EXPECT_TRUE(compared("#101=#24+1\nM99", "#101=#24+2\nM99", {2}).variables_at_end);
    EXPECT_TRUE(compared("#33=#24+1\nM99", "#33=#24+2\nM99", {2}).same());
}

TEST(ComparedRuns, SeesTheCodeInForceAtAMove) {
    EXPECT_TRUE(compared("G90\nX#24\nG90\nM99", "G91\nX#24\nG90\nM99", {2}).values);
    EXPECT_TRUE(compared("G91\nG90\nX#24\nM99", "G90\nG90\nX#24\nM99", {2}).same());
}

TEST(ComparedRuns, SeesAnAlarmAndARunThatDoesNotEnd) {
    EXPECT_TRUE(compared("IF[#24EQ1]THEN#3000=1\nM99", "IF[#24EQ2]THEN#3000=1\nM99", {2}).values);
    EXPECT_TRUE(compared("#1=0\nWHILE[#1LT5]DO1\n#1=#1+1\nEND1\nM99",
                         "#1=0\nWHILE[#1LT5]DO1\n#1=#1+0\nEND1\nM99", {4})
                    .values);
}

TEST(ComparedRuns, KnowsALineThatNoPathLeadsTo) {
    const Comparison found = compared("M99\nG0X1.", "M99\nG0X2.", {3});
    EXPECT_FALSE(found.reachable);
    EXPECT_EQ(found.touching, 0U);
}

TEST(ComparedRuns, CountsAddedLinesWithTheLineThatHoldsThem) {
    RunsOf runs(std::vector<NamedText>{{"O9001.nc", "O9001\n#3=#4003\nG91\nG#3\nM99"}});
    const Comparison found =
        runs.compare("O9001\n#3=#4003\nG91\nM99\nG#3\nM99", {}, {"O9001.nc", {4}, {{4, 1}}});
    EXPECT_TRUE(found.codes_at_end);
    EXPECT_FALSE(found.values);
    const ChangedLines two{"", {}, {{3, 1}, {6, 2}}};
    std::vector<std::uint32_t> before;
    for (std::uint32_t line = 1; line <= 10; ++line) before.push_back(two.before(line));
    EXPECT_EQ(before, (std::vector<std::uint32_t>{1, 2, 3, 3, 4, 5, 6, 6, 6, 7}));
}

TEST(ComparedRuns, AreToldTheSameHoweverTheChangeMovesWhatIsAsked) {
    const std::string rest = "#33=#5041+#5042\nG0X#33Y#5221\nM98P7\nG0Z#101\nM99";
    EXPECT_TRUE(compared("G0X1.\n" + rest, "#32=[#24+[#25*2]]\n" + rest, {2}).values);
    EXPECT_TRUE(compared("#32=1\n" + rest, "#32=[#24+[#25*2]]\n" + rest, {2}).same());
}

TEST(ComparedRuns, LooksIntoCalledPrograms) {
    RunsOf runs(std::vector<NamedText>{{"O1.nc", "O1\nG65P2X#101\nM30"},
                                       {"O2.nc", "O2\nIF[#24EQ#0]GOTO1\nG0X5.\nN1M99"}});
    EXPECT_TRUE(runs.compare("O1\nG65P2Y#101\nM30", {}, {"O1.nc", {2}, {}}).values);
}

} // namespace
} // namespace maclint::test
