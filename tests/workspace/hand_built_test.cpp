//! Flow, data flow and workspace over programs of a shape that no dialect has yet: named labels with a
//! direction, FOR, REPEAT … UNTIL, parameters by position and reference, types, shared names.
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dataflow/facts/store.hpp"
#include "analyzer/queries/loops/loop_counter.hpp"
#include "analyzer/workspace/program_analysis.hpp"
#include "tests/support/analysed.hpp"
#include "tests/support/hand_built.hpp"

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::HandBuilt;
using test::program;
using test::Step;
using testing::ElementsAre;
using testing::IsEmpty;
namespace rows = test::rows;
using Mark = RegionMark;
using Part = RegionMark::Part;

std::unique_ptr<Workspace> analyse(std::vector<WorkspaceFile> files) {
    return test::analyse(std::move(files), {.complete = true, .jobs = 1});
}

/// What a read of the variable on the line (from 1) is known to be.
dataflow::Value value_read(const ProgramAnalysis& analysis, Variable variable, std::uint32_t line) {
    for (const dataflow::Read& read : analysis.facts().all<dataflow::Read>())
        if (read.variable == variable && test::line_of_effect(analysis, read.effect) == line)
            return read.value;
    throw std::runtime_error("not read there");
}

/// The line to which the jump on a line leads; 0: it finds nothing.
std::uint32_t target_of(const ProgramAnalysis& analysis, std::uint32_t line) {
    for (const flow::ResolvedJump& jump : analysis.graph().jumps)
        if (test::line_of_effect(analysis, jump.jump) == line)
            return jump.target ? test::line_of(analysis, jump.target->block.begin) : 0;
    throw std::runtime_error("no jump there");
}

std::vector<std::uint32_t> unreached_lines(const ProgramAnalysis& analysis) {
    std::vector<std::uint32_t> lines;
    for (flow::NodeId node = 0; node < analysis.graph().nodes.size(); ++node)
        if (!analysis.data().reached(node))
            lines.push_back(test::line_of(analysis, analysis.graph().nodes[node].part.begin));
    return lines;
}

Mark open(RegionKind kind) { return {kind, Part::open, std::nullopt, std::nullopt}; }
Mark open(RegionKind kind, ExpressionId condition) { return {kind, Part::open, std::nullopt, condition}; }
Mark close(RegionKind kind) { return {kind, Part::close, std::nullopt, std::nullopt}; }
Mark close(RegionKind kind, ExpressionId condition) { return {kind, Part::close, std::nullopt, condition}; }

/// MARK stands before and after the jump, and the jump's own block is called AGAIN.
const ProgramAnalysis& jumping(std::unique_ptr<Workspace>& workspace, std::string_view label,
                               LabelSearch search, MissingLabel missing) {
    HandBuilt built("MAIN.MPF", "MARK: R1=0\n"
                                "MARK: R1=1\n"
                                "AGAIN: IF R2==1 GOTO\n"
                                "R1=2\n"
                                "MARK: R1=3\n"
                                "MARK: M30\n");
    const Variable r1{rows::r, 1};
    const Variable r2{rows::r, 2};
    built.labelled_block("MARK", {Assign{r1, built.number(0)}});
    built.labelled_block("MARK", {Assign{r1, built.number(1)}});
    built.labelled_block("AGAIN", {Step(built.apply(Operation::equal, {built.load(r2), built.number(1)}),
                                        Jump{built.name(label), search, missing})});
    built.block({Assign{r1, built.number(2)}});
    built.labelled_block("MARK", {Assign{r1, built.number(3)}});
    built.labelled_block("MARK", {Stop{Stop::Kind::end, std::nullopt}});
    workspace = analyse({built.finish()});
    return program(*workspace, "MAIN");
}

std::uint32_t target(std::string_view label, LabelSearch search) {
    std::unique_ptr<Workspace> workspace;
    return target_of(jumping(workspace, label, search, MissingLabel::alarm), 3);
}

TEST(NamedLabels, TheNearestInTheDirectionOfTheSearchIsTaken) {
    EXPECT_EQ(target("MARK", LabelSearch::forward), 5U);
    EXPECT_EQ(target("MARK", LabelSearch::backward), 2U);
    EXPECT_EQ(target("MARK", LabelSearch::forward_then_backward), 5U);
    EXPECT_EQ(target("MARK", LabelSearch::forward_then_top), 5U);
}

