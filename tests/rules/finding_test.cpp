//! What a finding takes as its fix, and when two have one cause.
#include "analyzer/dataflow/facts/read.hpp"
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/program/model.hpp"
#include "rules/finding_order.hpp"
#include "rules/rule.hpp"
#include "tests/support/analysed.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

std::shared_ptr<const Source> source(std::string path) {
    return std::make_shared<const Source>(Source::from_bytes(std::move(path), "0123456789"));
}

Finding finding_at(const std::shared_ptr<const Source>& file, Span span) {
    ProgramFile program;
    program.source = file;
    Reporter reporter(*find_rule("MAC002"));
    return reporter.report({program, span}, span, "unknown", {"X"});
}

/// The spans that the finding keeps of a fix with these; none when it refuses it.
std::vector<std::pair<Offset, Offset>> kept(std::vector<Edit> edits) {
    Finding finding = finding_at(nullptr, {});
    finding.offer({"Change it", Applicability::safe, std::move(edits)});
    std::vector<std::pair<Offset, Offset>> spans;
    for (const Fix& fix : finding.fixes)
        for (const Edit& edit : fix.edits) spans.emplace_back(edit.span.begin, edit.span.end);
    return spans;
}

/// "safe Write 0: 0-1 4-5", for each fix.
std::vector<std::string> fixes_of(const Finding& finding) {
    std::vector<std::string> all;
    for (const Fix& fix : finding.fixes) {
        std::string text = std::string(name_of(fix.applicability)) + " " + fix.title + ":";
        for (const Edit& edit : fix.edits)
            text += " " + std::to_string(edit.span.begin) + "-" + std::to_string(edit.span.end);
        all.push_back(std::move(text));
    }
    return all;
}

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

TEST(Fix, EditsAreInTheOrderOfTheText) {
    const auto a = source("A.nc");
    const auto b = source("B.nc");
    EXPECT_THAT(kept({{a, {4, 6}, "x"}, {a, {0, 2}, ""}}), ElementsAre(Pair(0, 2), Pair(4, 6)));
    EXPECT_THAT(kept({{b, {0, 1}, "x"}, {a, {5, 6}, ""}}), ElementsAre(Pair(5, 6), Pair(0, 1)));
}

TEST(Fix, EditsOfTheSameBytesAreRefused) {
    const auto a = source("A.nc");
    const auto b = source("B.nc");
    EXPECT_THAT(kept({{a, {0, 3}, "x"}, {a, {2, 4}, "y"}}), IsEmpty());
    EXPECT_THAT(kept({{a, {0, 9}, "x"}, {a, {2, 4}, "y"}, {a, {9, 10}, "z"}}), IsEmpty());
    EXPECT_THAT(kept({{a, {3, 3}, "x"}, {a, {3, 3}, "y"}}), IsEmpty()) << "which comes first?";
    EXPECT_THAT(kept({{a, {3, 3}, "x"}, {a, {3, 5}, "y"}}), IsEmpty()) << "which comes first?";
    EXPECT_THAT(kept({{a, {0, 3}, "x"}, {a, {3, 4}, "y"}}), ElementsAre(Pair(0, 3), Pair(3, 4)));
    EXPECT_THAT(kept({{a, {0, 3}, "x"}, {b, {0, 3}, "y"}}), ElementsAre(Pair(0, 3), Pair(0, 3)));
}

TEST(Fix, OneThatChangesNothingIsNone) { EXPECT_THAT(kept({}), IsEmpty()); }

TEST(Fix, AFindingMayHaveSeveralTheBestFirst) {
    const auto a = source("A.nc");
    Finding finding = finding_at(a, {0, 1});
    finding.offer({"Write 0", Applicability::safe, {{a, {0, 1}, "0"}}});
    finding.offer({"Do nothing", Applicability::safe, {}});
    finding.offer({"Remove it", Applicability::unsafe, {{a, {0, 2}, ""}}});
    EXPECT_THAT(fixes_of(finding), ElementsAre("safe Write 0: 0-1", "unsafe Remove it: 0-2"));
}

