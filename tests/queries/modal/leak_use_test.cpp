//! What becomes of a modal state that a program leaves behind is searched for in its callers, and the search
//! ends.
#include "analyzer/program/builder.hpp"
#include "analyzer/program/tables.hpp"
#include "analyzer/queries/modal/leak_use.hpp"
#include "tests/support/analysed.hpp"
#include "tests/support/hand_built.hpp"

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace maclint {
namespace {

/// Whether somebody works under what the program leaves in the group at its return.
bool matters(const ProgramAnalysis& callee, GroupId group) {
    for (const dataflow::ExitState& exit : callee.facts().all<dataflow::ExitState>())
        if (exit.exit.kind == flow::ExitKind::returns)
            return queries::leak_use_of(callee, group, exit, 0).matters;
    throw std::runtime_error("it does not return");
}

/// Whether somebody works under the distance mode that O1 leaves.
bool matters_in(const std::string& callers) {
    const auto workspace = test::analyse_fanuc(callers + "O1\nG91\nM99\n");
    const ProgramAnalysis& callee = workspace->programs().back();
    for (const dataflow::GroupChange& change : callee.summary().groups) return matters(callee, change.group);
    throw std::runtime_error("O1 changes nothing");
}

TEST(LeakUse, AMoveAfterTheCallCounts) {
    EXPECT_TRUE(matters_in("O3\nG90\nM98P1\nG0X1.\nM30\n"));
    EXPECT_FALSE(matters_in("O3\nG90\nM98P1\nG90\nG0X1.\nM30\n"));
    EXPECT_TRUE(matters_in("O3\n#1=1\n#2=2\nM98P1\nG0X1.\nM30\n"));
}

TEST(LeakUse, ACallerThatCallsItselfIsAskedOnce) {
    EXPECT_FALSE(matters_in("O3\nG90G0X1.\nM98P2\nG90G0X1.\nM30\n"
                            "O2\nM98P1\nIF[#500GT5]GOTO9\nGOTO8\nN9 M99\nN8 M98P2\n"));
}

/// The same for the distance mode, with O1 called once and this after the call.
bool matters_behind_call(const std::string& blocks) {
    return matters_in("O3\nG90\nM98P1\n" + blocks + "M30\n");
}

TEST(LeakUse, PlainBlocksMoveAndSetInTheirOrder) {
    EXPECT_TRUE(matters_behind_call("G40\nX1.\nG90\n"));
    EXPECT_FALSE(matters_behind_call("G40\nG90X1.\nX2.\n"));
    EXPECT_FALSE(matters_behind_call("G40\n"));
}

TEST(LeakUse, WordsThatComputeMoveAndSetToo) {
    EXPECT_TRUE(matters_behind_call("X#500\n"));
    EXPECT_FALSE(matters_behind_call("G90X#500\nX1.\n"));
    EXPECT_FALSE(matters_behind_call("G#500\nX1.\n")); // it may be the word that sets it
    EXPECT_TRUE(matters_behind_call("M#500\nX1.\n"));  // of other letters none is
}

TEST(LeakUse, EveryBranchAfterTheCallIsLookedAt) {
    EXPECT_TRUE(matters_behind_call("IF[#500EQ1]GOTO5\nG90\nN5X1.\n"));
    EXPECT_FALSE(matters_behind_call("IF[#500EQ1]GOTO5\nG90\nGOTO6\nN5G90\nN6X1.\n"));
    EXPECT_FALSE(matters_behind_call("GOTO6\nX1.\nN6G90\nX2.\n")); // which no path reaches
}

TEST(LeakUse, ProgramsCalledAfterTheCallMoveOrSet) {
    const std::string caller = "O3\nG90\nM98P1\nM98P2\nX1.\nM30\n";
    EXPECT_TRUE(matters_in(caller + "O2\nX5.\nG90\nM99\n"));
    EXPECT_FALSE(matters_in(caller + "O2\nG90\nX5.\nM99\n"));
    EXPECT_TRUE(matters_in(caller + "O2\nG40\nM99\n"));
    EXPECT_FALSE(matters_behind_call("M98P77\nX1.\n")); // of an unknown program nothing is claimed
}

TEST(LeakUse, TheCallersOfTheCallerAreAskedWhenItReturns) {
    const std::string between = "O2\nM98P1\nM99\n";
    EXPECT_TRUE(matters_in("O3\nG90\nM98P2\nX1.\nM30\n" + between));
    EXPECT_FALSE(matters_in("O3\nG90\nM98P2\nG90\nX1.\nM30\n" + between));
    EXPECT_TRUE(matters_in("O3\nG90\nM98P2\nG90\nM30\nO4\nM98P2\nX1.\nM30\n" + between));
    EXPECT_TRUE(matters_in(between)); // it is unknown who calls O2
}

TEST(LeakUse, TheFirstBlockOfACalledProgramCounts) {
    const std::string caller = "O3\nG90\nM98P1\nM98P2\nM30\n";
    EXPECT_TRUE(matters_in(caller + "O2X#500\nG90\nM99\n"));
    EXPECT_FALSE(matters_in(caller + "O2G90X#500\nM99\n"));
}

TEST(LeakUse, AMacroThatIsOnlyMadeModalDoesNotRunYet) {
    EXPECT_TRUE(matters_behind_call("G66P77A1.\nX1.\n")); // the move comes before the macro
    EXPECT_FALSE(matters_behind_call("G66P77A1.\nG90X1.\n"));
    EXPECT_FALSE(matters_behind_call("G65P77A1.\nX1.\n"));
}

TEST(LeakUse, ASearchThatGetsTooLongProvesNothing) {
    const auto matters_after = [](std::size_t blocks) {
        std::string text;
        for (std::size_t i = 0; i < blocks; ++i) text += "#1=1\n";
        return matters_behind_call(text);
    };
    EXPECT_FALSE(matters_after(15'000));
    EXPECT_TRUE(matters_after(25'000));
}

/// A program in whose part of this kind a call of S stands, which leaves a modal group set.
bool matters_to_call_in(Section::Executed executed) {
    const std::string path = "MAIN.MPF";
    const auto source = std::make_shared<const Source>(Source::from_bytes(path, "S\nM30\n"));
    ProgramBuilder main("MAIN", source->bytes(), test::control_with_names());
    main.begin_section("first", executed, {});
    main.begin_block();
    main.add_effect({Call{Text{{0, 1}}, test::rows::by_name, {}, std::nullopt}, {0, 1}});
    Block first{};
    first.span = {0, 1};
    main.end_block(first);
    main.begin_section("second", Section::Executed::when_reached, {});
    main.begin_block();
    main.add_effect({Stop{Stop::Kind::end, std::nullopt}, {2, 5}});
    Block second{};
    second.span = {2, 5};
    main.end_block(second);
    auto file = std::make_shared<ProgramFile>();
    file->source = source;
    file->control = &test::control_with_names();
    file->programs.push_back(main.take());

    test::HandBuilt called("S.SPF", "DIAMON\nRET\n");
    called.block({SetModal{test::rows::diameter, called.number(2), 'G'}});
    called.block({Return{}});
    const auto workspace =
        test::analyse({{std::move(file), true}, called.finish()}, {.complete = true, .jobs = 1});
    return matters(workspace->programs().back(), test::rows::diameter);
}

TEST(LeakUse, NothingIsKnownOfACallThatNoProgramMakes) {
    EXPECT_FALSE(matters_to_call_in(Section::Executed::when_reached));
    EXPECT_TRUE(matters_to_call_in(Section::Executed::never));
}

/// Whether somebody works under the feed that O1 leaves.
bool feed_matters(const std::string& blocks) {
    const auto workspace = test::analyse_fanuc("O3\nG0F9\nM98P1\n" + blocks + "M30\nO1\nF100\nM99\n");
    const ProgramAnalysis& callee = workspace->programs().back();
    return matters(callee, *callee.control().group_with(ModalRole::feed));
}

TEST(LeakUse, AFeedMattersToMovesThatHaveOne) {
    EXPECT_TRUE(feed_matters("G1X1.\n"));
    EXPECT_FALSE(feed_matters("G0X1.\n"));
    EXPECT_TRUE(feed_matters("G0X1.\nG1X2.\n"));
    EXPECT_FALSE(feed_matters("G0X1.\nG1F50X2.\n"));
    EXPECT_FALSE(feed_matters("G0X#500\n"));
    EXPECT_TRUE(feed_matters("G0X#500\nG1X#500\n"));
    EXPECT_FALSE(feed_matters("G28X#500\n")); // at rapid traverse
}

/// Whether somebody works under the feed that O1 leaves, by whole programs.
bool feed_matters_in(const std::string& callers, const std::string& leaving) {
    const auto workspace = test::analyse_fanuc(callers + "O1\n" + leaving + "M99\n");
    const ProgramAnalysis& callee = workspace->programs().back();
    return matters(callee, *callee.control().group_with(ModalRole::feed));
}

TEST(LeakUse, TheMotionModeOfACalledProgramDecidesWhetherAMoveHasAFeed) {
    const std::string main = "O3\nG1F9\nM98P1\nM98P2\nX1.\nM30\n";
    EXPECT_FALSE(feed_matters_in(main + "O2\nG0\nM99\n", "F100\n"));
    EXPECT_TRUE(feed_matters_in(main + "O2\nG0\nG1\nM99\n", "F100\n"));
    EXPECT_TRUE(feed_matters_in(main + "O2\nIF[#500EQ1]GOTO5\nG0\nN5M99\n", "F100\n"));
    EXPECT_TRUE(feed_matters_in(main + "O2\nG0\nIF[#500EQ1]GOTO5\nG1\nN5M99\n", "F100\n"));
    EXPECT_TRUE(feed_matters_in(main + "O2\nG90\nM99\n", "F100\n"));
    // That of the program which leaves the feed counts, too.
    EXPECT_FALSE(feed_matters_in("O3\nG1F9\nM98P1\nX1.\nM30\n", "G0F100\n"));
    EXPECT_TRUE(feed_matters_in("O3\nG1F9\nM98P1\nG1X1.\nM30\n", "G0F100\n"));
}

TEST(LeakUse, AStateOfOneSlideIsNoneOfTheOther) {
    const auto matters_in_slides = [](const std::string& blocks) {
        const auto workspace = test::analyse_text(
            "dinplus", "MACHINING\n$1 N1 L\"S\"\n" + blocks + "$1$2 N9 M30\nSUBPROGRAM \"S\"\nG42\nRETURN\n");
        const ProgramAnalysis& callee = workspace->programs().back();
        return matters(callee, *callee.control().group_with(ModalRole::cutter_compensation));
    };
    EXPECT_TRUE(matters_in_slides("$1 N2 G0 X1\n"));
    EXPECT_TRUE(matters_in_slides("N2 G0 X1\n"));
    EXPECT_FALSE(matters_in_slides("$2 N2 G0 X1\n"));
    EXPECT_FALSE(matters_in_slides("$1 N2 G40\nN3 G0 X1\n"));
    EXPECT_TRUE(matters_in_slides("$2 N2 G40\nN3 G0 X1\n"));
}

/// What callers of O1, which leaves a feed, do with it.
queries::LeakUse use_of_feed(const std::string& callers, const std::string& leaving = "G1F100X1.\n") {
    static std::vector<std::unique_ptr<Workspace>> kept;
    const auto& workspace = *kept.emplace_back(test::analyse_fanuc(callers + "O1\n" + leaving + "M99\n"));
    const ProgramAnalysis& callee = workspace.programs().back();
    return queries::leak_use_of(callee, *callee.control().group_with(ModalRole::feed),
                                callee.facts().all<dataflow::ExitState>().front(), 0);
}

TEST(LeakUse, ACallerLosesWhatItHasSetItself) {
    EXPECT_TRUE(use_of_feed("O3\nG1F9X1.\nM98P1\nX2.\nM30\n").own_is_lost);
    EXPECT_TRUE(use_of_feed("O3\nG1F#500X1.\n#1=1\nM98P1\nX2.\nM30\n").own_is_lost);
    const queries::LeakUse relied_on = use_of_feed("O3\nM98P1\nX2.\nM30\n");
    EXPECT_TRUE(relied_on.program != nullptr && !relied_on.own_is_lost);
    EXPECT_FALSE(use_of_feed("O3\nGOTO5\nF9\nN5M98P1\nX2.\nM30\n").own_is_lost); // F9 is never reached
}

TEST(LeakUse, ACallerThatLosesItsOwnIsFoundAfterOneThatDoesNot) {
    const std::string relying = "M98P1\nX2.\nM30\n";
    EXPECT_TRUE(use_of_feed("O3\n" + relying + "O4\nG1F9\n" + relying).own_is_lost);
    EXPECT_TRUE(use_of_feed("O3\nG1F9\n" + relying + "O4\n" + relying).own_is_lost);
    EXPECT_TRUE(use_of_feed("O3\nG1F9\n" + relying + "O2\nM98P1\nM99\n").own_is_lost); // O2: who knows
}

TEST(LeakUse, SeveralCallersThatLoseNothingOfTheirOwnRelyOnItAllTheSame) {
    const std::string relying = "M98P1\nX2.\nM30\n";
    const queries::LeakUse use = use_of_feed("O3\n" + relying + "O4\n" + relying);
    EXPECT_TRUE(use.matters);
    EXPECT_FALSE(use.own_is_lost);
}

TEST(LeakUse, WhatAnotherCalledProgramMovesUnderIsNotTheCallers) {
    const queries::LeakUse use = use_of_feed("O3\nG1F9\nM98P1\nM98P2\nM30\nO2\nX5.\nM99\n");
    EXPECT_TRUE(use.matters);
    EXPECT_FALSE(use.own_is_lost);
}

} // namespace
} // namespace maclint
