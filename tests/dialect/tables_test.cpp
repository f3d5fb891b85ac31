//! The fact tables hold together.
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/dialect/fanuc/codes.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

namespace maclint {
namespace {

TEST(Controls, HaveUniqueNamesAndEveryDialectsDefaultExists) {
    std::set<std::string> names;
    for (const ControlModel* control : controls())
        EXPECT_TRUE(names.insert(control->name).second) << control->name;
    for (const Dialect& dialect : dialects()) EXPECT_NE(find_control(dialect.default_control), nullptr);
    EXPECT_EQ(find_control("siemens"), nullptr);
    EXPECT_TRUE(find_control("fanuc")->assumed);
    EXPECT_FALSE(find_control("fanuc-16i")->assumed);
}

TEST(Controls, VariableRangesAreSortedAndDoNotOverlap) {
    for (const ControlModel* control : controls()) {
        for (const VariableFamily& family : control->families) {
            std::int32_t last = -1;
            for (const VariableRange& range : family.ranges) {
                EXPECT_GT(range.first, last) << control->name << " #" << range.first;
                EXPECT_GE(range.last, range.first);
                EXPECT_LT(range.space, control->spaces.size());
                EXPECT_LT(range.group, control->groups.size());
                last = range.last;
            }
        }
    }
}

TEST(Controls, CustomaryAndCancellingCodesBelongToTheirGroup) {
    for (const ControlModel* control : controls()) {
        for (const ModalGroup& group : control->groups) {
            if (group.letter != 'G' || !group.cancel_words.empty()) continue; // ended by more than a code
            const auto is_member = [&](double code) {
                return std::ranges::find(group.members, code) != group.members.end();
            };
            EXPECT_TRUE(std::ranges::all_of(group.customary, is_member)) << group.name;
            EXPECT_TRUE(!group.cancel || is_member(*group.cancel)) << group.name;
            EXPECT_TRUE(!group.reset || is_member(*group.reset)) << group.name;
        }
    }
}

TEST(Controls, ACodeBelongsToOneGroup) {
    for (const ControlModel* control : controls()) {
        std::set<double> codes;
        for (const ModalGroup& group : control->groups) {
            if (group.letter != 'G') continue;
            for (const double code : group.members)
                EXPECT_TRUE(codes.insert(code).second) << control->name << " G" << code;
        }
    }
}

TEST(Controls, HaveNoMoreSpacesOfVariablesThanTheAnalysisHasRoomFor) {
    ControlModel control = *find_control("fanuc");
    control.spaces.resize(most_spaces, control.spaces.front());
    EXPECT_EQ(checked(control).spaces.size(), most_spaces);
    control.spaces.push_back(control.spaces.front());
    EXPECT_THROW((void)checked(control), std::logic_error);
    for (const ControlModel* known : controls()) EXPECT_LE(known->spaces.size(), most_spaces) << known->name;
}

TEST(Controls, ModalVariablesReadTheGroupOfTheirNumber) {
    const ControlModel& mill = *find_control("fanuc");
    const auto group_of = [&](std::int64_t number) {
        return mill.groups[mill.families[0].find(number)->group].name;
    };
    EXPECT_EQ(group_of(4001), "motion mode");
    EXPECT_EQ(group_of(4003), "distance mode");
    EXPECT_EQ(group_of(4014), "work offset");
    EXPECT_EQ(group_of(4016), "rotation");
    EXPECT_EQ(group_of(4022), "mirror image");
    EXPECT_EQ(group_of(4109), "feed");
    EXPECT_EQ(mill.group_of('G', 91), mill.families[0].find(4003)->group);
}

TEST(CodeTable, KnowsMillsFromLathes) {
    EXPECT_FALSE(fanuc::is_lathe(*find_control("fanuc")));
    EXPECT_TRUE(fanuc::is_lathe(*find_control("fanuc-lathe")));
    EXPECT_EQ(fanuc::codes_of(*find_control("fanuc")).g_code(54.1).group, 13);
    EXPECT_EQ(fanuc::codes_of(*find_control("fanuc")).g_code(777).group, fanuc::no_group);
    EXPECT_EQ(fanuc::codes_of(*find_control("fanuc")).g_code(-1).group, fanuc::no_group);
}

} // namespace
} // namespace maclint
