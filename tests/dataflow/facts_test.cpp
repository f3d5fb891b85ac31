//! Sets of types of facts, and what becomes of the types that nobody wants.
#include "analyzer/dataflow/facts/fact_lists.hpp"
#include "analyzer/dataflow/facts/point_state.hpp"
#include "tests/support/analysed.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using dataflow::facts;
using dataflow::FactSet;

static_assert(facts<>() == FactSet());
static_assert(facts<dataflow::Read>().has<dataflow::Read>() &&
              !facts<dataflow::Read>().has<dataflow::Store>());
static_assert((facts<dataflow::Read>() | facts<dataflow::Store>()) ==
              facts<dataflow::Store, dataflow::Read>());
static_assert(facts<dataflow::Read, dataflow::Store>() - facts<dataflow::Read, dataflow::Clobber>() ==
              facts<dataflow::Store>());
static_assert(FactSet::all().has<dataflow::Application>() && FactSet::all().has<dataflow::ExitState>());

std::unique_ptr<Workspace> recording(FactSet types) {
    return test::analyse_files({{"O1.nc", "O1\n#1=4001\nIF[#1EQ#500]GOTO[#500]\nN1G#1\nM6\nM30\n"}},
                               {.complete = true, .jobs = 1, .facts = types});
}

TEST(Facts, OfTypesThatNobodyWantsAreNotRecorded) {
    const auto some = recording(facts<dataflow::ModalWrite>());
    EXPECT_EQ(some->programs().front().facts().all<dataflow::ModalWrite>().size(), 1U);
    const auto ask = [&] { (void)some->programs().front().facts().all<dataflow::Condition>(); };
    EXPECT_DEATH(ask(), "recorded_.has<T>()");
}

TEST(Facts, StatesOfTheTypesThatAreWantedAreFoundByThemselves) {
    dataflow::FactLists lists;
    lists.add(dataflow::BeforeToolChange{{0, 0, {.root = 1}}});
    lists.add(dataflow::BeforeWatchedWord{{0, 0, {.root = 2}}});
    lists.add(dataflow::ExitState{{}, {.root = 3}});
    const auto roots = [&](FactSet types) {
        std::vector<dataflow::Root> all;
        lists.for_each_state(types, [&](const dataflow::State& state) { all.push_back(state.root); });
        return all;
    };
    EXPECT_THAT(roots(FactSet::all()), testing::UnorderedElementsAre(1, 2, 3));
    EXPECT_THAT(roots(facts<dataflow::ExitState, dataflow::Read>()), testing::ElementsAre(3));
}

TEST(Facts, StatesOfNodesAreKeptOnceForEachChange) {
    const auto nodes = [](const std::string& text) {
        const auto workspace = test::analyse_files(
            {{"O1.nc", text}}, {.complete = true, .jobs = 1, .facts = facts<dataflow::BeforeNode>()});
        std::vector<flow::NodeId> with_state;
        for (const auto& before : workspace->programs().front().facts().all<dataflow::BeforeNode>())
            with_state.push_back(before.node);
        return with_state;
    };
    EXPECT_THAT(nodes("O1\n#1=1\n#2=2\nG91\n#3=3\n#4=4\nM30\n"), testing::ElementsAre(0, 4));
    EXPECT_THAT(nodes("O1\n#1=1\nG91\nGOTO5\nG90\nN5#3=3\nM30\n"), testing::ElementsAre(0, 3));
    // What is known of the caller's code on one path is no state of a group.
    EXPECT_THAT(nodes("O1\nIF[#4002NE18]GOTO5\n#1=1\n#2=2\n#3=3\nN5M99\n"), testing::ElementsAre(0, 3));
}

/// The workspace itself needs some: what it finds out with them does not depend on what others want.
TEST(Facts, OfTypesThatSomebodyWantsAreTheSameWhateverElseIsWanted) {
    const auto all = recording(FactSet::all());
    const auto one = recording(facts<dataflow::ComputedJump>());
    const auto& recorded = all->programs().front().facts();
    EXPECT_EQ(recorded.all<dataflow::Condition>().size(), 1U);
    EXPECT_EQ(recorded.all<dataflow::BeforeToolChange>().size(), 1U);
    ASSERT_EQ(recorded.all<dataflow::ComputedJump>().size(), 1U);
    const auto alone = one->programs().front().facts().all<dataflow::ComputedJump>();
    ASSERT_EQ(alone.size(), 1U);
    EXPECT_EQ(alone[0].target, recorded.all<dataflow::ComputedJump>()[0].target);
}

TEST(Facts, AreFoundByVariableAndByValueInTheOrderOfTheText) {
    const auto workspace = test::analyse_fanuc("O1\n#2=#500\n#1=1\n#1=#500\n#3=#1\nM30\n");
    const dataflow::Facts& found = workspace->programs().front().facts();
    const auto stores = found.all<dataflow::Store>();
    ASSERT_EQ(stores.size(), 4U);
    EXPECT_THAT(found.about<dataflow::Store>(stores[1].variable),
                testing::ElementsAre(&stores[1], &stores[2]));
    EXPECT_THAT(found.with<dataflow::Store>(stores[0].value.symbol),
                testing::ElementsAre(&stores[0], &stores[2], &stores[3]));
    EXPECT_TRUE(found.about<dataflow::Store>({stores[1].variable.space, 33}).empty());
    EXPECT_TRUE(found.about<dataflow::Read>(stores[1].variable).size() == 1);
}

TEST(AskedFacts, AreThoseOfTheThreadSinceItWasToldToNoteThem) {
    const auto all = recording(FactSet::all());
    const dataflow::Facts& recorded = all->programs().front().facts();
    (void)recorded.all<dataflow::Read>();
    const dataflow::AskedFacts outer;
    EXPECT_EQ(outer.types(), FactSet());
    (void)recorded.in<dataflow::Store>(0);
    {
        const dataflow::AskedFacts inner;
        (void)recorded.at<dataflow::Comparison>(0);
        EXPECT_EQ(inner.types(), facts<dataflow::Comparison>());
    }
    EXPECT_EQ(outer.types(), facts<dataflow::Store>());
}

} // namespace
} // namespace maclint
