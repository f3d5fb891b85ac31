//! What a program means on one control of the family and not on another, and what is told of it while nobody
//! has named the control.
#include "tests/support/linted.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// "error MAC106 on line 4", for each finding.
std::vector<std::string> told(const std::vector<test::LintedText>& texts, std::string_view control = "") {
    static constexpr const char* severities[] = {"note", "warning", "error"};
    cli::Overrides overrides;
    if (!control.empty()) overrides.control = std::string(control);
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] : test::lint_texts(texts, std::move(overrides)).findings)
        all.push_back(std::string(severities[static_cast<int>(finding.severity)]) + " " +
                      std::string(finding.rule->code) + " on line " +
                      std::to_string(finding.source->position(finding.span.begin).line));
    return all;
}

std::vector<std::string> told(const std::string& text, std::string_view control = "") {
    return told({{"O1.nc", text}}, control);
}

/// O1 calls O2 calls O3 …: as many calls as `levels`, each on line 2 of its program but for the first one.
std::string nested(const std::string& call, int levels) {
    std::string text = "O1\n" + call + "P2\nM30\n";
    for (int program = 2; program <= levels; ++program)
        text += "O" + std::to_string(program) + "\n" + call + "P" + std::to_string(program + 1) + "\nM99\n";
    return text + "O" + std::to_string(levels + 1) + "\nG0X1.\nM99\n";
}

int line_of_call(int level) { return 3 * (level - 1) + 2; }

std::vector<std::string> calls_told(const std::string& call, int levels, std::string_view control = "") {
    return told(nested(call, levels), control);
}

std::string at_level(std::string_view what, int level) {
    return std::string(what) + " on line " + std::to_string(line_of_call(level));
}

TEST(NoControlNamed, AMacroLevelThatOnlyNewerSeriesHaveIsAWarningAndOneThatNoneHasAnError) {
    EXPECT_THAT(calls_told("G65", 4), IsEmpty());
    EXPECT_THAT(calls_told("G65", 5), ElementsAre(at_level("warning MAC410", 5)));
    EXPECT_THAT(calls_told("G65", 6), ElementsAre(at_level("error MAC410", 6))) << "one cause, one finding";
    EXPECT_THAT(calls_told("G65", 5, "fanuc-16i"), ElementsAre(at_level("error MAC410", 5)));
    EXPECT_THAT(calls_told("G65", 5, "fanuc-30i"), IsEmpty());
    EXPECT_THAT(calls_told("G65", 6, "fanuc-30i"), ElementsAre(at_level("error MAC410", 6)));
}

TEST(NoControlNamed, SubprogramLevelsOfNewerSeriesAreWarnings) {
    EXPECT_THAT(calls_told("M98", 5), ElementsAre(at_level("warning MAC411", 5)));
    EXPECT_THAT(calls_told("M98", 10), ElementsAre(at_level("warning MAC411", 5))) << "a 30i has ten";
    EXPECT_THAT(calls_told("M98", 11), ElementsAre(at_level("error MAC411", 11)));
    EXPECT_THAT(calls_told("M98", 5, "fanuc-16i"), ElementsAre(at_level("error MAC411", 5)));
}

TEST(NoControlNamed, LoopNumbersOfOtherMakersAreAWarning) {
    const auto loop = [](const std::string& n) {
        return "O1\nWHILE[#500GT0]DO" + n + "\n#500=#500-1\nEND" + n + "\nM30\n";
    };
    EXPECT_THAT(told(loop("15")), ElementsAre("warning MAC314 on line 2"));
    EXPECT_THAT(told(loop("128")), ElementsAre("error MAC314 on line 2")) << "nobody has it";
    EXPECT_THAT(told(loop("0")), ElementsAre("error MAC314 on line 2"));
    EXPECT_THAT(told(loop("15"), "fanuc-16i"), ElementsAre("error MAC314 on line 2"));
    EXPECT_THAT(told(loop("15"), "mitsubishi"), IsEmpty());
    EXPECT_THAT(told(loop("3")), IsEmpty());
}

TEST(CannedCycle, EndsWithAMoveButOnAHaasOfBefore2000) {
    const std::string program = "O9001\nG81Z-5.R2.F100.\nX10.\nG0Z50.\nM99\n";
    EXPECT_THAT(told(program), IsEmpty());
    EXPECT_THAT(told(program, "fanuc-16i"), IsEmpty());
    EXPECT_THAT(told(program, "haas"), IsEmpty());
    EXPECT_THAT(told(program, "haas-1999"), ElementsAre("warning MAC502 on line 2"));
    EXPECT_THAT(told("O9001\nG81Z-5.R2.F100.\nX10.\nG80\nG0Z50.\nM99\n", "haas-1999"), IsEmpty());
    EXPECT_THAT(told("O9001\nG81Z-5.R2.F100.\nX10.\nM99\n"), ElementsAre("warning MAC502 on line 2"));
}

