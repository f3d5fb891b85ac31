//! Which fixes one round takes.
#include "cli/fix/choose.hpp"
#include "tests/cli/reports.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using test::HandMade;
using testing::ElementsAre;
using testing::IsEmpty;

/// Offers the text in place of the bytes.
void offer(HandMade& made, Applicability applicability, Span span, const std::string& text) {
    Finding& finding = made.add("G0", Severity::error);
    finding.rule = find_rule("MAC106");
    finding.offer({"Write it", applicability, {{finding.source, span, text}}});
}

std::vector<std::string> chosen(HandMade& made, FixesWanted wanted) {
    std::vector<std::string> texts;
    const Report report = made.report();
    for (const FileChange& file :
         choose_fixes(report.findings, wanted, [](std::string_view) { return true; }))
        for (const Edit& edit : file.edits) texts.push_back(edit.text);
    return texts;
}

TEST(ChosenFixes, LeaveEachOtherAlone) {
    HandMade made("O1.nc", "O1\nG0 X10. Y20.\n");
    offer(made, Applicability::safe, {6, 10}, "first");
    offer(made, Applicability::safe, {8, 12}, "reaches into it");
    offer(made, Applicability::safe, {10, 10}, "meets it");
    offer(made, Applicability::safe, {11, 15}, "behind it");
    offer(made, Applicability::safe, {3, 5}, "before it");
    EXPECT_THAT(chosen(made, FixesWanted::safe), ElementsAre("before it", "first", "behind it"));
}

TEST(ChosenFixes, AreThoseThatAreWanted) {
    HandMade made("O1.nc", "O1\nG0 X10. Y20.\n");
    offer(made, Applicability::unsafe, {6, 10}, "look at it");
    EXPECT_THAT(chosen(made, FixesWanted::safe), IsEmpty());
    EXPECT_THAT(chosen(made, FixesWanted::all), ElementsAre("look at it"));
}

} // namespace
} // namespace maclint::cli
