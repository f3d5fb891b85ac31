//! `maclint explain` of alarms and variables, and of codes on one control.
#include "analyzer/dialect/dialect.hpp"
#include "cli/report/alarm_page.hpp"
#include "cli/report/force_words.hpp"
#include "cli/report/mentions.hpp"
#include "cli/report/sources.hpp"
#include "cli/report/variable_page.hpp"
#include "tests/support/in_repository.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace maclint::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

class Explain : public InRepository {
  protected:
    [[nodiscard]] std::string page(std::vector<std::string> words) const {
        words.insert(words.begin(), "explain");
        const Finished finished = run(words);
        EXPECT_EQ(finished.status, 0) << finished.err;
        return finished.out;
    }
};

TEST_F(Explain, TellsOfAlarmsByTheirNumber) {
    EXPECT_THAT(page({"128"}),
                AllOf(StartsWith("Alarm 128 "), HasSubstr("FANUC 16i/18i/21i: ILLEGAL MACRO SEQUENCE NUMBER"),
                      HasSubstr("What brings it:"), HasSubstr("MAC301 jump-target-missing: ")));
    for (const std::string word : {"78", "078", "PS0078", "alarm 78", "P/S 78"})
        EXPECT_THAT(page({word}), HasSubstr("Alarm 078 ")) << word;
}

TEST_F(Explain, TellsOfAlarmsOfASinumerikByTheirNumber) {
    EXPECT_THAT(page({"14080"}),
                AllOf(StartsWith("Alarm 14080 "), HasSubstr("SINUMERIK: jump target not found"),
                      HasSubstr("What brings it:"), HasSubstr("MAC301 jump-target-missing: ")));
    EXPECT_THAT(page({"14009"}),
                AllOf(HasSubstr("SINUMERIK: illegal program path"), Not(HasSubstr("What brings it:")),
                      HasSubstr("no document at hand has them")))
        << "no more is known than what it is called";
}

TEST_F(Explain, TellsOfWordsOfLanguages) {
    EXPECT_THAT(page({"cycle81"}),
                AllOf(StartsWith("CYCLE81 (SIEMENS SINUMERIK"), HasSubstr("cycle: "), HasSubstr("RTP, RFP"),
                      HasSubstr("radius compensation has to be off")));
    EXPECT_THAT(page({"MCALL"}), HasSubstr("calls the program after each move"));
    EXPECT_THAT(page({"ATAN", "--control", "fanuc-16i"}),
                AllOf(StartsWith("ATAN ("), HasSubstr("function: ")));
    EXPECT_THAT(page({"while", "--dialect", "dinplus"}),
                AllOf(StartsWith("WHILE (HEIDENHAIN DIN PLUS"), HasSubstr("\nRules with that name:\n")));
    EXPECT_THAT(page({"$P_EP"}),
                AllOf(StartsWith("$P_EP ("), HasSubstr("REAL, with 1 index; the last position "
                                                       "of the program, can only be read")));
    EXPECT_EQ(run({"explain", "$P_PE"}).status, 2);
    EXPECT_EQ(run({"explain", "MCALL", "--dialect", "fanuc"}).status, 2);
}

TEST_F(Explain, WritesJsonForTools) {
    const auto explained = [&](const std::string& word) {
        return nlohmann::json::parse(page({word, "--format", "json"}));
    };
    const auto rule = explained("jump-into-loop");
    EXPECT_EQ(rule["version"], 1);
    ASSERT_EQ(rule["pages"].size(), 1U);
    EXPECT_EQ(rule["pages"][0]["kind"], "rule");
    EXPECT_EQ(rule["pages"][0]["rule"]["code"], "MAC303");
    EXPECT_THAT(rule["pages"][0]["text"].get<std::string>(), HasSubstr("MAC303 jump-into-loop"));
    EXPECT_EQ(explained("#4109")["pages"][0]["kind"], "variable");
    EXPECT_EQ(explained("128")["pages"][0]["kind"], "alarm");
    EXPECT_EQ(explained("MCALL")["pages"][0]["kind"], "word");
    EXPECT_EQ(explained("MAC523/G83.Q")["pages"][0]["row"], "MAC523/G83.Q");
    const auto jump = explained("jump");
    EXPECT_TRUE(jump["pages"].empty());
    EXPECT_EQ(jump["meant"][0]["code"].get<std::string>().substr(0, 3), "MAC");
    EXPECT_EQ(run({"explain", "nosuchrule", "--format", "json"}).status, 2);
}

TEST(SourceSentence, IsReadByWhoDoesNotKnowTheKeys) {
    EXPECT_THAT(cli::source_sentence("SEED-001:403"),
                AllOf(StartsWith("Joni Nieminen"), HasSubstr(", line 403 of its text (SEED-001:403)")));
    EXPECT_THAT(cli::source_sentence("SEED-002:518-525"),
                HasSubstr(", lines 518-525 of its text (SEED-002:518-525)"));
    EXPECT_EQ(cli::source_sentence("T: search order"), "T (experience, not confirmed): search order");
    EXPECT_THAT(cli::source_sentence("HAAS-118"), testing::EndsWith("expressions of macros (HAAS-118)"));
    EXPECT_EQ(cli::source_sentence("no such key"), "no such key");
}

TEST_F(Explain, SaysWhatAPrecisionMeans) {
    const auto json = nlohmann::json::parse(page({"MAC303", "--format", "json"}));
    EXPECT_THAT(json["pages"][0]["text"].get<std::string>(),
                HasSubstr("Very high: of 20 findings at least 19 are worth acting on."));
}