constexpr const char* local_branch = "O9002\nN10G0X1.\n#100=#100+1\nIF[#100GT5]GOTO90\nM99 P10\nN90 M99\n";
constexpr const char* its_caller = "O1\nM98P9002\nM30\n";

TEST(ReturnToABlock, OfAHaasStaysInItsProgram) {
    const std::vector<test::LintedText> both = {{"O9002.nc", local_branch}, {"O1.nc", its_caller}};
    EXPECT_THAT(told(both), ElementsAre("warning MAC333 on line 5"));
    EXPECT_THAT(told(both, "fanuc-16i"), ElementsAre("error MAC333 on line 5"));
    EXPECT_THAT(told(both, "haas"), IsEmpty());
    std::string marked = local_branch;
    marked.insert(marked.find("N10"), "(HAAS)\nG103 P1\nG103\n");
    EXPECT_THAT(told({{"O9002.nc", marked}, {"O1.nc", its_caller}}), IsEmpty()) << "marked";
}

TEST(ReturnToABlock, ThatStandsNowhereIsAnErrorOnEveryControl) {
    std::string wrong = local_branch;
    wrong.replace(wrong.find("P10"), 3, "P70");
    const std::vector<test::LintedText> both = {{"O9002.nc", wrong}, {"O1.nc", its_caller}};
    EXPECT_THAT(told(both), ElementsAre("error MAC333 on line 5"));
    EXPECT_THAT(told(both, "haas"), ElementsAre("error MAC301 on line 5"));
}

TEST(ConditionBeforeM99, IsOfHaasAlone) {
    const std::string program = "O9003\nN10G0X1.\n#100=#100+1\nG0X2. [#100 LT 5] M99 P10\nM99\n";
    EXPECT_THAT(told(program), ElementsAre("warning MAC121 on line 4"));
    EXPECT_THAT(told(program, "fanuc-16i"), ElementsAre("error MAC121 on line 4"));
    EXPECT_THAT(told(program, "haas"), IsEmpty());
    const std::string alone = "O9003\nN10G0X1.\n#100=#100+1\nN50 [#100 LT 5] M99 P10\nM99\n";
    EXPECT_THAT(told(alone, "haas"), IsEmpty());
    EXPECT_THAT(told("O9003\nG0X2. [#100 LT 5] G1 X1.F100\nM30\n", "haas"),
                ElementsAre("error MAC121 on line 2"));
}

/// The condition decides: where it is never true, the blocks after it run.
TEST(ConditionBeforeM99, GuardsTheJump) {
    const std::string head = "O9003\n#1=1\n[#1 ";
    EXPECT_THAT(told(head + "EQ 2] M99 P70\n#2=1/0\nN70M30\n", "haas"),
                testing::Contains(HasSubstr("MAC702 on line 4")));
    EXPECT_THAT(told(head + "EQ 1] M99 P70\n#2=1/0\nN70M30\n", "haas"),
                testing::Not(testing::Contains(HasSubstr("MAC702"))));
}

TEST(ControlMarks, HighCommonVariablesCountBesideAnotherMarkInTheCode) {
    const auto detected = [](const std::string& text) {
        return told({{"O1.nc", its_caller}, {"O9002.nc", "O9002\n" + text + (local_branch + 6)}});
    };
    EXPECT_THAT(detected("#10100=1\n"), testing::Not(IsEmpty())) << "a tool offset elsewhere";
    EXPECT_THAT(detected("(HAAS)\n#10100=1\n"), testing::Not(IsEmpty()));
    EXPECT_THAT(detected("G103 P1\nG103\n#10100=1\n"), IsEmpty());
}

constexpr const char* block_if = "O9040(Q 0 OR 1)\nIF[#17EQ0]THEN\nG5.1Q0\nELSE\nG5.1Q1\nENDIF\nM99\n";

TEST(BlockIf, IsAWarningWhileNobodyHasNamedTheControl) {
    EXPECT_THAT(told(block_if), ElementsAre("warning MAC118 on line 2"));
    EXPECT_THAT(told(block_if, "mitsubishi"), IsEmpty());
    EXPECT_THAT(told(block_if, "mazak-eia"), IsEmpty());
    for (const char* control : {"fanuc-16i", "fanuc-30i", "nct"})
        EXPECT_THAT(told(block_if, control), ElementsAre("error MAC118 on line 2")) << control;
    EXPECT_THAT(told(block_if, "haas"), testing::Contains("error MAC118 on line 2"))
        << "which lacks G5.1, too";
}

TEST(BlockIf, WithoutItsEndIsAnError) {
    const std::string open = "O9040\nIF[#17EQ0]THEN\nG5.1Q0\nM99\n";
    EXPECT_THAT(told(open), ElementsAre("error MAC118 on line 2")) << "a THEN that lacks its statement";
    EXPECT_THAT(told(open, "mitsubishi"), ElementsAre("error DIN401 on line 2"));
    EXPECT_THAT(told("O9040\nG0X1.\nENDIF\nM99\n", "mitsubishi"), ElementsAre("error MAC121 on line 3"));
}

