//! Who types does not wait for the programs of a group that is being analysed.
#include "analyzer/workspace/analyse_until.hpp"
#include "rules/bounds_met.hpp"
#include "rules/rule.hpp"
#include "tests/support/analysed.hpp"

#include <stop_token>
#include <vector>

#include <gtest/gtest.h>

namespace maclint {
namespace {

const test::NamedText looping{"x.nc", "O1\nGOTO 99\nM30\n"};

TEST(AnalyseUntil, GivesNothingOnceSomebodyAsksToStop) {
    const auto workspace = test::analyse_files({looping}, {.complete = false, .jobs = 1});
    const std::vector<WorkspaceFile> files(workspace->files().begin(), workspace->files().end());
    std::stop_source source;
    EXPECT_NE(analyse_until(source.get_token(), files, {.jobs = 1}), nullptr);
    source.request_stop();
    EXPECT_EQ(analyse_until(source.get_token(), files, {.jobs = 1}), nullptr);
}

TEST(AnalyseUntil, RunsNoRuleOnceSomebodyAsksToStop) {
    const auto workspace = test::analyse_files({looping}, {.complete = false, .jobs = 1});
    const Selection selection{{find_rule("MAC301")}};
    std::vector<BoundMet> met;
    std::stop_source source;
    EXPECT_EQ(run_rules(*workspace, selection, 1, met, source.get_token()).size(), 1U);
    source.request_stop();
    EXPECT_TRUE(run_rules(*workspace, selection, 1, met, source.get_token()).empty());
}

} // namespace
} // namespace maclint