TEST_F(Explain, FindsRulesByWhatTheirSummariesSay) {
    EXPECT_THAT(page({"work offset"}), HasSubstr("may be meant by 'work offset'"));
    EXPECT_THAT(run({"explain", "is to"}).err, HasSubstr("there is no rule 'is to'")) << "too short to tell";
}

TEST_F(Explain, TellsOfAlarmsAsOneControlHasThem) {
    EXPECT_THAT(page({"128", "--control", "fanuc-30i"}),
                AllOf(HasSubstr("FANUC 30i/0i-D: "), Not(HasSubstr("FANUC 16i/18i/21i"))));
    EXPECT_THAT(page({"1300"}), HasSubstr("\n    none\n")); // no rule finds it
    EXPECT_THAT(page({"001"}), HasSubstr("no text shows it"));
}

TEST_F(Explain, TellsOfRulesThatHaveTheNumberOfAnAlarm) {
    EXPECT_THAT(page({"114"}), AllOf(StartsWith("Alarm 114 "), HasSubstr("MAC118")));
    EXPECT_THAT(page({"303"}), Not(HasSubstr("Alarm"))); // no alarm has it
}

TEST(AlarmsNamed, AreThoseOfAList) {
    EXPECT_THAT(cli::alarms_named("76", ""), SizeIs(2)); // it means two things
    EXPECT_THAT(cli::alarms_named("76", "FANUC 30i/0i-D"), SizeIs(1));
    EXPECT_THAT(cli::alarms_named("3070", "NCT"), SizeIs(1));
    EXPECT_THAT(cli::alarms_named("G76", ""), IsEmpty());
    EXPECT_THAT(cli::alarms_named("alarm", ""), IsEmpty());
}

TEST_F(Explain, TellsWhatAVariableIs) {
    EXPECT_THAT(page({"#4109"}),
                AllOf(StartsWith("#4109 feed F "), HasSubstr("reads what is in force of: feed"),
                      HasSubstr("can only be read"), HasSubstr("SEED-001:1360")));
    EXPECT_THAT(page({"#3"}), AllOf(HasSubstr("argument C of a macro call"), HasSubstr("may be written")));
    EXPECT_THAT(page({"#5042", "--control", "fanuc-16i"}), HasSubstr("that of the axis of Y or V or Z or W"));
    EXPECT_THAT(page({"#5042", "--control", "fanuc-16i-lathe"}), HasSubstr("(fanuc-16i-lathe)"));
    EXPECT_THAT(page({"#3000"}), AllOf(HasSubstr("writing it stops the program with an alarm"),
                                       HasSubstr("\nRules that speak of it:\n")));
    EXPECT_THAT(page({"#50"}), HasSubstr("no control that is known has it"));
}

TEST_F(Explain, TellsOnWhichControlsAVariableIsSomethingElse) {
    const std::string group = page({"#4012"}); // G54 to G59 on a Haas, a modal call elsewhere
    EXPECT_THAT(group,
                AllOf(HasSubstr("work offset"), HasSubstr("haas"), HasSubstr("a value of the machine")));
    EXPECT_THAT(page({"#4012", "--control", "haas"}), Not(HasSubstr("a value of the machine")));
}

TEST_F(Explain, RefusesControlsThatNobodyKnows) {
    const Finished finished = run({"explain", "G1", "--control", "fanuc-31"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("fanuc-30i"));
    EXPECT_EQ(run({"explain", "#1234567890123"}).status, 2);
}

std::vector<std::string> force_of(std::string_view control, std::vector<std::string_view> codes) {
    return cli::force_of(*find_control(control), codes);
}

TEST(Force, IsThatOfTheModalGroup) {
    EXPECT_THAT(force_of("fanuc-16i", {"G83"}),
                ElementsAre(AllOf(StartsWith("canned cycle, until G73, "), Not(HasSubstr("G83"))),
                            "cancelled by G80", HasSubstr("ended by a code of the motion mode, too: G0")));
    EXPECT_THAT(force_of("fanuc-16i", {"G41", "G42"}),
                ElementsAre("cutter compensation, until G40", "cancelled by G40"));
    EXPECT_THAT(force_of("fanuc-16i", {"G40"}),
                ElementsAre("cutter compensation, until G41 or G42", "it cancels the others of its group",
                            "in force when a program begins"));
    EXPECT_THAT(force_of("fanuc-16i", {"G4"}), IsEmpty());
    EXPECT_THAT(force_of("haas-1999", {"G83"}), SizeIs(2)); // only G80 ends it
}

TEST(Mentions, AreOfTheWholeNumber) {
    EXPECT_TRUE(cli::mentions_code("G01 without a feed", "G1"));
    EXPECT_TRUE(cli::mentions_code("a jump behind G30.", "G30"));
    EXPECT_TRUE(cli::mentions_code("G30-LEFT-ACTIVE", "G30"));
    EXPECT_TRUE(cli::mentions_code("G54.1 of a mill", "G54.1"));
    EXPECT_FALSE(cli::mentions_code("G54.1 of a mill", "G54"));
    EXPECT_FALSE(cli::mentions_code("G130", "G30"));
    EXPECT_FALSE(cli::mentions_code("AG30 G", "G30"));
    EXPECT_TRUE(cli::mentions_code("#3003 is not put back", "#3003"));
    EXPECT_FALSE(cli::mentions_code("#30031", "#3003"));
}

} // namespace
} // namespace maclint::test
