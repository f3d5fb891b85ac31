//! The fact tables hold together.
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/dialect/fanuc/codes.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "rules/rule.hpp"
#include "tests/support/hand_built.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
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

TEST(Controls, HaveWhatTheirLanguageHas) {
    using enum Capability;
    struct Row {
        Capability capability;
        bool fanuc, dinplus, hand_built; ///< the last: much as Sinumerik has it
    };
    constexpr auto rows = std::to_array<Row>({{loop_numbers, true, false, false},
                                              {sections, false, true, false},
                                              {exclusive_words, true, true, false},
                                              {vacancy, true, false, false},
                                              {unset_locals, true, true, false},
                                              {undefined_variables, false, true, false},
                                              {jumps, true, false, true},
                                              {sequence_numbers, true, true, true},
                                              {paired_words, false, false, false},
                                              {block_references, false, true, false},
                                              {macro_calls, true, false, false},
                                              {modal_calls, true, false, false},
                                              {named_arguments, false, true, false},
                                              {suppression, true, false, false}});
    for (const Row& row : rows) {
        const auto number = static_cast<int>(row.capability);
        EXPECT_EQ(find_control("fanuc")->has(row.capability), row.fanuc) << number;
        EXPECT_EQ(find_control("dinplus")->has(row.capability), row.dinplus) << number;
        EXPECT_EQ(test::control_with_names().has(row.capability), row.hand_built) << number;
        EXPECT_TRUE(std::ranges::any_of(all_rules(),
                                        [&](const Rule* rule) {
                                            return std::ranges::find(rule->needs, row.capability) !=
                                                   rule->needs.end();
                                        }))
            << "no rule needs " << number;
    }
}

TEST(Controls, ACodeIsFoundAsItIsWrittenAndGivesItsMember) {
    const ControlModel& control = *find_control("sinumerik");
    const auto plane = control.member_of('G', 18);
    ASSERT_TRUE(plane);
    EXPECT_EQ(control.groups[plane->group].role, ModalRole::plane);
    EXPECT_EQ(plane->code, 2);
    EXPECT_EQ(control.spell(plane->group, 2), "G18");
    EXPECT_EQ(control.group_of('G', 999), std::nullopt);
    EXPECT_EQ(find_control("fanuc")->member_of('G', 18)->code, 18);
}

