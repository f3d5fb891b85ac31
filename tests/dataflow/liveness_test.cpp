//! Which stored values may still be read.
#include "analyzer/dataflow/facts/store.hpp"
#include "tests/support/analysed.hpp"
#include "tests/support/hand_built.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::analyse_fanuc;
using testing::ElementsAre;

/// For each store of the first program whether its value is live.
std::vector<bool> live_stores(const Workspace& workspace) {
    const ProgramAnalysis& analysis = workspace.programs().front();
    std::vector<bool> live;
    for (const auto& store : analysis.facts().all<dataflow::Store>())
        live.push_back(analysis.liveness().is_live_after(store.effect, store.variable));
    return live;
}
/// Of a program that is started by hand.
std::vector<bool> live_stores(const std::string& blocks) {
    return live_stores(*analyse_fanuc("O0001\n" + blocks + "\nM30\n"));
}

TEST(Liveness, AStoreThatIsReplacedUnreadIsDead) {
    EXPECT_THAT(live_stores("#1=1\n#1=2\nX#1"), ElementsAre(false, true));
    EXPECT_THAT(live_stores("#1=1\n#1=#1+1\nX#1"), ElementsAre(true, true));
    EXPECT_THAT(live_stores("#1=1\n#2=2\nX#1"), ElementsAre(true, false));
}

TEST(Liveness, AStoreThatOnePathReadsIsLive) {
    EXPECT_THAT(live_stores("#1=1\nIF[#500EQ1]GOTO9\nX#1\nN9"), ElementsAre(true));
    EXPECT_THAT(live_stores("#1=1\nIF[#500EQ1]GOTO9\n#1=2\nN9X#1"), ElementsAre(true, true));
    EXPECT_THAT(live_stores("#1=1\nIF[#500EQ1]GOTO8\n#1=2\nGOTO9\nN8#1=3\nN9X#1"),
                ElementsAre(false, true, true));
    EXPECT_THAT(live_stores("#1=1\nIF[#500EQ1]THEN#1=2\nX#1"), ElementsAre(true, true));
}

TEST(Liveness, TheNextPassOfALoopReads) {
    EXPECT_THAT(live_stores("WHILE[#500EQ1]DO1\nX#1\n#1=2\nEND1"), ElementsAre(true));
    EXPECT_THAT(live_stores("#1=0\nWHILE[#1LT5]DO1\n#1=#1+1\nEND1"), ElementsAre(true, true));
    EXPECT_THAT(live_stores("N1X#1\n#1=2\nGOTO1"), ElementsAre(true)) << "nothing ever leaves it";
}

TEST(Liveness, EveryKindOfBlockReads) {
    for (const std::string reads : {"X#1", "G#1", "F#1", "#500=#1", "#[#1]=5", "#500=#[#2]", "IF[#1EQ2]GOTO9",
                                    "GOTO#1", "M98P#1", "M98P2L#1", "G65P2A#1", "#3006=#1(LOOK)",
                                    "POPEN\nDPRNT[#1[53]]", "#5=SIN[#1]", "WHILE[#1EQ2]DO1\nEND1", "X[#1"})
        EXPECT_EQ(live_stores("#1=1\n" + reads + "\n#1=3\nN9").front(), true) << reads;
    for (const std::string does_not : {"X#2", "#2=1", "G65P2A#2", "IF[#2EQ1]GOTO9", "G1X1", "#500=#3901"})
        EXPECT_EQ(live_stores("#1=1\n" + does_not + "\n#1=3\nN9").front(), false) << does_not;
}

TEST(Liveness, CommonVariablesLiveOn) {
    EXPECT_THAT(live_stores("#100=1\n#500=1\n#1=1"), ElementsAre(true, true, false));
    EXPECT_THAT(live_stores("#100=1\n#1=1\n#3000=1(STOP)"), ElementsAre(true, false));
}

TEST(Liveness, ACalledProgramReadsWhatItSees) {
    EXPECT_THAT(live_stores("#100=1\nG65P2\n#100=2"), ElementsAre(true, true));
    EXPECT_THAT(live_stores("#1=1\nG65P2\n#1=2"), ElementsAre(false, false)) << "it has its own";
    EXPECT_THAT(live_stores("#1=1\nM98P2\n#1=2"), ElementsAre(true, false));
}

TEST(Liveness, AMoveReadsWhereAProgramMayRunAfterIt) {
    EXPECT_THAT(live_stores("#100=1\nX1\n#100=2"), ElementsAre(false, true));
    EXPECT_THAT(live_stores("G66P2\n#100=1\nX1\n#100=2"), ElementsAre(true, true));
    EXPECT_THAT(live_stores("G66P2\n#100=1\nX#3\n#100=2"), ElementsAre(true, true));
    EXPECT_THAT(live_stores("G66P2\n#100=1\nM5\n#100=2"), ElementsAre(false, true)) << "no move";
    EXPECT_THAT(live_stores("G65P2\n#100=1\nX1\n#100=2"), ElementsAre(true, true))
        << "O2 may have left a modal call";
    EXPECT_THAT(live_stores("M98P2\n#1=1\nX1\n#1=2\nX#1"), ElementsAre(false, true))
        << "what O2 has seen of the locals it does not see at the move";
}

