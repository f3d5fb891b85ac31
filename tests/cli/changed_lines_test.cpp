//! What git's differences say about lines.
#include "analyzer/source/platform/process.hpp"
#include "cli/gate/changed_lines.hpp"

#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

std::map<std::string, std::vector<LineRange>> ranges_in(std::string_view diff, std::size_t part = 1) {
    DiffReader reader;
    for (; !diff.empty(); diff.remove_prefix(std::min(part, diff.size()))) reader.take(diff.substr(0, part));
    return reader.finish();
}

constexpr std::string_view header =
    "diff --git a/O1.nc b/O1.nc\nindex 1..2 100644\n--- a/O1.nc\n+++ b/O1.nc\n";

TEST(Diff, TellsLinesThatWereChangedOrAdded) {
    const std::string diff = std::string(header) + "@@ -2 +2,2 @@ O1\n-G0\n+G1\n+G2\n@@ -9,0 +11 @@\n+M9\n";
    EXPECT_THAT(ranges_in(diff), ElementsAre(Pair("O1.nc", ElementsAre(LineRange{2, 3}, LineRange{11, 11}))));
}

TEST(Diff, TellsTheLinesAroundWhatIsGone) {
    EXPECT_THAT(ranges_in(std::string(header) + "@@ -1 +0,0 @@\n-O1\n@@ -5,2 +3,0 @@\n-A\n-B\n"),
                ElementsAre(Pair("O1.nc", ElementsAre(LineRange{1, 1}, LineRange{3, 4}))));
}

TEST(Diff, TakesNoLineOfAProgramForAHeader) {
    const std::string diff = std::string(header) +
                             "@@ -1,2 +1 @@\n--- a/X\n-@@ -7 +7 @@\n+++ b/Y\n\\ No newline at end of file\n"
                             "@@ -8 +8 @@\n-A\n+B\n";
    EXPECT_THAT(ranges_in(diff), ElementsAre(Pair("O1.nc", ElementsAre(LineRange{1, 1}, LineRange{8, 8}))));
}

TEST(Diff, ReadsNamesInQuotesAndWithBlanks) {
    EXPECT_THAT(ranges_in("+++ \"b/a\\tb \\\"\\303\\274\\\"\\\\\\n.nc\"\n@@ -1 +1 @@\n-A\n+B\n"),
                ElementsAre(Pair("a\tb \"\xC3\xBC\"\\\n.nc", ElementsAre(LineRange{1, 1}))));
    EXPECT_THAT(ranges_in("+++ b/gr\xC3\xB6\xC3\x9F"
                          "er 2.nc\t\n@@ -1 +1 @@\n-A\n+B\n"),
                ElementsAre(Pair("gr\xC3\xB6\xC3\x9F"
                                 "er 2.nc",
                                 ElementsAre(LineRange{1, 1}))));
    EXPECT_THAT(ranges_in("+++ /dev/null\n@@ -1 +0,0 @@\n-A\n"), IsEmpty());
}

TEST(Diff, ReadsPartsAsTheWhole) {
    const std::string diff =
        std::string(header) + "@@ -2 +2 @@\n-" + std::string(200'000, 'A') + "\n+B\n@@ -9 +9 @@\n-A\n+B\n";
    EXPECT_EQ(ranges_in(diff, 7), ranges_in(diff, diff.size()));
    EXPECT_THAT(ranges_in(diff, 65'536),
                ElementsAre(Pair("O1.nc", ElementsAre(LineRange{2, 2}, LineRange{9, 9}))));
}

TEST(Process, GivesOutputErrorsAndStatus) {
    std::string out;
    const auto end = platform::run_process(
        {"sh", "-c", "printf '%s' \"$1\"; cat; echo no >&2; exit 3", "sh", "a 'b\" $c\n"},
        [&](std::string_view part) { out += part; });
    EXPECT_TRUE(end.started);
    EXPECT_EQ(end.status, 3);
    EXPECT_EQ(out, "a 'b\" $c\n");
    EXPECT_EQ(end.errors, "no\n");
}

TEST(Process, ReadsMoreThanPipesHold) {
    std::size_t size = 0;
    const auto end =
        platform::run_process({"sh", "-c", "yes o | head -c 300000; yes e | head -c 300000 >&2; kill -9 $$"},
                              [&](std::string_view part) { size += part.size(); });
    EXPECT_EQ(size, 300'000U);
    EXPECT_EQ(end.errors.size(), 4096U);
    EXPECT_EQ(end.status, 137);
}

/// Services start programs that way; the system then keeps no exit status.
TEST(Process, GivesTheStatusThoughWhoStartedItIgnoresEnds) {
    auto* const before = std::signal(SIGCHLD, SIG_IGN);
    const auto end = platform::run_process({"sh", "-c", "exit 3"}, [](std::string_view) {});
    EXPECT_EQ(end.status, 3);
    EXPECT_EQ(std::signal(SIGCHLD, before), SIG_IGN);
}

TEST(Process, TellsThatThereIsNoSuchProgram) {
    EXPECT_FALSE(platform::run_process({"maclint-no-such-program"}, [](std::string_view) {}).started);
}

} // namespace
} // namespace maclint::cli
