//! `maclint controls`: the list, and what is known of one.
#include "analyzer/dialect/dialect.hpp"
#include "tests/support/in_repository.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace maclint::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class ControlsCommand : public InRepository {};

TEST_F(ControlsCommand, AreListedWithWhatIsKnownOfEach) {
    const std::string list = run({"controls"}).out;
    for (const ControlModel* control : controls())
        EXPECT_THAT(list, AllOf(HasSubstr(control->name + " "), HasSubstr(control->description)));
    EXPECT_THAT(list,
                AllOf(HasSubstr("alarms of NCT"), HasSubstr("no alarms"), HasSubstr("G code system B")));
}

TEST_F(ControlsCommand, AreListedAsJson) {
    const json list = json::parse(run({"controls", "--format", "json"}).out);
    ASSERT_EQ(list.size(), controls().size());
    for (const json& control : list) {
        const ControlModel& model = *find_control(control["name"].get<std::string>());
        EXPECT_EQ(control["machine"], model.machine == Machine::mill ? "mill" : "lathe");
        EXPECT_EQ(control["alarms"]["list"], model.alarms);
        EXPECT_EQ(control["alarms"]["numbers"] != 0, !model.alarms.empty()) << control["name"];
        EXPECT_LE(control["alarms"]["found"], control["alarms"]["numbers"]);
    }
}

TEST_F(ControlsCommand, TellAllThatIsKnownOfOne) {
    EXPECT_THAT(run({"controls", "fanuc-30i"}).out,
                AllOf(StartsWith("fanuc-30i "), HasSubstr("nested macro calls: 5"),
                      HasSubstr("canned cycle: G73, "), HasSubstr("#4109: feed F, can only be read"),
                      HasSubstr("FANUC 30i/0i-D: ")));
    const json one = json::parse(run({"controls", "fanuc-30i", "--format", "json"}).out);
    EXPECT_EQ(one["limits"]["nested macro calls"], 5);
    EXPECT_EQ(one["variable_ranges"][0]["first"], 0);
    EXPECT_THAT(run({"controls", "dinplus"}).out,
                AllOf(HasSubstr("turning cycles: "), HasSubstr("no list is known")));
}

TEST_F(ControlsCommand, ThatNobodyKnowsAreRefused) {
    const Finished finished = run({"controls", "fanuc-31i"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("Did you mean 'fanuc-30i'?"));
    EXPECT_EQ(run({"controls", "--format", "markdown"}).status, 2);
}

} // namespace
} // namespace maclint::test