TEST(Fix, OfOneTitleInSeveralPlacesIsOne) {
    const auto a = source("A.nc");
    const auto at = [&](Offset place, const char* title, Applicability applicability) {
        Finding finding = finding_at(a, {place, place + 1});
        finding.offer({title, applicability, {{a, {place, place + 1}, "0"}}});
        return finding;
    };
    Finding first = at(0, "Write 0", Applicability::safe);
    first.add_repeat(at(2, "Write 0", Applicability::safe));
    EXPECT_THAT(fixes_of(first), ElementsAre("safe Write 0: 0-1 2-3"));
    first.add_repeat(finding_at(a, {3, 4}));
    first.add_repeat(at(4, "Remove it", Applicability::safe));
    first.add_repeat(at(6, "Write 0", Applicability::unsafe));
    EXPECT_THAT(fixes_of(first), ElementsAre("unsafe Write 0: 0-1 2-3 6-7", "safe Remove it: 4-5"))
        << "what somebody should look at in one place is looked at as a whole";
    ASSERT_EQ(first.repeats.size(), 4U);
    EXPECT_EQ(first.repeats[2].span, (Span{4, 5}));
}

TEST(Fix, TheChangeOfALaterPlaceThatReachesIntoAnotherIsLeftOut) {
    const auto a = source("A.nc");
    Finding first = finding_at(a, {0, 1});
    first.offer({"Write 0", Applicability::safe, {{a, {0, 4}, "0"}}});
    Finding later = finding_at(a, {2, 3});
    later.offer({"Write 0", Applicability::unsafe, {{a, {3, 5}, "0"}}});
    first.add_repeat(std::move(later));
    EXPECT_THAT(fixes_of(first), ElementsAre("safe Write 0: 0-4"));
    EXPECT_EQ(first.repeats.size(), 1U);
}

TEST(Findings, ArePutInTheOrderOfReportsAndEqualOnesStayAsTheyAre) {
    struct Numbered {
        Finding finding;
        int number;
    };
    const ProgramFile file{};
    Reporter reporter(*find_rule("MAC002"));
    std::vector<Numbered> all;
    for (const auto& [path, begin] : {std::pair("B.nc", 5), std::pair("A.nc", 7), std::pair("A.nc", 1),
                                      std::pair("B.nc", 5), std::pair("A.nc", 3), std::pair("C.nc", 0)}) {
        Finding finding = reporter.report({file, {}}, {}, "unknown", {"X"});
        finding.source = source(path);
        finding.span = {static_cast<Offset>(begin), static_cast<Offset>(begin + 1)};
        all.push_back({std::move(finding), static_cast<int>(all.size())});
    }
    put_in_order(all, &Numbered::finding);
    std::vector<int> order;
    for (const Numbered& each : all) order.push_back(each.number);
    EXPECT_THAT(order, ElementsAre(2, 4, 1, 0, 3, 5));
    EXPECT_TRUE(std::ranges::is_sorted(all, comes_before, &Numbered::finding));
}

TEST(Message, AnErrorNamesTheAlarmOfItsControlAndTheCureComesLast) {
    const auto message = [](const char* control) {
        const ControlModel* model = find_control(control);
        ProgramFile file;
        file.control = model;
        Reporter reporter(*find_rule("MAC312"));
        Finding& finding = reporter.report({file, {}}, {}, "plain", {"DO1"});
        EXPECT_EQ(finding.cure(), "Add the END after the loop's last block.");
        EXPECT_EQ(finding.message(), finding.statement() + " " + finding.cure());
        return finding.statement();
    };
    EXPECT_EQ(message("fanuc"),
              "Missing END: 'DO1' is never closed, and the control stops here (alarm 124).");
    EXPECT_EQ(message("haas"), "Missing END: 'DO1' is never closed, and the control stops here.");
}

