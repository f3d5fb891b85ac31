//! The table of alarms knows every number that rules and rows name, and nothing of it is forgotten.
#include "cli/report/alarm_words.hpp"
#include "cli/report/sources.hpp"
#include "rules/alarms/alarm_uses.hpp"
#include "rules/alarms/tables.hpp"
#include "rules/words/rule_row.hpp"

#include <set>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::Not;

template<class Visit>
void for_each_alarm(const Visit& visit) {
    for (const std::span<const ControlAlarm> table : alarm_tables())
        for (const ControlAlarm& alarm : table) visit(alarm);
}

TEST(Alarms, HaveEachNumberOnceOnAList) {
    std::set<std::pair<std::string_view, std::string_view>> seen;
    for_each_alarm([&](const ControlAlarm& alarm) {
        bool is_listed = false;
        for (const std::string_view list : alarm_lists) {
            if (alarm.title_on(list).empty()) continue;
            is_listed = true;
            EXPECT_TRUE(seen.emplace(list, alarm.number).second) << list << " " << alarm.number;
            EXPECT_EQ(find_alarm(list, alarm.number), &alarm);
        }
        EXPECT_TRUE(is_listed) << alarm.number;
    });
    EXPECT_EQ(find_alarm("FANUC 16i/18i/21i", "1124"), nullptr);
    EXPECT_EQ(find_alarm("Haas", "128"), nullptr);
}

TEST(Alarms, SayWhatBringsThemAndWhereThatStands) {
    for_each_alarm([](const ControlAlarm& alarm) {
        EXPECT_FALSE(alarm.cause.empty()) << alarm.number;
        EXPECT_THAT(std::string(alarm.cause), Not(testing::EndsWith("."))) << alarm.number;
        const auto sources = cli::sources_of(alarm);
        EXPECT_FALSE(sources.empty()) << alarm.number;
        for (const std::string& source : sources) EXPECT_NE(cli::document_of(source), "") << source;
        // What nobody but memory says is no document's, and the other way round.
        const bool is_memory = sources == std::vector<std::string>{"T"};
        if (alarm.backing == AlarmBacking::document) {
            EXPECT_FALSE(is_memory) << alarm.number;
        }
        if (alarm.backing == AlarmBacking::memory) {
            EXPECT_TRUE(is_memory) << alarm.number;
        }
    });
}

TEST(Alarms, AreKnownWhereRulesNameThemWithTheSameTitle) {
    for (const Rule* rule : all_rules())
        for (const Alarm& named : rule->alarms) {
            const ControlAlarm* known = find_alarm(named.control, named.number);
            ASSERT_NE(known, nullptr) << rule->code << " names " << named.control << " " << named.number;
            EXPECT_EQ(known->title_on(named.control), named.text) << rule->code;
        }
}

TEST(Alarms, AreKnownWhereRowsNameThem) {
    for (const Rule* rule : all_rules())
        for (const AlarmName& named : alarms_of(*rule)) {
            const ControlAlarm* known = find_alarm(named.list, named.number);
            ASSERT_NE(known, nullptr) << rule->code << " names " << named.list << " " << named.number;
            EXPECT_NE(known->shown, ShownByText::never) << rule->code << " finds " << named.number;
        }
}

/// Numbers that stand for many, as the program chooses them, are none that a rule could name.
bool is_one(const ControlAlarm& alarm) { return alarm.number.find('+') == std::string_view::npos; }

TEST(Alarms, OfProgramsThatTextAlwaysShowsAreFoundOrExcused) {
    for_each_alarm([](const ControlAlarm& alarm) {
        if (alarm.shown != ShownByText::always || alarm.subject != AlarmSubject::program || !is_one(alarm))
            return;
        for (const std::string_view list : alarm_lists) {
            if (alarm.title_on(list).empty()) continue;
            const bool is_found = !uses_of(list, alarm.number).empty();
            const bool is_excused = !why_not_found(list, alarm.number).empty();
            EXPECT_NE(is_found, is_excused)
                << list << " " << alarm.number << (is_found ? ": take it out of" : ": give a reason in")
                << " rules/alarms/tables_not_found.cpp";
        }
    });
}

TEST(Alarms, AreExcusedOnlyWhereTheyStandInTheTable) {
    for (const alarms::NotFound& row : alarms::not_found()) {
        const ControlAlarm* alarm = find_alarm(row.list, row.number);
        ASSERT_NE(alarm, nullptr) << row.list << " " << row.number;
        EXPECT_EQ(alarm->shown, ShownByText::always) << row.number;
        EXPECT_EQ(alarm->subject, AlarmSubject::program) << row.number;
    }
}

TEST(AlarmUses, AreThoseOfRulesAndOfRows) {
    const auto point = uses_of("FANUC 16i/18i/21i", "007");
    ASSERT_FALSE(point.empty());
    EXPECT_TRUE(std::ranges::any_of(point, [](const AlarmUse& use) { return !use.rows.empty(); }));
    const auto jump = uses_of("FANUC 16i/18i/21i", "128");
    EXPECT_TRUE(std::ranges::any_of(
        jump, [](const AlarmUse& use) { return use.rule == find_rule("MAC301") && use.rows.empty(); }));
    EXPECT_TRUE(uses_of("NCT", "128").empty());
}

} // namespace
} // namespace maclint
