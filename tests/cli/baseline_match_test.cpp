//! Which findings a baseline knows, without files: the bookkeeping.
#include "cli/gate/match.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// "O1 MAC301 a": file, rule and fingerprint.
KnownPlace place(const std::string& words) {
    const auto first = words.find(' ');
    const auto second = words.find(' ', first + 1);
    return {words.substr(0, first), words.substr(first + 1, second - first - 1), words.substr(second + 1)};
}

struct Case {
    std::vector<std::pair<std::string, std::size_t>> baseline; ///< place and count
    std::vector<std::vector<std::string>> findings;            ///< places
    std::vector<std::string> looked_at;
    std::set<std::string> there = {}; ///< further files
};

class Match : public testing::Test {
  protected:
    Matched run(const Case& what) {
        Baseline baseline;
        for (const auto& [words, count] : what.baseline)
            baseline.push_back({.place = place(words), .count = count, .block = {}});
        std::vector<FoundPlaces> findings;
        for (const auto& places : what.findings) {
            auto& found = findings.emplace_back();
            for (const std::string& words : places) found.push_back(place(words));
        }
        LookedAt looked_at;
        for (const std::string& file : what.looked_at) looked_at[file] = &rules;
        return match(baseline, findings, looked_at,
                     [&](const std::string& name) { return what.there.contains(name); });
    }
    static std::vector<std::string> rest_of(const Matched& matched) {
        std::vector<std::string> all;
        for (const auto& [place, count, block] : matched.rest)
            all.push_back(place.file + " " + place.rule + " " + place.fingerprint + " " +
                          std::to_string(count));
        return all;
    }

    RuleStates rules;
};

TEST_F(Match, OfFindingsThatAreAlikeOneMoreIsNew) {
    const Matched matched = run({.baseline = {{"O1 MAC301 a", 2}},
                                 .findings = {{"O1 MAC301 a"}, {"O1 MAC301 a"}, {"O1 MAC301 a"}},
                                 .looked_at = {"O1"}});
    EXPECT_THAT(matched.known, ElementsAre(true, true, false));
    EXPECT_EQ(matched.gone, 0U);
}

TEST_F(Match, ADifferentRuleTextOrFileIsNew) {
    const Matched matched = run({.baseline = {{"O1 MAC301 a", 1}},
                                 .findings = {{"O1 MAC302 a"}, {"O1 MAC301 b"}, {"O2 MAC301 a"}},
                                 .looked_at = {"O1", "O2"}});
    EXPECT_THAT(matched.known, ElementsAre(false, false, false));
    EXPECT_EQ(matched.gone, 1U);
}

TEST_F(Match, ACauseWithAFurtherPlaceIsNew) {
    const Case before{.baseline = {{"O1 MAC501 a", 1}, {"O1 MAC501 b", 1}},
                      .findings = {{"O1 MAC501 a", "O1 MAC501 b"}},
                      .looked_at = {"O1"}};
    EXPECT_THAT(run(before).known, ElementsAre(true));
    Case after = before;
    after.findings[0].emplace_back("O1 MAC501 c");
    const Matched matched = run(after);
    EXPECT_THAT(matched.known, ElementsAre(false));
    EXPECT_EQ(matched.gone, 0U);
}

TEST_F(Match, WhatIsGoneIsCountedOnlyWhereItWasLookedFor) {
    rules.switch_off(rules_named("MAC501"), "");
    const Matched matched = run({.baseline = {{"O1 MAC301 a", 3},
                                              {"O1 MAC501 a", 1},
                                              {"O2 MAC301 a", 1},
                                              {"O3 MAC301 a", 1},
                                              {"O1 MAC999 a", 1}},
                                 .findings = {{"O1 MAC301 a"}},
                                 .looked_at = {"O1"},
                                 .there = {"O2"}});
    EXPECT_EQ(matched.gone, 3U);
    EXPECT_THAT(rest_of(matched), ElementsAre("O1 MAC301 a 1", "O1 MAC501 a 1", "O2 MAC301 a 1"));
}

TEST_F(Match, ARowIsKnownByItsKeyAlone) {
    const Matched matched =
        run({.baseline = {{"O1 MAC523 a", 1}, {"O1 MAC523/G83.Q b", 1}},
             .findings = {{"O1 MAC523/G83.Q a"}, {"O1 MAC523/G83.Q b"}, {"O1 MAC523/G73.Q b"}},
             .looked_at = {"O1"}});
    EXPECT_THAT(matched.known, ElementsAre(false, true, false));
}

TEST_F(Match, ARowIsGoneOnlyWhereItWasLookedFor) {
    rules.switch_off(rules_named("MAC523/G83.Q"), "");
    rules.switch_off(rules_named("MAC576"), "");
    const Matched matched = run({.baseline = {{"O1 MAC523/G83.Q a", 1},
                                              {"O1 MAC523/G73.Q a", 1},
                                              {"O1 MAC523/G999.Q a", 1},
                                              {"O1 MAC576/G48.A a", 1}},
                                 .findings = {},
                                 .looked_at = {"O1"}});
    EXPECT_EQ(matched.gone, 2U);
    EXPECT_THAT(rest_of(matched), ElementsAre("O1 MAC523/G83.Q a 1", "O1 MAC576/G48.A a 1"));
}