TEST(Path, AJumpThatAConditionDecidesIsOneStep) {
    const auto workspace =
        test::analyse_files({{"O1.nc", "O1\n#3=#4003\nIF[#1EQ1]GOTO5\n#5=1\nN5 #2=#3*2\nM99\n"}}, {false, 1});
    const auto findings = run_rules(*workspace, {{find_rule("MAC574")}}, 1);
    ASSERT_EQ(findings.size(), 1U);
    std::vector<std::string> steps;
    for (const RelatedLocation& step : findings[0].path) steps.push_back(step.text);
    EXPECT_THAT(steps, ElementsAre(testing::_, "true: jumps to line 5", testing::_));
}

TEST(Needs, ARuleIsNotAskedWhereTheLanguageLacksWhatItSpeaksOf) {
    const auto asked = [](std::string_view code, const char* control) {
        return applies_to(*find_rule(code), *find_control(control));
    };
    EXPECT_TRUE(asked("MAC312", "fanuc")); // DO without END
    EXPECT_FALSE(asked("MAC312", "dinplus"));
    EXPECT_TRUE(asked("DIN102", "dinplus")); // no END
    EXPECT_FALSE(asked("DIN102", "fanuc"));
    EXPECT_TRUE(asked("MAC559", "fanuc-16i")); // an address twice
    EXPECT_TRUE(asked("MAC559", "dinplus"));
    EXPECT_TRUE(asked("MAC413", "fanuc-16i")); // modal calls
    EXPECT_FALSE(asked("MAC413", "dinplus"));
    EXPECT_TRUE(asked("MAC301", "fanuc")); // jumps
    EXPECT_FALSE(asked("MAC301", "dinplus"));
    EXPECT_TRUE(asked("MAC402", "dinplus")); // a program that is not there, in any language
}

TEST(Needs, OfARuleAreAskedBeforeItRuns) {
    const auto found = [](const std::string& blocks, std::string_view code) {
        const auto workspace = test::analyse_text("dinplus", "MACHINING\n" + blocks + "M30\n");
        return run_rules(*workspace, {{find_rule(code)}}, 1).size();
    };
    EXPECT_EQ(found("WHILE #l1<5\n", "MAC312"), 0U); // DIN PLUS has its own rule
    EXPECT_EQ(found("G66 P5\n", "MAC413"), 0U);      // nothing calls so
}

TEST(Cause, IsTheSameEffectOrAnExpressionInIt) {
    const auto workspace = test::analyse_fanuc("O0001\n#1=#2+#3\n#4=#5\nM30\n");
    const ProgramAnalysis& analysis = workspace->programs().front();
    const Cause whole{analysis, EffectId{0}};
    const Cause one{analysis, EffectId{0}, ExpressionId{0}};
    const Cause other{analysis, EffectId{0}, ExpressionId{1}};
    const Cause another{analysis, EffectId{1}};
    EXPECT_TRUE(whole.is_same(whole));
    EXPECT_TRUE(whole.is_same(one));
    EXPECT_TRUE(one.is_same(whole));
    EXPECT_FALSE(one.is_same(other));
    EXPECT_FALSE(whole.is_same(another));
    const auto& read = analysis.facts().all<dataflow::Read>().back();
    EXPECT_EQ(Cause(analysis, read).effect, EffectId{1});
    EXPECT_EQ(Cause(analysis, read).expression, read.expression);
}

TEST(Cause, OfTextIsTheSameText) {
    const auto workspace = test::analyse_fanuc("O0001\nG1X1\nM30\nO0002\nM99\n");
    const ProgramAnalysis& first = workspace->programs()[0];
    const ProgramAnalysis& second = workspace->programs()[1];
    const Span word{6, 8};
    EXPECT_TRUE(Cause(first, word).is_same({first, word}));
    EXPECT_FALSE(Cause(first, word).is_same({first, {8, 10}}));
    EXPECT_FALSE(Cause(first, word).is_same({second, word}));
    EXPECT_FALSE(Cause(first, word).is_same({first.file(), word}));
    EXPECT_TRUE(Cause(first.file(), word).is_same({second.file(), word}));
    EXPECT_FALSE(Cause(first, first.program().effects[0].span).is_same({first, EffectId{0}}));
}

} // namespace
} // namespace maclint