/// `{0}` of the branch is what the condition makes of #1.
TEST(BlockIf, RunsOneOfItsBranches) {
    const auto program = [](const std::string& value) {
        return "O1\n#1=" + value + "\nIF[#1EQ1]THEN\n#2=1/0\nELSE\n#3=SQRT[-1]\nENDIF\nM30\n";
    };
    const auto holds = [](const char* code) { return testing::Contains(HasSubstr(code)); };
    EXPECT_THAT(told(program("1"), "mitsubishi"),
                testing::AllOf(holds("MAC702 on line 4"), testing::Not(holds("line 6"))));
    EXPECT_THAT(told(program("2"), "mitsubishi"),
                testing::AllOf(holds("MAC703 on line 6"), testing::Not(holds("line 4"))));
}

TEST(BlockIf, OfTheControlIsToldOfWhatIsTooMuch) {
    const auto told_in = [](const std::string& blocks) {
        return told("O9040\n" + blocks + "M99\n", "mitsubishi");
    };
    EXPECT_THAT(told_in("G0X1.\nELSE\n"), ElementsAre("error MAC121 on line 3"));
    EXPECT_THAT(told_in("IF[#17EQ0]THEN\nG5.1Q0\nELSE\nG5.1Q1\nELSE\nG5.1Q2\nENDIF\n"),
                ElementsAre("error MAC121 on line 6"));
    EXPECT_THAT(told_in("IF[#17EQ0]THEN\nIF[#18EQ0]THEN\nG5.1Q0\nELSE\nG5.1Q1\nENDIF\nELSE\nG5.1Q2\nENDIF\n"),
                IsEmpty());
}

TEST(GcodeSystem, OfALatheSaysWhichCodesExcludeEachOther) {
    const std::string system_b =
        "O2001\nG21G40G97G95\nG92S2500\nT0101\nG96S150M3\nG90G0X62.Z5.\nG1Z-20.F0.2\nG91G1X2.\n"
        "G90G0X64.\nG0G90X200.Z200.\nT0100\nM5\nM30\n";
    EXPECT_THAT(told(system_b, "fanuc-16i-lathe-b"), IsEmpty());
    EXPECT_THAT(told(system_b, "fanuc-16i-lathe"), IsEmpty()) << "the text shows its system";
    EXPECT_THAT(told(system_b, "fanuc-16i"), IsEmpty());
    EXPECT_THAT(told(system_b), IsEmpty());
    // G50 S is of system A: there G90 is a turning cycle.
    const std::string system_a =
        "O2002\nG21G40\nG50S2500\nT0101\nG96S150M3\nG90G0X62.Z5.\nG0X200.Z200.\nM30\n";
    for (const char* control : {"", "fanuc-16i", "fanuc-16i-lathe"})
        EXPECT_THAT(told(system_a, control), ElementsAre("warning MAC514 on line 6")) << control;
}

/// A conflict of G90 with a motion code is one of system A alone.
TEST(GcodeSystem, ShowsInTheTextByMarksAndByNoneOfSystemA) {
    const auto is_a = [](const std::string& marks) {
        return std::ranges::any_of(
            told("O1\nT0101\nG96S100M3\n" + marks + "G90G0X50.Z2.\nM30\n", "fanuc-16i-lathe"),
            [](const std::string& finding) { return finding.find("MAC514") != std::string::npos; });
    };
    EXPECT_TRUE(is_a("")) << "nothing tells";
    EXPECT_FALSE(is_a("G92S2000\n"));
    EXPECT_FALSE(is_a("G95\n"));
    EXPECT_FALSE(is_a("G77X48.Z-20.F0.2\n"));
    EXPECT_FALSE(is_a("G70\n")) << "C: inch";
    EXPECT_TRUE(is_a("G92S2000\nG50S2000\n"));
    EXPECT_TRUE(is_a("G92S2000\nG99\n"));
    EXPECT_FALSE(is_a("G92S2000\nG98G83X0Z-20.R2.Q5000F0.1\nG80\n")) << "the return level of a hole";
    EXPECT_TRUE(is_a("G92S2000\nG1U2.F0.1\n"));
    EXPECT_FALSE(is_a("G92S2000\nG4U2.\n")) << "a dwell";
}

TEST(EndOfProgram, MayStandInAComputedFunction) {
    EXPECT_THAT(told("O19\nG91G28Z0\nM#850\n%\n"), IsEmpty());
    EXPECT_THAT(told("O20\n#850=30\nG91G28Z0\nM#850\n%\n"), IsEmpty());
    EXPECT_THAT(told("O19\nM#850\nG91G28Z0\n%\n"), ElementsAre("error MAC455 on line 3"))
        << "what stands before the last block that does anything is no end";
}

} // namespace
} // namespace maclint