TEST_F(Match, AFileThatIsGoneGoesOnUnderANewName) {
    const Matched matched = run({.baseline = {{"O1 MAC301 a", 1}, {"O1 MAC301 b", 1}},
                                 .findings = {{"O2 MAC301 a"}, {"O2 MAC301 c"}},
                                 .looked_at = {"O2"}});
    EXPECT_THAT(matched.known, ElementsAre(true, false));
    EXPECT_THAT(matched.renamed, ElementsAre(Renamed{"O1", "O2"}));
    EXPECT_EQ(matched.gone, 1U);
    EXPECT_THAT(rest_of(matched), ElementsAre("O2 MAC301 a 1"));
}

TEST_F(Match, AFileThatIsThereIsNotRenamed) {
    const Case copied{.baseline = {{"O1 MAC301 a", 1}},
                      .findings = {{"O2 MAC301 a"}},
                      .looked_at = {"O2"},
                      .there = {"O1"}};
    EXPECT_THAT(run(copied).known, ElementsAre(false));
    Case known = copied;
    known.there = {};
    known.baseline.emplace_back("O2 MAC301 b", 1);
    EXPECT_THAT(run(known).known, ElementsAre(false)) << "the baseline knows O2 by its own name";
}

TEST_F(Match, LessThanHalfIsNoRename) {
    const Matched matched = run({.baseline = {{"O1 MAC301 a", 1}, {"O1 MAC301 b", 2}},
                                 .findings = {{"O2 MAC301 a"}},
                                 .looked_at = {"O2"}});
    EXPECT_THAT(matched.known, ElementsAre(false));
    EXPECT_THAT(matched.renamed, IsEmpty());
}

TEST_F(Match, OnlyOneFileIsTakenForRenamedAndThatOfTheSameName) {
    const Matched matched = run({.baseline = {{"old/O1 MAC301 a", 1}},
                                 .findings = {{"a/O7 MAC301 a"}, {"new/O1 MAC301 a"}},
                                 .looked_at = {"a/O7", "new/O1"}});
    EXPECT_THAT(matched.known, ElementsAre(false, true));
    EXPECT_THAT(matched.renamed, ElementsAre(Renamed{"old/O1", "new/O1"}));
}

TEST_F(Match, TheFileWithMostOfItIsTheRenamedOne) {
    const Matched matched = run({.baseline = {{"O1 MAC301 a", 1}, {"O1 MAC301 b", 1}},
                                 .findings = {{"O2 MAC301 a"}, {"O3 MAC301 a"}, {"O3 MAC301 b"}},
                                 .looked_at = {"O2", "O3"}});
    EXPECT_THAT(matched.known, ElementsAre(false, true, true));
}

TEST_F(Match, ThousandsOfFilesThatAreAlikeAreRenamedInTheOrderOfTheirNames) {
    Case what;
    for (int i = 10'000; i < 20'000; ++i) {
        const std::string number = std::to_string(i);
        what.baseline.emplace_back("old" + number + " MAC301 a", 1);
        what.findings.push_back({"new" + number + " MAC301 a"});
        what.looked_at.push_back("new" + number);
    }
    what.findings.push_back({"new20000 MAC301 a"});
    what.looked_at.emplace_back("new20000");
    const Matched matched = run(what);
    EXPECT_EQ(matched.renamed.size(), 10'000U);
    EXPECT_EQ(matched.renamed.back(), (Renamed{"old19999", "new19999"}));
    EXPECT_EQ(std::ranges::count(matched.known, true), 10'000);
}

TEST_F(Match, WhatManyFilesHaveInCommonSaysNotWhichWasRenamed) {
    Case what;
    for (int i = 10; i < 50; ++i) {
        what.baseline.emplace_back("old" + std::to_string(i) + " MAC301 a", 1);
        what.baseline.emplace_back("old" + std::to_string(i) + " MAC301 b", 1);
    }
    what.baseline.emplace_back("other MAC301 a", 1);
    what.baseline.emplace_back("other MAC301 c", 1);
    what.findings = {{"new MAC301 a"}, {"new MAC301 c"}, {"new MAC301 d"}, {"new2 MAC301 a"}};
    what.looked_at = {"new", "new2"};
    const Matched matched = run(what);
    EXPECT_THAT(matched.known, ElementsAre(true, true, false, false));
    EXPECT_THAT(matched.renamed, ElementsAre(Renamed{"other", "new"}));
}

TEST(OutOfSight, IsWhatTheRunDidNotLookFor) {
    RuleStates rules;
    rules.switch_off(rules_named("MAC501"), "");
    Baseline baseline;
    for (const char* words : {"O1 MAC301 a", "O1 MAC501 a", "O2 MAC301 a", "O3 MAC301 a"})
        baseline.push_back({.place = place(words), .block = {}});
    const Baseline others =
        out_of_sight(baseline, {{"O1", &rules}}, [](const std::string& name) { return name == "O2"; });
    ASSERT_EQ(others.size(), 2U);
    EXPECT_EQ(others[0].place, place("O1 MAC501 a"));
    EXPECT_EQ(others[1].place, place("O2 MAC301 a"));
}

} // namespace
} // namespace maclint::cli