TEST(NamedLabels, AJumpBackCanMeanItsOwnBlockAndAJumpForwardCannot) {
    EXPECT_EQ(target("AGAIN", LabelSearch::backward), 3U);
    EXPECT_EQ(target("AGAIN", LabelSearch::forward), 0U);
    EXPECT_EQ(target("AGAIN", LabelSearch::forward_then_backward), 3U);
    EXPECT_EQ(target("AGAIN", LabelSearch::forward_then_top), 3U);
}

TEST(NamedLabels, ANameThatNoBlockBearsIsNotFound) {
    EXPECT_EQ(target("NOWHERE", LabelSearch::forward_then_backward), 0U);
}

/// An unconditional jump over the assignment to R1 on line 2.
std::vector<std::uint32_t> unreached_after(std::string_view label, MissingLabel missing) {
    HandBuilt built("MAIN.MPF", "GOTOC\nR1=1\nTHERE: M30\n");
    built.block({Jump{built.name(label), LabelSearch::forward_then_backward, missing}});
    built.block({Assign{Variable{rows::r, 1}, built.number(1)}});
    built.labelled_block("THERE", {Stop{Stop::Kind::end, std::nullopt}});
    return unreached_lines(program(*analyse({built.finish()}), "MAIN"));
}

TEST(NamedLabels, AJumpThatNeedNotFindItsLabelGoesOnWithoutIt) {
    EXPECT_THAT(unreached_after("THERE", MissingLabel::skip), ElementsAre(2));
    EXPECT_THAT(unreached_after("NOWHERE", MissingLabel::skip), IsEmpty());
    EXPECT_THAT(unreached_after("NOWHERE", MissingLabel::alarm), ElementsAre(2, 3));
}

TEST(NamedLabels, ABlockIsFoundByItsNumberAndByItsName) {
    HandBuilt built("MAIN.MPF", "GOTOF 40\nGOTOF THERE\nN40 THERE: M30\n");
    built.block({Step(built.apply(Operation::less, {built.load({rows::r, 1}), built.number(1)}),
                      Jump{built.number(40), LabelSearch::forward, MissingLabel::alarm})});
    built.block({Jump{built.name("THERE"), LabelSearch::forward, MissingLabel::alarm}});
    built.labelled_block(40, "THERE", {Stop{Stop::Kind::end, std::nullopt}});
    const auto workspace = analyse({built.finish()});
    EXPECT_EQ(target_of(program(*workspace, "MAIN"), 1), 3U);
    EXPECT_EQ(target_of(program(*workspace, "MAIN"), 2), 3U);
}

/// The lines to which a jump on line 2 can lead whose target only the running program knows.
std::vector<std::uint32_t> computed_targets(LabelSearch search) {
    HandBuilt built("MAIN.MPF", "N10 FIRST: R1=0\nIF R1==1 GOTO R2\nN20 LAST: M30\n");
    const Variable r1{rows::r, 1};
    built.labelled_block(10, "FIRST", {Assign{r1, built.load({rows::r, 3})}});
    built.block({Step(built.apply(Operation::equal, {built.load(r1), built.number(1)}),
                      Jump{built.load({rows::r, 2}), search, MissingLabel::alarm})});
    built.labelled_block(20, "LAST", {Stop{Stop::Kind::end, std::nullopt}});
    const auto workspace = analyse({built.finish()});
    const ProgramAnalysis& main = program(*workspace, "MAIN");
    std::set<std::uint32_t> lines;
    for (const flow::LabelledBlock& target : main.targets_of(main.graph().jumps.at(0)))
        lines.insert(test::line_of(main, target.block.begin));
    return {lines.begin(), lines.end()};
}

TEST(NamedLabels, AComputedJumpLeadsOnlyWhereItsSearchLooks) {
    EXPECT_THAT(computed_targets(LabelSearch::backward), ElementsAre(1));
    EXPECT_THAT(computed_targets(LabelSearch::forward), ElementsAre(3));
    EXPECT_THAT(computed_targets(LabelSearch::forward_then_backward), ElementsAre(1, 3));
}