TEST(Controls, OfTheFamilyHaveAColumnInTheTableOfForms) {
    using fanuc::Reading;
    for (const ControlModel& control : fanuc::fanuc_controls())
        EXPECT_EQ(fanuc::reading_of(control, SyntaxErrorKind::letter_o), Reading::stops) << control.name;
    EXPECT_EQ(fanuc::reading_of(*find_control("fanuc-16i-lathe"), SyntaxErrorKind::words_after_then),
              Reading::stops);
    EXPECT_EQ(fanuc::controls_that_take(SyntaxErrorKind::consequence_without_then), "nct or haas");
    EXPECT_EQ(fanuc::controls_that_take(SyntaxErrorKind::double_sharp), "");
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

TEST(Controls, HaveVariablesOfTheirOwn) {
    struct Row {
        const char* control;
        std::int32_t number;
        Meaning meaning;
        SpaceId space;
        OnWrite on_write;
    };
    using enum OnWrite;
    constexpr auto retained = fanuc::spaces::retained, common = fanuc::spaces::common,
                   machine = fanuc::spaces::machine;
    constexpr auto rows = std::to_array<Row>({
        {"haas", 10000, Meaning::variable, retained, store},
        {"haas", 10149, Meaning::variable, retained, store},
        {"haas", 10150, Meaning::machine, machine, store},
        {"haas", 10550, Meaning::machine, machine, store},
        {"haas", 10999, Meaning::variable, retained, store},
        {"haas", 11000, Meaning::machine, machine, forbidden},
        {"haas", 11255, Meaning::machine, machine, forbidden},
        {"haas", 12000, Meaning::machine, machine, store},
        {"haas", 14001, Meaning::machine, machine, store},
        {"haas", 100, Meaning::variable, retained, store},
        {"haas-1999", 100, Meaning::variable, retained, store},
        {"haas-1999", 10000, Meaning::machine, machine, store},
        {"fanuc", 100, Meaning::variable, common, store},
        {"fanuc-30i", 10000, Meaning::machine, machine, store},
        {"fanuc-30i", 3101, Meaning::machine, machine, forbidden},
        {"fanuc-16i", 3101, Meaning::machine, machine, store},
        {"fanuc-16i", 4112, Meaning::absent, machine, forbidden},
        {"fanuc-16i", 4120, Meaning::machine, machine, forbidden},
        {"fanuc-16i", 4130, Meaning::machine, machine, forbidden},
        {"nct", 4112, Meaning::machine, machine, forbidden},
    });
    for (const Row& row : rows) {
        const VariableRange* range = fanuc::fanuc_control(row.control).families.front().find(row.number);
        ASSERT_NE(range, nullptr) << row.control << " #" << row.number;
        EXPECT_EQ(range->meaning, row.meaning) << row.control << " #" << row.number;
        EXPECT_EQ(range->space, row.space) << row.control << " #" << row.number;
        EXPECT_EQ(range->on_write, row.on_write) << row.control << " #" << row.number;
    }
}

TEST(Controls, CustomaryAndCancellingCodesBelongToTheirGroup) {
    for (const ControlModel* control : controls()) {
        for (const ModalGroup& group : control->groups) {
            if (group.letter != 'G' || !group.cancel_words.empty()) continue; // ended by more than a code
            const auto is_member = [&](double code) {
                return std::ranges::find(group.members, code, &ModalMember::number) != group.members.end();
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
            for (const ModalMember& member : group.members) {
                const bool is_name = member.written_code < 0;
                EXPECT_TRUE(is_name || codes.insert(member.written_code).second)
                    << control->name << " G" << member.written_code;
            }
        }
    }
}

TEST(Controls, HaveOneModalGroupOfARole) {
    for (const ControlModel* control : controls()) {
        std::set<ModalRole> roles;
        for (const ModalGroup& group : control->groups)
            EXPECT_TRUE(group.role == ModalRole::other || roles.insert(group.role).second)
                << control->name << ": " << group.name;
        for (const ModalRole role : {ModalRole::motion, ModalRole::plane, ModalRole::feed, ModalRole::speed,
                                     ModalRole::feed_mode, ModalRole::cutter_compensation})
            EXPECT_TRUE(roles.contains(role)) << control->name;
    }
    const ControlModel& mill = *find_control("fanuc");
    EXPECT_EQ(mill.group_with(ModalRole::distance), mill.group_of('G', 91));
    EXPECT_EQ(mill.group_with(ModalRole::cycle), mill.group_of('G', 80));
    EXPECT_EQ(mill.group_with(ModalRole::macro_call), mill.group_of('G', 66));
    EXPECT_EQ(mill.group_with(ModalRole::tilted_plane), std::nullopt);
    const ControlModel& din = *find_control("dinplus");
    EXPECT_EQ(din.group_with(ModalRole::cutter_compensation), din.group_of('G', 41));
    EXPECT_EQ(din.group_with(ModalRole::mirror_image), din.group_of('G', 30));
    EXPECT_EQ(din.group_with(ModalRole::offset_suspension), din.group_of('G', 920));
    EXPECT_EQ(din.group_with(ModalRole::distance), std::nullopt);
}

TEST(Controls, OfMillsKnowTheSameControlOnALathe) {
    for (const ControlModel* control : controls()) {
        for (const ControlModel* lathe : control->lathes) {
            EXPECT_EQ(lathe->machine, Machine::lathe);
            EXPECT_EQ(lathe->model, control->model);
            EXPECT_EQ(find_control(lathe->name), lathe);
            EXPECT_EQ(control->lathe_of(lathe->code_system), lathe);
        }
    }
    EXPECT_EQ(find_control("fanuc-30i")->lathe_of('A'), find_control("fanuc-30i-lathe"));
    EXPECT_EQ(find_control("fanuc-30i-lathe")->lathe_of('B'), find_control("fanuc-30i-lathe-b"));
    EXPECT_EQ(find_control("fanuc-30i-lathe-b")->lathe_of('A'), nullptr) << "who names one means it";
    EXPECT_EQ(find_control("haas")->lathe_of('B'), nullptr);
    EXPECT_EQ(find_control("nct")->lathe_of('A'), nullptr);
    EXPECT_EQ(find_control("dinplus")->machine, Machine::lathe);
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
    EXPECT_EQ(fanuc::codes_of(*find_control("fanuc")).g_code(90).group, 2);
    EXPECT_EQ(fanuc::codes_of(*find_control("fanuc-lathe")).g_code(90).group, 0) << "a turning cycle";
    const ControlModel& b = *find_control("fanuc-lathe-b");
    const ControlModel& c = *find_control("fanuc-lathe-c");
    EXPECT_EQ(fanuc::codes_of(b).g_code(90).group, *b.group_with(ModalRole::distance));
    EXPECT_EQ(fanuc::codes_of(b).g_code(77).group, *b.group_with(ModalRole::motion));
    EXPECT_EQ(fanuc::codes_of(b).g_code(95).group, *b.group_with(ModalRole::feed_mode));
    EXPECT_EQ(fanuc::codes_of(b).g_code(20).group, *b.group_with(ModalRole::units));
    EXPECT_EQ(fanuc::codes_of(c).g_code(20).group, *c.group_with(ModalRole::motion));
    EXPECT_EQ(fanuc::codes_of(c).g_code(71).group, *c.group_with(ModalRole::units));
    EXPECT_EQ(fanuc::codes_of(*find_control("fanuc")).g_code(54.1).group, 13);
    EXPECT_EQ(fanuc::codes_of(*find_control("fanuc")).g_code(777).group, fanuc::no_group);
    EXPECT_EQ(fanuc::codes_of(*find_control("fanuc")).g_code(-1).group, fanuc::no_group);
}

} // namespace
} // namespace maclint
