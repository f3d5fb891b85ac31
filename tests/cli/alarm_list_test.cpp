//! `rules --write-alarms`: the list of alarms with what finds each.
#include "cli/report/alarm_page.hpp"
#include "rules/alarms/alarm_uses.hpp"
#include "tests/support/in_repository.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

class AlarmList : public InRepository {};

TEST_F(AlarmList, IsWrittenIntoAFileOfItsOwn) {
    ASSERT_EQ(run({"rules", "--write-alarms", "alarms.md"}).status, 0);
    const std::string list = read_file(folder.path() / "alarms.md");
    EXPECT_EQ(list, cli::markdown_alarms());
    EXPECT_EQ(run({"rules", "--write-alarms", "alarms.md"}).status, 0); // over its own
    folder.write("notes.md", "# Notes of the shop\n");
    EXPECT_EQ(run({"rules", "--write-alarms", "notes.md"}).status, 2);
    EXPECT_EQ(read_file(folder.path() / "notes.md"), "# Notes of the shop\n");
}

TEST(AlarmListOfAll, NamesEveryAlarmOfEveryListAndWhatFindsIt) {
    const std::string list = cli::markdown_alarms();
    EXPECT_THAT(list, StartsWith("# Alarms\n"));
    for (const std::span<const ControlAlarm> table : alarm_tables())
        for (const ControlAlarm& alarm : table)
            EXPECT_THAT(list, HasSubstr("\n| " + std::string(alarm.number) + " | ")) << alarm.number;
    for (const Rule* rule : all_rules())
        if (!alarms_of(*rule).empty()) {
            EXPECT_THAT(list, HasSubstr("[" + std::string(rule->code) + "](rules/"));
        }
    EXPECT_THAT(list, AllOf(ContainsRegex("\n. 007 . [^\n]*.MAC551..rules/MAC551.md. .[0-9]+ rows. "),
                            ContainsRegex("\n. 1300 . [^\n]* not found"), HasSubstr("(number not confirmed)"),
                            ContainsRegex("\n. FANUC 30i/0i-D . [0-9]+ of [0-9]+ . [0-9]+ of [0-9]+ .\n")));
}

} // namespace
} // namespace maclint::test