TEST(UntilLoop, RunsOnceAndEndsWhenItsConditionIsTrue) {
    // X is 2, 4, 6, 8 at the test: after the loop it is at least 8.
    HandBuilt built("MAIN.MPF", "DEF INT X\nREPEAT\nX=X+2\nUNTIL X>=8\nR1=X\nM30\n");
    const Variable x = built.declare("X", VariableType::integer);
    built.block({});
    built.block({open(RegionKind::until_loop)});
    built.block({Assign{x, built.apply(Operation::add, {built.load(x), built.number(2)})}});
    built.block({close(RegionKind::until_loop,
                       built.apply(Operation::greater_equal, {built.load(x), built.number(8)}))});
    built.block({Assign{Variable{rows::r, 1}, built.load(x)}});
    built.block({Stop{Stop::Kind::end, std::nullopt}});
    const auto workspace = analyse({built.finish()});
    const ProgramAnalysis& main = program(*workspace, "MAIN");
    EXPECT_EQ(value_read(main, x, 3).low, 0);
    EXPECT_LT(value_read(main, x, 3).high, 8);
    EXPECT_EQ(value_read(main, x, 5).low, 8);
    EXPECT_LE(value_read(main, x, 5).high, 10);
    ASSERT_EQ(main.loops().size(), 1U);
    EXPECT_EQ(test::line_of(main, main.graph().nodes[main.loops().front().head].part.begin), 2U);
    EXPECT_TRUE(main.loops().front().region.has_value());
    EXPECT_TRUE(main.inescapable_cycles().empty());
    // The way on from the condition is one that it decides, and no jump.
    const auto& edges = main.graph().edges;
    const auto on =
        std::ranges::find_if(edges, [](const flow::Edge& edge) { return edge.condition && edge.holds; });
    ASSERT_NE(on, edges.end());
    EXPECT_EQ(on->kind, flow::EdgeKind::branch);
    EXPECT_EQ(test::line_of(main, main.graph().nodes[on->to].part.begin), 5U);
}

TEST(UntilLoop, WhoseConditionIsNeverTrueIsNeverLeft) {
    HandBuilt built("MAIN.MPF", "REPEAT\nR1=1\nUNTIL R1==2\nM30\n");
    const Variable r1{rows::r, 1};
    built.block({open(RegionKind::until_loop)});
    built.block({Assign{r1, built.number(1)}});
    built.block(
        {close(RegionKind::until_loop, built.apply(Operation::equal, {built.load(r1), built.number(2)}))});
    built.block({Stop{Stop::Kind::end, std::nullopt}});
    const auto workspace = analyse({built.finish()});
    EXPECT_THAT(unreached_lines(program(*workspace, "MAIN")), ElementsAre(4));
    EXPECT_EQ(program(*workspace, "MAIN").inescapable_cycles().size(), 1U);
}

TEST(CountingLoop, CountsFromItsStartToItsEnd) {
    // FOR N=1 TO 3: the start value before the head, the step before ENDFOR.
    HandBuilt built("MAIN.MPF", "DEF INT N\nFOR N=1 TO 3\nR1=N\nENDFOR\nR2=N\nM30\n");
    const Variable n = built.declare("N", VariableType::integer);
    built.block({});
    built.block({Assign{n, built.number(1)},
                 open(RegionKind::counting_loop,
                      built.apply(Operation::less_equal, {built.load(n), built.number(3)}))});
    built.block({Assign{Variable{rows::r, 1}, built.load(n)}});
    built.block({Assign{n, built.apply(Operation::add, {built.load(n), built.number(1)})},
                 close(RegionKind::counting_loop)});
    built.block({Assign{Variable{rows::r, 2}, built.load(n)}});
    built.block({Stop{Stop::Kind::end, std::nullopt}});
    const auto workspace = analyse({built.finish()});
    const ProgramAnalysis& main = program(*workspace, "MAIN");
    EXPECT_EQ(value_read(main, n, 3).low, 1);
    EXPECT_EQ(value_read(main, n, 3).high, 3);
    EXPECT_EQ(value_read(main, n, 5).constant(), 4);
    ASSERT_EQ(main.loops().size(), 1U);
    const auto counter = queries::counter_of(main, main.loops().front());
    ASSERT_TRUE(counter.has_value());
    EXPECT_EQ(counter->variable, n);
}