TEST(Liveness, LocalsOfASubprogramBelongToItsCaller) {
    const auto in_called = [](const std::string& call) {
        return live_stores(*analyse_fanuc("O0002\n#1=1\nM99\nO0001\n" + call + "\nM30\n"));
    };
    EXPECT_THAT(in_called("M98P2"), ElementsAre(true));
    EXPECT_THAT(in_called("G65P2A1"), ElementsAre(false));
    EXPECT_THAT(in_called("G65P2A1\nM98P2"), ElementsAre(true)) << "one of the callers shares them";
    EXPECT_THAT(in_called("M5"), ElementsAre(true)) << "nobody knows the caller";
}

TEST(Liveness, WhatIsHandedDownIsReadByAllThatIsCalled) {
    const auto live = [](const std::string& text) {
        return live_stores(*test::analyse_files({{"main.nc", text}}, {.complete = false, .jobs = 1}));
    };
    // The first store is that of the definition.
    EXPECT_THAT(live("VAR\n#_k=#g1\n#_n=#l90(4)\nMACHINING\n#_n=1\nL\"S\" V1\n#_n=2\nG1 X#l90\nM30\n"),
                ElementsAre(false, true, true));
    EXPECT_THAT(live("MACHINING\n#l1=1\nL\"S\" V1\n#l1=2\nG1 X#l1\nM30\n"), ElementsAre(true, true))
        << "a caller may have handed it down";
    EXPECT_THAT(live("MACHINING\n#l1=1\nRETURN\n"), ElementsAre(true)) << "so it is the caller's";
}

TEST(Liveness, ANameAndWhatItStandsForAreOneVariable) {
    const auto live = [](const std::string& blocks) {
        return live_stores(*test::analyse_text("dinplus", "VAR\n#_d=#l1\nMACHINING\n" + blocks + "M30\n"));
    };
    EXPECT_THAT(live("#_d=1\nG1 X#l1\n#_d=2\n"), ElementsAre(true, false));
    EXPECT_THAT(live("#l1=1\n#_d=2\nG1 X#l1\n"), ElementsAre(false, true));
    EXPECT_THAT(live("#_d=1\n#_d=2\nG1 X#_d\n"), ElementsAre(false, true));
}

TEST(Liveness, AProgramThatBeginsAgainKeepsItsVariables) {
    EXPECT_THAT(live_stores(*test::analyse_text("dinplus", "MACHINING\nG1 X#__la\n#__la=1\nM99\n")),
                ElementsAre(true));
    EXPECT_THAT(live_stores(*test::analyse_text("dinplus", "MACHINING\nG1 X#__la\n#__la=1\nM30\n")),
                ElementsAre(false));
}

TEST(Liveness, AParameterByReferenceIsTheCallersVariable) {
    test::HandBuilt built("P.SPF", "PROC P(REAL A, VAR REAL B)\nA=1\nB=1\nRET\n");
    const Variable a = built.formal("A", VariableType::number, Passing::by_value);
    const Variable b = built.formal("B", VariableType::number, Passing::by_reference);
    built.block({});
    built.block({Assign{a, built.number(1)}});
    built.block({Assign{b, built.number(1)}});
    built.block({Return{}});
    test::HandBuilt main("MAIN.MPF", "P\nM30\n");
    main.block({main.call("P", {})});
    main.block({Stop{Stop::Kind::end, std::nullopt}});
    EXPECT_THAT(live_stores(*test::analyse({built.finish(), main.finish()}, {.complete = true, .jobs = 1})),
                ElementsAre(false, true));
}

TEST(Liveness, ANameThatProgramsShareMayMeanAnotherVariable) {
    test::HandBuilt built("MAIN.MPF", "ONE=1\nONE=2\nM30\n");
    const Variable one = built.variable(test::rows::shared, "ONE");
    built.block({Assign{one, built.number(1)}});
    built.block({Assign{one, built.number(2)}});
    built.block({Stop{Stop::Kind::end, std::nullopt}});
    EXPECT_THAT(live_stores(*test::analyse({built.finish()}, {.complete = true, .jobs = 1})),
                ElementsAre(true, true));
}

TEST(Liveness, WhatIsNotNamedMayBeRead) {
    const auto workspace = analyse_fanuc("O0001\n#1=1\nM30\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const auto& store = analysis.facts().all<dataflow::Store>().front();
    EXPECT_TRUE(analysis.liveness().is_live_after(store.effect, {store.variable.space, 7}));
}

TEST(Liveness, AChannelAloneReplacesNothing) {
    const auto live = [](const std::string& blocks) {
        return live_stores(*test::analyse_text("dinplus", "MACHINING\n" + blocks + "\nM30\n"));
    };
    EXPECT_THAT(live("#l1=1\n#l1=2\nG1 X#l1"), ElementsAre(false, true));
    EXPECT_THAT(live("$1$2 #l1=1\n$1 #l1=2\n$1$2 G1 X#l1").front(), true);
}

} // namespace
} // namespace maclint
