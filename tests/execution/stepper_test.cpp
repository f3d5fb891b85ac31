//! Programs run by the stepper: what they leave in their variables, worked out by hand.
#include "analyzer/execution/stepper.hpp"
#include "analyzer/program/tables.hpp"
#include "tests/support/analysed.hpp"

#include <functional>
#include <map>
#include <string>

#include <gtest/gtest.h>

namespace maclint::execution {
namespace {

/// How a run has ended, and what common variables (DIN PLUS: #g) and modal groups hold then.
struct Ended {
    Leaving how;
    std::map<std::int32_t, Content> variables;
    std::map<std::string, double, std::less<>> groups;
};

/// Nothing is vacant by chance: what no program sets is 0; block skip is off.
Environment quiet() {
    Environment environment;
    environment.at_start = [](const Program&, Variable) { return Content{}; };
    environment.code_at_start = [](GroupId) { return 0.0; };
    environment.value_of = [](const Program&, ExpressionId) { return Content{0}; };
    environment.typed_in = [](const Program&, Variable) { return Content{7}; };
    environment.skips = [](const BlockView&) { return false; };
    environment.unknown_call = [](const Program&, CallKindId) { return UnknownEffects{}; };
    return environment;
}

Ended run(const std::vector<test::NamedText>& files, const Environment& environment = quiet(),
          Bounds bounds = {.steps = 1000, .depth = 5}) {
    const auto workspace = test::analyse_files(files, {.complete = true, .jobs = 1});
    Ended ended{};
    Stepper stepper(
        *workspace, environment,
        [&](Stepper& at, const Event& event) {
            if (!std::holds_alternative<ProgramLeft>(event)) return;
            const ControlModel& control = at.program().control();
            const bool macro = control.language == "fanuc";
            for (const std::int32_t number : {100, 101, 102, 103, 1, 2, 3, 4}) {
                const auto space = static_cast<SpaceId>(macro ? (number < 100 ? 0 : 1) : 3);
                ended.variables[number] = at.content({space, number});
            }
            for (std::size_t i = 0; i < control.groups.size(); ++i)
                ended.groups[std::string(control.groups[i].name)] = at.code(static_cast<GroupId>(i));
        },
        bounds);
    ended.how = stepper.run({0, {}});
    return ended;
}

Ended run_macro(const std::string& text, const Environment& environment = quiet()) {
    return run({{"O1.nc", "O0001\n" + text}}, environment);
}
Ended run_din(const std::string& text, const Environment& environment = quiet()) {
    return run({{"main.nc", text}}, environment);
}

TEST(Stepper, CopiesKeepVacancyAndCalculationsEndIt) {
    const Ended ended = run_macro("#100=#1\n#101=#1*5\n#102=[2+3]*4\nM30\n");
    EXPECT_EQ(ended.how, Leaving::ends);
    EXPECT_EQ(ended.variables.at(100), Content{});
    EXPECT_EQ(ended.variables.at(101), Content{0});
    EXPECT_EQ(ended.variables.at(102), Content{20});
}

TEST(Stepper, AJumpIsLookedForToTheEndAndThenFromTheTop) {
    // The first N5 is found from the top only when none follows.
    const Ended forward = run_macro("N5#100=1\nIF[#101EQ1]GOTO9\n#101=1\nGOTO5\nN5#100=2\nN9M30\n");
    EXPECT_EQ(forward.variables.at(100), Content{2});
    const Ended back = run_macro("N5#100=#100+1\nIF[#100LT3]GOTO5\nM30\n");
    EXPECT_EQ(back.variables.at(100), Content{3});
    EXPECT_EQ(run_macro("GOTO8\nM30\n").how, Leaving::fault);
    EXPECT_EQ(run_macro("#1=7\nGOTO#1\nM30\nN7#100=1\nM99\n").variables.at(100), Content{1});
}

TEST(Stepper, LoopsRepeatWhileTheirConditionIsTrue) {
    const Ended ended = run_macro("#1=1\nWHILE[#1LE4]DO1\n#100=#100+#1\n#1=#1+1\nEND1\nM30\n");
    EXPECT_EQ(ended.variables.at(100), Content{10});
    const Ended never = run_macro("WHILE[#1EQ5]DO1\n#100=1\nEND1\n#101=2\nM30\n");
    EXPECT_EQ(never.variables.at(100), Content{});
    EXPECT_EQ(never.variables.at(101), Content{2});
    EXPECT_EQ(run_macro("DO1\n#100=#100+1\nIF[#100EQ4]GOTO1\nEND1\nN1M30\n").variables.at(100), Content{4});
    EXPECT_EQ(run_macro("DO1\nEND1\nM30\n").how, Leaving::cut_off);
}

TEST(Stepper, ThenIsDoneOnlyWhereTheConditionIsTrue) {
    const Ended ended = run_macro("IF[#1EQ#0]THEN#100=1\nIF[#1EQ0]THEN#101=1\nM30\n");
    EXPECT_EQ(ended.variables.at(100), Content{1});
    EXPECT_EQ(ended.variables.at(101), Content{});
}

TEST(Stepper, AnIndexNamesTheVariable) {
    const Ended ended = run_macro("#1=101\n#[#1]=5\n#[#1+1.4]=#[#1]+1\nM30\n");
    EXPECT_EQ(ended.variables.at(101), Content{5});
    EXPECT_EQ(ended.variables.at(102), Content{6});
    EXPECT_EQ(run_macro("#[#1]=5\nM30\n").how, Leaving::fault);           // the null variable
    EXPECT_EQ(run_macro("#1=50\n#100=#[#1]\nM30\n").how, Leaving::fault); // there is none
    EXPECT_EQ(run_macro("#1=4003\nG91\n#100=#[#1]\nM30\n").variables.at(100), Content{91});
    EXPECT_EQ(run_macro("#1=3003\n#[#1]=1\nM30\n").groups.at("single-block suppression"), 1);
    EXPECT_EQ(run_macro("#1=3000\n#[#1]=1\nM30\n").how, Leaving::alarm);
}

TEST(Stepper, ModalGroupsAreSetByPlainBlocksByWordsAndByCode) {
    const Ended ended = run_macro("G91 X1\nG17\n#1=41\nG#1\nF[#1+9]\n#100=#4003\nM30\n");
    EXPECT_EQ(ended.groups.at("distance mode"), 91);
    EXPECT_EQ(ended.groups.at("plane"), 17);
    EXPECT_EQ(ended.groups.at("cutter compensation"), 41);
    EXPECT_EQ(ended.groups.at("feed"), 50);
    EXPECT_EQ(ended.variables.at(100), Content{91});
}

TEST(Stepper, AWordWithAVacantVariableIsIgnored) {
    const Ended ended = run_macro("F100\nF#1\nG90\nG#1\nM30\n");
    EXPECT_EQ(ended.groups.at("feed"), 100);
    EXPECT_EQ(ended.groups.at("distance mode"), 90);
}

TEST(Stepper, AMacroHasLocalsOfItsOwnAndASubprogramHasTheCallers) {
    const std::string macro = "O0002\n#100=#1+#2\n#3=9\nM99\n";
    const Ended called =
        run({{"O1.nc", "O0001\n#1=1\n#2=2\n#3=3\nG65 P2 A10 B#3\n#101=#3\nM30\n"}, {"O2.nc", macro}});
    EXPECT_EQ(called.variables.at(100), Content{13});
    EXPECT_EQ(called.variables.at(101), Content{3});
    const Ended shared =
        run({{"O1.nc", "O0001\n#1=1\n#2=2\n#3=3\nM98 P2\n#101=#3\nM30\n"}, {"O2.nc", macro}});
    EXPECT_EQ(shared.variables.at(100), Content{3});
    EXPECT_EQ(shared.variables.at(101), Content{9});
}

TEST(Stepper, ALetterGivenTwiceKeepsTheLastValue) {
    // The second I and D both mean #7 [MAN-PB278].
    const Ended ended = run({{"O1.nc", "O0001\nG65 P2 A1 B2 I-3 I4 D5\nM30\n"},
                             {"O2.nc", "O0002\n#100=#1\n#101=#2\n#102=#4\n#103=#7\nM99\n"}});
    EXPECT_EQ(ended.variables.at(100), Content{1});
    EXPECT_EQ(ended.variables.at(101), Content{2});
    EXPECT_EQ(ended.variables.at(102), Content{-3});
    EXPECT_EQ(ended.variables.at(103), Content{5});
}

TEST(Stepper, ACallIsRepeatedAsOftenAsItSays) {
    const std::string counts = "O0002\n#100=#100+1\nM99\n";
    EXPECT_EQ(run({{"O1.nc", "O0001\nM98 P2 L3\nM30\n"}, {"O2.nc", counts}}).variables.at(100), Content{3});
    EXPECT_EQ(run({{"O1.nc", "O0001\nM98 P2 L0\nM30\n"}, {"O2.nc", counts}}).variables.at(100), Content{});
    EXPECT_EQ(run({{"O1.nc", "O0001\nM98 P2 L#1\nM30\n"}, {"O2.nc", counts}}).variables.at(100), Content{1});
}

TEST(Stepper, AReturnToANumberGoesOnThere) {
    const Ended ended =
        run({{"O1.nc", "O0001\nG65 P2\n#100=1\nN7#101=2\nM30\n"}, {"O2.nc", "O0002\nM99 P7\n"}});
    EXPECT_EQ(ended.variables.at(100), Content{});
    EXPECT_EQ(ended.variables.at(101), Content{2});
    EXPECT_EQ(run({{"O1.nc", "O0001\nG65 P2\nM30\n"}, {"O2.nc", "O0002\nM99 P7\n"}}).how, Leaving::fault);
}

TEST(Stepper, AModalCallRunsItsProgramAfterEachMove) {
    const Ended ended = run({{"O1.nc", "O0001\nG66 P2 A2\nG90\nX1\nG1 Y2 F100\nX[#1+5]\nG67\nX3\nM30\n"},
                             {"O2.nc", "O0002\n#100=#100+#1\nM99\n"}});
    EXPECT_EQ(ended.variables.at(100), Content{6});
    EXPECT_EQ(ended.groups.at("modal macro call"), 67);
}

TEST(Stepper, AModalCallThatAProgramLeavesInForceActsInItsCaller) {
    const Ended ended = run({{"O1.nc", "O0001\nM98 P3\nX1\nX2\nM30\n"},
                             {"O2.nc", "O0002\n#100=#100+#1\nM99\n"},
                             {"O3.nc", "O0003\nG66 P2 A2\nM99\n"}});
    EXPECT_EQ(ended.variables.at(100), Content{4});
}

TEST(Stepper, CallsEndAtTheBoundOfDepth) {
    EXPECT_EQ(run({{"O1.nc", "O0001\nM98 P2\nM30\n"}, {"O2.nc", "O0002\nM98 P2\nM99\n"}}).how,
              Leaving::cut_off);
}

TEST(Stepper, WhatAnUnknownProgramDoesIsToldByTheEnvironment) {
    Environment environment = quiet();
    environment.unknown_call = [](const Program&, CallKindId) {
        return UnknownEffects{{{{1, 100}, Content{5}}}, {{2, 91}}, false};
    };
    const Ended ended = run_macro("G90\nM98 P77\n#101=#100\nM30\n", environment);
    EXPECT_EQ(ended.variables.at(101), Content{5});
    EXPECT_EQ(ended.groups.at("distance mode"), 91);
}

TEST(Stepper, ABlockIsSkippedWhereTheSwitchIsOn) {
    Environment environment = quiet();
    environment.skips = [](const BlockView& block) { return block.skip_levels == 1U << 2U; };
    const Ended ended = run_macro("/#100=1\n/2#101=1\nM30\n", environment);
    EXPECT_EQ(ended.variables.at(100), Content{1});
    EXPECT_EQ(ended.variables.at(101), Content{});
}

TEST(Stepper, DivisionByZeroAlarmsAndUnreadableBlocksEndTheRun) {
    EXPECT_EQ(run_macro("#100=1/#1\nM30\n").how, Leaving::fault);
    EXPECT_EQ(run_macro("#100=[1+\nM30\n").how, Leaving::unreadable);
    EXPECT_EQ(run_macro("#3000=1(STOP)\nM30\n").how, Leaving::alarm);
    EXPECT_EQ(run_macro("#100=1\n").how, Leaving::runs_off);
}

TEST(Stepper, LinkedConditionsAreBothEvaluated) {
    const Ended ended = run_macro("IF[[1EQ1]AND[2EQ3]]THEN#100=1\nIF[[1EQ1]OR[2EQ3]]THEN#101=1\n"
                                  "IF[[1EQ1]XOR[2EQ2]]THEN#102=1\nM30\n");
    EXPECT_EQ(ended.variables.at(100), Content{});
    EXPECT_EQ(ended.variables.at(101), Content{1});
    EXPECT_EQ(ended.variables.at(102), Content{});
}

TEST(Stepper, AChoiceTakesOneBranch) {
    const std::string text = "IF #l1==1\nTHEN\n#g1=1\nELSE\n#g1=2\nENDIF\n#g2=3\nM30\n";
    EXPECT_EQ(run_din("MACHINING\n#l1=1\n" + text).variables.at(1), Content{1});
    const Ended other = run_din("MACHINING\n#l1=5\n" + text);
    EXPECT_EQ(other.variables.at(1), Content{2});
    EXPECT_EQ(other.variables.at(2), Content{3});
}

TEST(Stepper, ACaseFallsThroughWithoutBreakAndDefaultIsTakenLast) {
    const std::string text =
        "SWITCH #l1\nDEFAULT\n#g3=9\nBREAK\nCASE 1\n#g1=1\nCASE 2\n#g2=2\nBREAK\nCASE 3\n"
        "#g3=3\nBREAK\nENDSWITCH\n#g4=4\nM30\n";
    const Ended one = run_din("MACHINING\n#l1=1\n" + text);
    EXPECT_EQ(one.variables.at(1), Content{1});
    EXPECT_EQ(one.variables.at(2), Content{2});
    EXPECT_EQ(one.variables.at(3), Content{});
    EXPECT_EQ(one.variables.at(4), Content{4});
    const Ended seven = run_din("MACHINING\n#l1=7\n" + text);
    EXPECT_EQ(seven.variables.at(1), Content{});
    EXPECT_EQ(seven.variables.at(3), Content{9});
}

TEST(Stepper, AnUndefinedVariableEqualsZeroWhereTheControlSaysSo) {
    const Ended ended =
        run_din("MACHINING\nIF #l1==0\nTHEN\n#g1=1\nENDIF\nIF NDEF(l1)\nTHEN\n#g2=1\nENDIF\nM30\n");
    EXPECT_EQ(ended.variables.at(1), Content{1});
    EXPECT_EQ(run_macro("IF[#1EQ0]THEN#100=1\nM30\n").variables.at(100), Content{});
}

TEST(Stepper, WhatIsHandedDownIsTheCallers) {
    const Ended ended =
        run({{"main.nc", "VAR\n#_k=#l90(4)\nMACHINING\n#l1=1\nL\"S\" V1 LA5\n#g1=#l90\n#g2=#l1\nM30\n"},
             {"S.ncs", "MACHINING\n#l90=#l90+#__la\n#l1=8\nRETURN\n"}});
    EXPECT_EQ(ended.variables.at(1), Content{9});
    EXPECT_EQ(ended.variables.at(2), Content{1});
}

TEST(Stepper, WhatIsTypedInIsStored) {
    EXPECT_EQ(run_din("MACHINING\nINPUT(\"n\",#g1)\nM30\n").variables.at(1), Content{7});
    EXPECT_EQ(run_din("MACHINING\nM99\nM30\n").how, Leaving::restarts);
}

} // namespace
} // namespace maclint::execution
