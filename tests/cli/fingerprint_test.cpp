//! Fingerprints: GitHub's line hash, known from its own tests, and maclint's.
#include "cli/report/fingerprint.hpp"
#include "tests/cli/reports.hpp"
#include "tests/support/linted.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using testing::ElementsAre;

std::vector<std::string> hashes(const std::string& text, std::uint32_t lines) {
    std::set<std::uint32_t> wanted;
    for (std::uint32_t line = 1; line <= lines; ++line) wanted.insert(line);
    std::vector<std::string> all;
    for (const auto& [line, hash] : line_hashes(Source::from_bytes("a.nc", text), wanted))
        all.push_back(hash);
    return all;
}

// Expected values: github/codeql-action, src/fingerprints.test.ts.
TEST(LineHash, IsThatOfTheUploadAction) {
    EXPECT_THAT(hashes("", 1), ElementsAre("c129715d7a2bc9a3:1"));
    EXPECT_THAT(hashes(" a\nb\n  \t\tc\n d", 4), ElementsAre("271789c17abda88f:1", "54703d4cd895b18:1",
                                                             "180aee12dab6264:1", "a23a3dc5e078b07b:1"));
}

TEST(LineHash, CountsAllLineEndsAsOne) {
    const std::string lf = " hello; \t\nworld!!!\n\n\n  \t\tGreetings\n End\n";
    const std::string mixed = " hello; \t\nworld!!!\r\n\n\r  \t\tGreetings\r End\r\n";
    EXPECT_EQ(hashes(lf, 7), hashes(mixed, 7));
    EXPECT_EQ(hashes(lf, 7).front(), "e9496ae3ebfced30:1");
}

TEST(LineHash, NumbersLinesThatAreAlike) {
    std::string text;
    for (int i = 0; i < 10; ++i) text += "Lorem ipsum dolor sit amet.\n";
    EXPECT_THAT(hashes(text, 3),
                ElementsAre("a7f2ff13bc495cf2:1", "a7f2ff13bc495cf2:2", "a7f2ff13bc495cf2:3"));
}

std::vector<std::string> fingerprints(const std::string& text) {
    const auto result = test::lint_text(text);
    Fingerprints prints;
    std::vector<std::string> all;
    for (const auto& filtered : result.findings) all.push_back(prints.of(filtered.finding));
    return all;
}

TEST(Fingerprint, StaysWhenTheLineMovesOrIsSpacedOtherwise) {
    EXPECT_EQ(fingerprints("O1\nGOTO 99\nM30\n"), fingerprints("O1\n(NEW)\n  goto  99\nM30\n"));
}

TEST(Fingerprint, StaysWhenTheProgramIsNumberedOtherwise) {
    EXPECT_EQ(fingerprints("O1\nN10 GOTO 99\nN20 M30\n"), fingerprints("O1\nN5 GOTO 99\nN15 M30\n"));
}

TEST(Fingerprint, TellsFindingsOfOneBlockApart) {
    test::HandMade made("O1.nc", "O1\nG1 X#1 Y#2\nG1 X#1 Y#3\n");
    Fingerprints prints;
    const std::string first = prints.of(made.add("#1", Severity::error));
    EXPECT_NE(first, prints.of(made.add("#2", Severity::error)));
    EXPECT_NE(first, prints.of_place(made.add("#1", Severity::error), made.place_of("#1 Y#3")));
    EXPECT_EQ(first, prints.of_place(made.add("#1", Severity::error), made.place_of("#1")) + ":1");
}

TEST(Fingerprint, NumbersFindingsThatAreAlike) {
    const auto prints = fingerprints("O1\nG1 X1. F9. F8.\nG1 X1. F9. F8.\nM30\n");
    ASSERT_EQ(prints.size(), 2U);
    EXPECT_NE(prints[0], prints[1]);
    EXPECT_TRUE(prints[0].ends_with(":1"));
    EXPECT_TRUE(prints[1].ends_with(":2"));
}

} // namespace
} // namespace maclint::cli
