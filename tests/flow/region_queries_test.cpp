//! Which loop a place stands in, which one a jump enters, and what belongs to what.
#include "tests/support/analysed.hpp"
#include "tests/support/hand_built.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using flow::Imbalance;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

/// A program of one file; places in it are named by what stands there.
class RegionQueries : public testing::Test {
  protected:
    void read(std::string_view dialect, std::string text) {
        text_ = std::move(text);
        workspace_ = test::analyse_text(dialect, text_);
    }
    [[nodiscard]] const ProgramAnalysis& analysis() const { return workspace_->programs().front(); }
    [[nodiscard]] const flow::Regions& regions() const { return analysis().regions(); }
    [[nodiscard]] Offset at(const std::string& block) const { return static_cast<Offset>(text_.find(block)); }
    /// Line of a loop or choice; 0: there is none.
    [[nodiscard]] std::uint32_t line_of(std::optional<flow::RegionId> region) const {
        return region ? test::line_of_effect(analysis(), regions().all[*region].open) : 0;
    }
    [[nodiscard]] std::uint32_t around(const std::string& block) const {
        return line_of(regions().loop_around(analysis().program(), at(block)));
    }
    [[nodiscard]] std::uint32_t entered(const std::string& from, const std::string& to) const {
        return line_of(regions().entered(analysis().program(), at(from), at(to)));
    }
    /// Line of each fault, and of its partner; 0: it has none.
    [[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> partners() const {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> lines;
        for (const flow::RegionFault& fault : regions().faults)
            lines.emplace_back(test::line_of_effect(analysis(), fault.effect),
                               fault.other ? test::line_of_effect(analysis(), *fault.other) : 0);
        return lines;
    }
    [[nodiscard]] std::vector<Imbalance> faults() const {
        std::vector<Imbalance> all;
        for (const flow::RegionFault& fault : regions().faults) all.push_back(fault.what);
        return all;
    }

  private:
    std::string text_;
    std::unique_ptr<Workspace> workspace_;
};

constexpr auto* two_loops = "N1 #9=1\nN2 WHILE[#1LT5]DO1\nN3 #1=#1+1\nN4 WHILE[#2LT5]DO2\nN5 #2=#2+1\n"
                            "N6 END2\nN7 #3=1\nN8 END1\nN9 M30\n";

TEST_F(RegionQueries, AJumpEntersTheOutermostLoopThatDidNotHoldItBefore) {
    read("fanuc", two_loops);
    EXPECT_EQ(entered("N1", "N5"), 2U);
    EXPECT_EQ(entered("N9", "N5"), 2U);
    EXPECT_EQ(entered("N1", "N3"), 2U);
    EXPECT_EQ(entered("N3", "N5"), 4U);
    EXPECT_EQ(entered("N7", "N6"), 4U);
}

TEST_F(RegionQueries, AJumpWithinALoopOrToItsHeadOrOutOfItEntersNone) {
    read("fanuc", two_loops);
    EXPECT_EQ(entered("N5", "N3"), 0U);
    EXPECT_EQ(entered("N5", "N9"), 0U);
    EXPECT_EQ(entered("N3", "N8"), 0U);
    EXPECT_EQ(entered("N1", "N2"), 0U);
    EXPECT_EQ(entered("N3", "N4"), 0U);
}

TEST_F(RegionQueries, ALoopThatIsNeverClosedHoldsNothing) {
    read("fanuc", "N1 WHILE[#1LT5]DO1\nN2 WHILE[#2LT5]DO2\nN3 #1=1\nN4 END1\nN5 M30\n");
    EXPECT_FALSE(regions().holds(analysis().program(), 1, at("N3")));
    EXPECT_TRUE(regions().holds(analysis().program(), 0, at("N3")));
    EXPECT_EQ(around("N3"), 1U);
    EXPECT_EQ(around("N5"), 0U);
    EXPECT_EQ(entered("N5", "N3"), 1U);
}

TEST_F(RegionQueries, ALoopHoldsWhatStandsAfterItsDoUpToTheLastByteOfItsEnd) {
    read("fanuc", "N1 WHILE[#1LT5]DO1\nN2 #1=1\nN3 END1\nN4 M30\n");
    const auto holds = [&](Offset offset) { return regions().holds(analysis().program(), 0, offset); };
    EXPECT_FALSE(holds(at("DO1") + 2));
    EXPECT_TRUE(holds(at("DO1") + 3));
    EXPECT_TRUE(holds(at("END1") + 3));
    EXPECT_FALSE(holds(at("END1") + 4));
}

TEST_F(RegionQueries, AChoiceIsNoLoop) {
    read("dinplus", "MACHINING\nN1 WHILE #l1<5\nN2 IF #l2>3\nN3 THEN\nN4 #l1=#l1+1\nN5 ENDIF\nN6 ENDWHILE\n"
                    "N7 M30\n");
    EXPECT_EQ(around("N4"), 2U);
    EXPECT_EQ(around("N7"), 0U);
    EXPECT_EQ(regions().all[1].closed_around, flow::RegionId{0});
    EXPECT_EQ(regions().all[0].closed_around, std::nullopt);
}

TEST_F(RegionQueries, EachKnowsTheLoopAroundItThatIsClosed) {
    read("fanuc",
         "WHILE[#1LT5]DO1\nWHILE[#2LT5]DO2\nWHILE[#3LT5]DO3\nEND3\nEND1\nWHILE[#4LT5]DO3\nEND3\nM30\n");
    ASSERT_EQ(regions().all.size(), 4U);
    EXPECT_EQ(regions().all[2].parent, flow::RegionId{1});
    EXPECT_EQ(regions().all[2].closed_around, flow::RegionId{0});
    EXPECT_EQ(regions().all[1].closed_around, flow::RegionId{0});
    EXPECT_EQ(regions().all[3].parent, std::nullopt);
    EXPECT_EQ(regions().all[3].closed_around, std::nullopt);
}

TEST_F(RegionQueries, WhatOpensDividesAndClosesAChoiceBelongsToIt) {
    read("dinplus", "MACHINING\nIF #l1>3\nTHEN\n#l2=1\nELSE\n#l2=2\nENDIF\nM30\n");
    const Program& program = analysis().program();
    ASSERT_EQ(regions().all.size(), 1U);
    EXPECT_EQ(regions().all.front().parts.size(), 2U);
    for (EffectId id = 0; id < program.effects.size(); ++id)
        EXPECT_EQ(regions().with(id).has_value(),
                  std::holds_alternative<RegionMark>(program.effects[id].what));
    EXPECT_FALSE(regions().with(1000).has_value());
}

TEST_F(RegionQueries, BothLoopsOfACrossingAreCrossedAndNoOther) {
    read("fanuc", "WHILE[#1LT5]DO1\nWHILE[#2LT5]DO2\nEND1\nEND2\nWHILE[#3LT5]DO3\nEND3\nM30\n");
    ASSERT_EQ(regions().all.size(), 3U);
    EXPECT_TRUE(regions().all[0].crossed);
    EXPECT_TRUE(regions().all[1].crossed);
    EXPECT_FALSE(regions().all[2].crossed);
    EXPECT_THAT(faults(), ElementsAre(Imbalance::crossed));
    EXPECT_THAT(partners(), ElementsAre(Pair(3, 2)));
}

TEST_F(RegionQueries, ALoopMayCrossAChoice) {
    read("dinplus", "MACHINING\nWHILE #l1<5\nIF #l2>3\nTHEN\nENDWHILE\nENDIF\nM30\n");
    EXPECT_THAT(faults(), ElementsAre(Imbalance::crossed));
    EXPECT_THAT(partners(), ElementsAre(Pair(5, 3)));
}

TEST_F(RegionQueries, AFaultKnowsItsPartner) {
    read("fanuc", "WHILE[#1LT5]DO1\nWHILE[#2LT5]DO2\nWHILE[#3LT5]DO1\nEND1\nEND2\nEND1\nM30\n");
    EXPECT_THAT(faults(), ElementsAre(Imbalance::number_reused));
    EXPECT_THAT(partners(), ElementsAre(Pair(3, 1)));
    read("fanuc", "WHILE[#1LT5]DO1\nEND2\nM30\n");
    EXPECT_THAT(faults(), ElementsAre(Imbalance::never_closed));
    EXPECT_THAT(partners(), ElementsAre(Pair(1, 2)));
    // The last one opened is the first to be closed.
    read("fanuc", "WHILE[#1LT5]DO1\nWHILE[#2LT5]DO2\nEND3\nEND3\nM30\n");
    EXPECT_THAT(faults(), ElementsAre(Imbalance::never_closed, Imbalance::never_closed));
    EXPECT_THAT(partners(), ElementsAre(Pair(1, 4), Pair(2, 3)));
}

TEST_F(RegionQueries, AnEndIsMeantForNoLoopThatComesAfterIt) {
    read("fanuc", "#1=1\nEND2\nWHILE[#1LT5]DO1\nM30\n");
    EXPECT_THAT(faults(), ElementsAre(Imbalance::never_opened, Imbalance::never_closed));
    EXPECT_THAT(partners(), ElementsAre(Pair(2, 0), Pair(3, 0)));
}

TEST_F(RegionQueries, ANumberOutOfRangeIsReportedOnce) {
    read("fanuc", "DO4\n#1=1\nM30\n");
    EXPECT_THAT(faults(), ElementsAre(Imbalance::number_out_of_range));
    read("fanuc", "WHILE[#1LT5]DO3\nEND3\nM30\n");
    EXPECT_THAT(faults(), IsEmpty());
    read("fanuc", "WHILE[#1LT5]\n#1=1\nM30\n"); // that it lacks its DO is reported elsewhere
    EXPECT_THAT(faults(), IsEmpty());
}

TEST_F(RegionQueries, WordsOfAChoiceThatIsNotThereAreFaults) {
    read("dinplus", "MACHINING\n#l1=1\nELSE\n#l1=2\nENDIF\nM30\n");
    EXPECT_THAT(faults(), ElementsAre(Imbalance::never_opened, Imbalance::never_opened));
    EXPECT_THAT(partners(), ElementsAre(Pair(3, 0), Pair(5, 0)));
    read("dinplus", "MACHINING\nIF #l1>3\nTHEN\n#l1=2\nM30\n");
    EXPECT_THAT(faults(), ElementsAre(Imbalance::never_closed));
    // An ENDIF is not meant for a loop, nor an ENDWHILE for a choice.
    read("dinplus", "MACHINING\nWHILE #l1<5\n#l1=2\nENDIF\nM30\n");
    EXPECT_THAT(faults(), ElementsAre(Imbalance::never_closed, Imbalance::never_opened));
}

TEST_F(RegionQueries, UnitsStandOneAfterTheOther) {
    const std::string begin = "UNIT ID\"A\"\n", end = "END_OF_UNIT 1\n", last = "M30\n", head = "MACHINING\n";
    read("dinplus", head + begin + end + begin + end + last);
    EXPECT_THAT(faults(), IsEmpty());
    read("dinplus", head + begin + begin + end + end + last);
    EXPECT_THAT(faults(), ElementsAre(Imbalance::nested_too_deep));
    EXPECT_THAT(partners(), ElementsAre(Pair(3, 2)));
    read("dinplus", head + begin + "WHILE #l1<5\n" + begin + end + "ENDWHILE\n" + end + last);
    EXPECT_THAT(faults(), ElementsAre(Imbalance::nested_too_deep));
    EXPECT_THAT(partners(), ElementsAre(Pair(4, 2)));
    read("dinplus", head + "WHILE #l1<5\n" + begin + end + "ENDWHILE\n" + last);
    EXPECT_THAT(faults(), IsEmpty());
    // Only the first one is wrong when its end is missing.
    read("dinplus", head + begin + begin + end + last);
    EXPECT_THAT(faults(), ElementsAre(Imbalance::never_closed));
    EXPECT_THAT(partners(), ElementsAre(Pair(2, 0)));
}

TEST_F(RegionQueries, ABlockThatCannotBeReadMayHideAnEnd) {
    read("fanuc", "WHILE[#1LT5]DO1\nIF[#1EQ END1\nM30\n");
    EXPECT_TRUE(regions().balance_unknown);
    read("fanuc", "WHILE[#1LT5]DO1\n#1=[2+\nEND1\nM30\n");
    EXPECT_FALSE(regions().balance_unknown);
    read("fanuc", "WHILE[#1LT5]DO1\nEND1\nM30\n");
    EXPECT_FALSE(regions().balance_unknown);
}

TEST(LoopsOfManyKinds, AreNotOneLoopWithOneNumber) {
    // The REPEAT of this UNTIL is missing, or it stands in the place of the word that ends FOR.
    test::HandBuilt built("MAIN.MPF", "FOR\nWHILE\nUNTIL\nENDWHILE\nM30\n");
    const auto mark = [&](RegionKind kind, RegionMark::Part part) {
        built.block({RegionMark{kind, part, std::nullopt, built.number(1)}});
    };
    mark(RegionKind::counting_loop, RegionMark::Part::open);
    mark(RegionKind::while_loop, RegionMark::Part::open);
    mark(RegionKind::until_loop, RegionMark::Part::close);
    mark(RegionKind::while_loop, RegionMark::Part::close);
    built.block({Stop{Stop::Kind::end, std::nullopt}});
    const auto workspace = test::analyse({built.finish()}, {.complete = true, .jobs = 1});
    const ProgramAnalysis& main = workspace->programs().front();
    ASSERT_EQ(main.regions().faults.size(), 1U);
    const flow::RegionFault& fault = main.regions().faults.front();
    EXPECT_EQ(fault.what, Imbalance::never_closed);
    EXPECT_EQ(test::line_of_effect(main, fault.effect), 1U);
    ASSERT_TRUE(fault.other);
    EXPECT_EQ(test::line_of_effect(main, *fault.other), 3U);
}

} // namespace
} // namespace maclint