TEST(CountingLoop, IsNotClosedByTheWordThatClosesAnotherLoop) {
    HandBuilt built("MAIN.MPF", "FOR\nUNTIL\nM30\n");
    built.block({open(RegionKind::counting_loop, built.number(1))});
    built.block({close(RegionKind::until_loop, built.number(1))});
    built.block({Stop{Stop::Kind::end, std::nullopt}});
    const auto workspace = analyse({built.finish()});
    const flow::Regions& regions = program(*workspace, "MAIN").regions();
    EXPECT_FALSE(regions.all.front().close.has_value());
    // One cause, one fault: the close may be meant for the loop.
    ASSERT_EQ(regions.faults.size(), 1U);
    EXPECT_EQ(regions.faults.front().what, flow::Imbalance::never_closed);
    EXPECT_EQ(regions.faults.front().other, EffectId{1});
}

/// PROC P(REAL A, VAR INT B), which stores 5.4 in both.
WorkspaceFile procedure() {
    HandBuilt built("P.SPF", "PROC P(REAL A, VAR INT B)\nR1=A\nA=5.4\nB=5.4\nRET\n");
    const Variable a = built.formal("A", VariableType::number, Passing::by_value);
    const Variable b = built.formal("B", VariableType::integer, Passing::by_reference);
    built.block({});
    built.block({Assign{Variable{rows::r, 1}, built.load(a)}});
    built.block({Assign{a, built.number(5.4)}});
    built.block({Assign{b, built.number(5.4)}});
    built.block({Return{}});
    return built.finish();
}

/// Calls P(X, N) with X=2 and N=1, and reads both.
struct Calling {
    Variable x{}, n{};
    WorkspaceFile file;
};
Calling caller(std::string_view callee,
               std::pair<decltype(Argument::given), decltype(Argument::given)> given) {
    HandBuilt built("MAIN.MPF",
                    "DEF REAL X=2\nDEF INT N=1\n" + std::string(callee) + "(X,N)\nR2=X\nR3=N\nM30\n");
    Calling calling;
    calling.x = built.declare("X", VariableType::number);
    calling.n = built.declare("N", VariableType::integer);
    built.block({Assign{calling.x, built.number(2)}});
    built.block({Assign{calling.n, built.number(1)}});
    built.block({built.call(callee, {{given.first, built.load(calling.x), "", {}, Passing::as_declared},
                                     {given.second, built.load(calling.n), "", {}, Passing::as_declared}})});
    built.block({Assign{Variable{rows::r, 2}, built.load(calling.x)}});
    built.block({Assign{Variable{rows::r, 3}, built.load(calling.n)}});
    built.block({Stop{Stop::Kind::end, std::nullopt}});
    calling.file = built.finish();
    return calling;
}

const std::pair<decltype(Argument::given), decltype(Argument::given)> in_order{ArgumentPosition{0},
                                                                               ArgumentPosition{1}};

TEST(Parameters, WhatIsStoredInAReferenceIsStoredInTheCallersVariable) {
    Calling calling = caller("P", in_order);
    const auto workspace = analyse({calling.file, procedure()});
    const ProgramAnalysis& main = program(*workspace, "MAIN");
    EXPECT_EQ(value_read(main, calling.x, 4).constant(), 2); // by value: P has a copy
    EXPECT_EQ(value_read(main, calling.n, 5).constant(), 5); // 5.4 in an INT
}

TEST(Parameters, WhatIsStoredInAReferenceIsStoredInTheVariableThatAnIndexNames) {
    HandBuilt built("MAIN.MPF", "R5=1 R1=5\nP(0,R[R1])\nR2=R5\nM30\n");
    const Variable r1{rows::r, 1};
    const Variable r5{rows::r, 5};
    built.block({Assign{r5, built.number(1)}, Assign{r1, built.number(5)}});
    built.block({built.call(
        "P", {{ArgumentPosition{0}, built.number(0), "", {}, Passing::as_declared},
              {ArgumentPosition{1}, built.load_at(built.load(r1)), "", {}, Passing::as_declared}})});
    built.block({Assign{Variable{rows::r, 2}, built.load(r5)}});
    built.block({Stop{Stop::Kind::end, std::nullopt}});
    const auto workspace = analyse({built.finish(), procedure()});
    EXPECT_FALSE(value_read(program(*workspace, "MAIN"), r5, 3).constant());
}

