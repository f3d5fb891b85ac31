//! The tables of the SINUMERIK language hold together and say what their sources say.
#include "analyzer/dialect/sinumerik/cycles.hpp"
#include "analyzer/dialect/sinumerik/functions.hpp"
#include "analyzer/dialect/sinumerik/g_codes.hpp"
#include "analyzer/dialect/sinumerik/system_variables.hpp"
#include "analyzer/dialect/sinumerik/word_list.hpp"
#include "analyzer/dialect/sinumerik/words.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace maclint::sinumerik {
namespace {

/// "14/2" of G91; empty for a code of no group.
std::string place_of(std::string_view code) {
    const GCodeRow* row = find_g_code(code);
    return row == nullptr ? "" : std::to_string(row->group) + "/" + std::to_string(row->member);
}

std::size_t words_in(std::string_view list) {
    std::size_t count = 0;
    for_each_word(list, [&](std::string_view) { ++count; });
    return count;
}

bool has(SystemType type, int indices, std::string_view name) {
    const auto found = find_system_variable(name);
    return found && found->type == type && found->indices == indices;
}

TEST(SinumerikGCodes, HaveTheNumbersThatTheControlReads) {
    EXPECT_EQ(place_of("G0"), "1/1");
    EXPECT_EQ(place_of("G18"), "6/2");
    EXPECT_EQ(place_of("G55"), "8/3"); // SV: $P_GG[8]==3
    EXPECT_EQ(place_of("G505"), "8/6");
    EXPECT_EQ(place_of("G599"), "8/100");
    EXPECT_EQ(place_of("AMIRROR"), "3/8");
    EXPECT_EQ(place_of("G25"), "3/10"); // no code has number 9
    EXPECT_EQ(place_of("DIAM90"), "29/3");
    EXPECT_EQ(place_of("G600"), "");
    EXPECT_EQ(place_of("G01"), "");
}

TEST(SinumerikGCodes, AreEachFoundByNameAndByNumber) {
    ASSERT_EQ(g_codes().size(), 387U);
    for (const GCodeRow& row : g_codes()) {
        EXPECT_EQ(find_g_code(row.name), &row) << row.name;
        EXPECT_EQ(find_member(row.group, row.member), &row) << row.name;
    }
    EXPECT_EQ(find_member(14, 3), nullptr);
}

TEST(SinumerikGGroups, StandByTheirNumbersAndResetToACodeOfTheirs) {
    ASSERT_EQ(g_groups().size(), 64U);
    for (std::size_t i = 0; i < g_groups().size(); ++i) {
        const GGroupRow& group = g_groups()[i];
        EXPECT_EQ(group.number, i + 1);
        EXPECT_FALSE(group.what.empty());
        if (group.reset == 0) continue;
        EXPECT_TRUE(group.modal) << group.what;
        EXPECT_NE(find_member(group.number, group.reset), nullptr) << group.what;
    }
    const auto reset_of = [](int group) {
        const GCodeRow* code = find_member(group, g_groups()[static_cast<std::size_t>(group) - 1].reset);
        return code == nullptr ? std::string_view() : code->name;
    };
    EXPECT_EQ(reset_of(8), "G500");
    EXPECT_EQ(reset_of(14), "G90");
    EXPECT_EQ(reset_of(48), "G462");
    EXPECT_FALSE(g_groups()[8].modal); // G53
}

TEST(SinumerikWords, AreNoCodesAndStandOnce) {
    EXPECT_TRUE(std::ranges::is_sorted(words(), {}, &WordRow::name));
    EXPECT_EQ(std::ranges::adjacent_find(words(), {}, &WordRow::name), words().end());
    for (const WordRow& row : words()) {
        EXPECT_EQ(find_g_code(row.name), nullptr) << row.name;
        EXPECT_GT(row.name.size(), 1U) << row.name;
    }
}

TEST(SinumerikWords, OfSeveralKindsCountAsTheFirst) {
    EXPECT_EQ(find_word("SBLOF")->kind, WordKind::procedure);
    EXPECT_TRUE(is_attribute("SBLOF"));
    EXPECT_EQ(find_word("SAVE")->kind, WordKind::attribute);
    EXPECT_FALSE(is_attribute("STOPRE"));
    EXPECT_EQ(find_word("CR")->kind, WordKind::address);
    EXPECT_EQ(find_word("TRUE")->kind, WordKind::constant);
    EXPECT_EQ(find_word("STOPPRE"), nullptr);
}

TEST(SinumerikFunctions, AndProceduresAreWordsOfThatKind) {
    int found = 0;
    for (const WordRow& row : words()) {
        const FunctionRow* function = find_function(row.name);
        if (function == nullptr) continue;
        ++found;
        EXPECT_TRUE(row.kind == WordKind::function || row.kind == WordKind::procedure) << row.name;
        EXPECT_LE(function->takes.size(), function->most) << row.name;
        EXPECT_LE(function->least, function->most) << row.name;
    }
    EXPECT_EQ(found, 46); // a row that is no word would be missing
    EXPECT_EQ(find_function("ATAN2")->least, 2U);
    EXPECT_EQ(find_function("SUBSTR")->most, 3U);
    EXPECT_EQ(find_function("SPRINT"), nullptr); // takes any number
}

TEST(SinumerikCycles, AreWordsOfThatKindAndTheOtherWayRound) {
    for (const WordRow& row : words())
        EXPECT_EQ(row.kind == WordKind::cycle, find_cycle(row.name) != nullptr) << row.name;
    EXPECT_EQ(words_in(find_cycle("CYCLE83")->older_parameters), 17U);
    EXPECT_EQ(find_cycle("CYCLE800")->use, CycleUse::setting);
    EXPECT_TRUE(is_cycle_name("CYCLE97")); // no row
    EXPECT_TRUE(is_cycle_name("HOLES2"));
    EXPECT_FALSE(is_cycle_name("CYCLE"));
    EXPECT_FALSE(is_cycle_name("CYCLE_ROW"));
}

TEST(SinumerikSystemVariables, HaveATypeAndIndices) {
    EXPECT_TRUE(has(SystemType::integer, 1, "$P_GG"));
    EXPECT_TRUE(has(SystemType::real, 1, "$AA_IM"));
    EXPECT_TRUE(has(SystemType::frame, 0, "$P_PFRAME"));
    EXPECT_TRUE(has(SystemType::integer, 1, "$$AC_MARKER"));
    EXPECT_TRUE(has(SystemType::real, 2, "$TC_DP6"));
    EXPECT_TRUE(has(SystemType::real, 2, "$TC_DPC64")); // the last of a run
    EXPECT_FALSE(find_system_variable("$TC_DPC65"));
    EXPECT_FALSE(find_system_variable("$TC_DPC"));
    EXPECT_FALSE(find_system_variable("$AA_MWP"));
    EXPECT_FALSE(find_system_variable("$"));
}

TEST(SinumerikSystemVariables, ChangeByThemselvesInTheMainRunOnly) {
    EXPECT_TRUE(is_main_run_variable("$AA_IM"));
    EXPECT_TRUE(is_main_run_variable("$A_IN"));
    EXPECT_TRUE(is_main_run_variable("$VA_IM"));
    EXPECT_FALSE(is_main_run_variable("$P_GG"));
    EXPECT_FALSE(is_main_run_variable("$AC_MARKER"));
    EXPECT_TRUE(is_kept_for_programs("$AC_PARAM"));
    EXPECT_TRUE(is_control_data("$MC_GCODE_RESET_VALUES"));
    EXPECT_FALSE(is_control_data("$P_UIFR"));
}

} // namespace
} // namespace maclint::sinumerik