TEST(Parameters, ArgumentsCanBeGivenByName) {
    Calling calling = caller("P", {std::string_view("A"), std::string_view("B")});
    const auto workspace = analyse({calling.file, procedure()});
    EXPECT_EQ(value_read(program(*workspace, "MAIN"), calling.n, 5).constant(), 5);
    EXPECT_EQ(value_read(program(*workspace, "MAIN"), calling.x, 4).constant(), 2);
}

TEST(Parameters, AnUnknownProgramMayStoreInWhatItIsGiven) {
    Calling calling = caller("Q", in_order);
    const auto workspace = analyse({calling.file});
    EXPECT_FALSE(value_read(program(*workspace, "MAIN"), calling.x, 4).constant());
    EXPECT_FALSE(value_read(program(*workspace, "MAIN"), calling.n, 5).constant());
}

TEST(Parameters, OneThatEveryCallLeavesOutIsZero) {
    HandBuilt built("MAIN.MPF", "P()\nM30\n");
    built.block({built.call("P", {})});
    built.block({Stop{Stop::Kind::end, std::nullopt}});
    const auto workspace = analyse({built.finish(), procedure()});
    const ProgramAnalysis& p = program(*workspace, "P");
    EXPECT_EQ(value_read(p, p.program().formals.front().variable, 2).constant(), 0);
}

TEST(Parameters, OneThatIsPassedCanBeAnything) {
    Calling calling = caller("P", in_order);
    const auto workspace = analyse({calling.file, procedure()});
    const ProgramAnalysis& p = program(*workspace, "P");
    EXPECT_FALSE(value_read(p, p.program().formals.front().variable, 2).constant());
}

TEST(DeclaredVariables, HoldWhatTheirTypeCanHold) {
    HandBuilt built("MAIN.MPF", "DEF INT I\nDEF BOOL B\nI=2.6\nB=7\nI=R5\nR1=I+B\nM30\n");
    const Variable i = built.declare("I", VariableType::integer);
    const Variable b = built.declare("B", VariableType::truth);
    built.block({});
    built.block({});
    built.block({Assign{i, built.number(2.6)}});
    built.block({Assign{b, built.number(7)}});
    built.block({Assign{i, built.load({rows::r, 5})}});
    built.block({Assign{Variable{rows::r, 1}, built.apply(Operation::add, {built.load(i), built.load(b)})}});
    built.block({Stop{Stop::Kind::end, std::nullopt}});
    const auto workspace = analyse({built.finish()});
    const ProgramAnalysis& main = program(*workspace, "MAIN");
    EXPECT_EQ(main.facts().all<dataflow::Store>()[0].variable, i);
    EXPECT_EQ(main.facts().all<dataflow::Store>()[0].value.constant(), 3);
    EXPECT_EQ(value_read(main, b, 6).constant(), 1);
    EXPECT_TRUE(value_read(main, i, 6).integer);
    EXPECT_FALSE(value_read(main, i, 6).constant());
}

TEST(DeclaredVariables, WhatIsNotZeroMayBeRoundedToZero) {
    HandBuilt built("P.SPF", "IF A==0 GOTOF DONE\nI=A\nR1=I\nDONE: RET\n");
    const Variable i = built.declare("I", VariableType::integer);
    const Variable a = built.formal("A", VariableType::number, Passing::by_value);
    built.block({Step(built.apply(Operation::equal, {built.load(a), built.number(0)}),
                      Jump{built.name("DONE"), LabelSearch::forward, MissingLabel::alarm})});
    built.block({Assign{i, built.load(a)}});
    built.block({Assign{Variable{rows::r, 1}, built.load(i)}});
    built.labelled_block("DONE", {Return{}});
    const auto workspace = analyse({built.finish()});
    const ProgramAnalysis& p = program(*workspace, "P");
    EXPECT_FALSE(value_read(p, a, 2).can_be(0));
    EXPECT_TRUE(value_read(p, i, 3).can_be(0)); // 0.4 becomes 0
}

TEST(DeclaredVariables, AnInitialValueIsReadUntilSomethingIsStored) {
    HandBuilt built("MAIN.MPF", "DEF INT I=4\nR1=I\nM30\n");
    const Variable i = built.declare("I", VariableType::integer, 4);
    built.block({});
    built.block({Assign{Variable{rows::r, 1}, built.load(i)}});
    built.block({Stop{Stop::Kind::end, std::nullopt}});
    const auto workspace = analyse({built.finish()});
    EXPECT_EQ(value_read(program(*workspace, "MAIN"), i, 2).constant(), 4);
}

/// MAIN stores 1 in `first`, calls S, which stores 9 in `second`, and reads `first`.
dataflow::Value after_call(std::string_view first, std::string_view second) {
    HandBuilt sub("S.SPF", "OTHER=0\nX=9\nRET\n");
    sub.block({Assign{sub.variable(rows::shared, "OTHER_FIRST"), sub.number(0)}});
    sub.block({Assign{sub.variable(rows::shared, second), sub.number(9)}});
    sub.block({Return{}});
    HandBuilt main("MAIN.MPF", "X=1\nS\nR1=X\nM30\n");
    const Variable x = main.variable(rows::shared, first);
    main.block({Assign{x, main.number(1)}});
    main.block({main.call("S", {})});
    main.block({Assign{Variable{rows::r, 1}, main.load(x)}});
    main.block({Stop{Stop::Kind::end, std::nullopt}});
    const auto workspace = analyse({main.finish(), sub.finish()});
    return value_read(program(*workspace, "MAIN"), x, 3);
}

TEST(SharedNames, ANameMeansTheSameVariableInEveryProgram) {
    EXPECT_EQ(after_call("DEPTH", "DEPTH").constant(), 9);
    EXPECT_EQ(after_call("DEPTH", "WIDTH").constant(), 1);
}

TEST(SharedNames, AnAlarmThatAVariableOfSuchANameDecidesMayEndALoop) {
    // MAIN calls S in a loop that changes R1 alone; S ends in an alarm where R5, or LIMIT, is above 3.
    const auto can_stop = [](bool by_name) {
        HandBuilt sub("S.SPF", "IF LIMIT>3 SETAL\nRET\n");
        const Variable limit = by_name ? sub.variable(rows::shared, "LIMIT") : Variable{rows::r, 5};
        sub.block({Step(sub.apply(Operation::greater, {sub.load(limit), sub.number(3)}),
                        Stop{Stop::Kind::alarm, std::nullopt})});
        sub.block({Return{}});
        HandBuilt main("MAIN.MPF", "WHILE R1<9\nR1=R1+1\nS\nENDWHILE\nM30\n");
        const Variable r1{rows::r, 1};
        main.block(
            {open(RegionKind::while_loop, main.apply(Operation::less, {main.load(r1), main.number(9)}))});
        main.block({Assign{r1, main.apply(Operation::add, {main.load(r1), main.number(1)})}});
        main.block({main.call("S", {})});
        main.block({close(RegionKind::while_loop)});
        main.block({Stop{Stop::Kind::end, std::nullopt}});
        const auto workspace = analyse({main.finish(), sub.finish()});
        return program(*workspace, "MAIN").loops().at(0).can_stop;
    };
    EXPECT_TRUE(
        can_stop(true)); // each program has numbers of its own for its names: which it is is not known
    EXPECT_FALSE(can_stop(false));
}

TEST(SharedNames, NothingIsKnownOfNamesThatMeetInOneNumber) {
    std::map<std::int32_t, std::string> seen;
    for (int i = 0; i < 1'000'000; ++i) {
        SharedNames names;
        const std::string name = "GUD_" + std::to_string(i);
        const auto [other, is_new] = seen.try_emplace(names.number_of(name), name);
        if (is_new) continue;
        EXPECT_FALSE(after_call(name, other->second).constant());
        return;
    }
    FAIL() << "no two names meet";
}

TEST(ModalMembers, AreSpelledByTheirNames) {
    EXPECT_EQ(test::control_with_names().spell(rows::diameter, 2), "DIAMON");
    EXPECT_EQ(test::control_with_names().group_of('G', 1), std::nullopt); // DIAMOF is no G1
}

} // namespace
} // namespace maclint
