//! What --fix and --diff do to files, with the built executable.
#include "tests/support/in_repository.hpp"

#include <filesystem>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The letter O stands in the number of line 3; a comment of line 4 allows what is not there.
constexpr std::string_view bad = "%\nO1000 (PLATE)\nG0 X1O.5\nG4 X1. (MACLINT ALLOW MAC301 - OLD)\nM30\n%\n";
constexpr std::string_view good = "%\nO1000 (PLATE)\nG0 X10.5\nG4 X1.\nM30\n%\n";

class FixedFiles : public InRepository {
  protected:
    [[nodiscard]] std::string text_of(const std::string& name) const {
        return read_file(folder.path() / name);
    }
};

TEST_F(FixedFiles, ChangeWhatIsSafeAndReportTheRest) {
    folder.write("a.nc", bad);
    const Finished finished = run({"--fix", "a.nc"});
    EXPECT_EQ(text_of("a.nc"), good);
    EXPECT_THAT(finished.err, HasSubstr("Fixed 2 findings in 1 file.\n"));
    EXPECT_THAT(finished.out, HasSubstr("no findings (1 checked)"));
    EXPECT_EQ(finished.status, 0);
    EXPECT_THAT(run({"--fix", "a.nc"}).err, HasSubstr("Fixed 0 findings"));
}

TEST_F(FixedFiles, AreShownAsADifferenceThatChangesNothing) {
    folder.write("a.nc", bad);
    const Finished finished = run({"--diff", "a.nc"});
    EXPECT_EQ(text_of("a.nc"), bad);
    EXPECT_EQ(finished.out, "--- a/a.nc\n+++ b/a.nc\n@@ -1,6 +1,6 @@\n %\n O1000 (PLATE)\n-G0 X1O.5\n"
                            "-G4 X1. (MACLINT ALLOW MAC301 - OLD)\n+G0 X10.5\n+G4 X1.\n M30\n %\n");
    EXPECT_EQ(finished.status, 1);
    folder.write("a.nc", good);
    EXPECT_THAT(run({"--diff", "a.nc"}).out, IsEmpty());
    EXPECT_EQ(run({"--diff", "a.nc"}).status, 0);
}

TEST_F(FixedFiles, KeepEncodingLineEndsAndAllOtherBytes) {
    folder.write("a.nc", "%\r\nO1000 (\xC4NDERN)\r\nG0  X1O.5 ; \r\nM30\r\n%");
    (void)run({"--fix", "a.nc"});
    EXPECT_THAT(text_of("a.nc"), HasSubstr("O1000 (\xC4NDERN)\r\nG0  X10.5 ; \r\nM30\r\n%"));
}

TEST_F(FixedFiles, AreMadeInShiftJisToo) {
    folder.write("a.nc", "%\nO1000 (\x83\x68\x83\x8A\x83\x8B\x8C\x8A\x89\xC1\x8D\x48)\nG0 X1O.5\nM30\n%\n");
    (void)run({"--fix", "a.nc"});
    EXPECT_EQ(text_of("a.nc"),
              "%\nO1000 (\x83\x68\x83\x8A\x83\x8B\x8C\x8A\x89\xC1\x8D\x48)\nG0 X10.5\nM30\n%\n");
}

TEST_F(FixedFiles, LeaveAFileThatMayNotBeWritten) {
    folder.write("a.nc", bad);
    using std::filesystem::perms;
    std::filesystem::permissions(folder.path(), perms::owner_all | perms::others_exec | perms::others_read);
    std::filesystem::permissions(folder.path() / "a.nc", perms::owner_all | perms::others_read);
    const auto ran = run_maclint_without_privileges(folder.path().string(), {"--fix", "a.nc"});
    if (!ran) GTEST_SKIP() << "nobody here has fewer rights";
    const Finished& finished = *ran;
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("it is not fixed"));
    EXPECT_EQ(text_of("a.nc"), bad);
    EXPECT_THAT(finished.out, HasSubstr("MAC106")) << "what is left is reported";
}

TEST_F(FixedFiles, DoNotFollowALinkOutOfTheTree) {
    folder.write("elsewhere/a.nc", bad);
    folder.write("tree/.git/HEAD", "");
    if (shell("ln -s ../elsewhere/a.nc tree/b.nc").status != 0) GTEST_SKIP() << "no links here";
    const Finished finished = run({"--fix", "--follow-links", "tree"});
    EXPECT_EQ(text_of("elsewhere/a.nc"), bad);
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("it is not fixed: it would be written through"));
}

TEST_F(FixedFiles, ThatAreNotSafeWantAnOptionOfTheirOwn) {
    folder.write("a.nc", "%\nO1000\nG0 X1,5\nM30\n%\n");
    (void)run({"--fix", "a.nc"});
    EXPECT_EQ(text_of("a.nc"), "%\nO1000\nG0 X1,5\nM30\n%\n");
    (void)run({"--fix", "--unsafe-fixes", "a.nc"});
    EXPECT_EQ(text_of("a.nc"), "%\nO1000\nG0 X1.5\nM30\n%\n");
}

TEST_F(FixedFiles, MayEndTheirLinesByCarriageReturns) {
    folder.write("a.nc", "%\rO1000\rG90 G54\rG67\rG0 X1O.\rG65 P1\rG81 Z-5. R2.\rT2 M6\rM30\r%\r");
    (void)run({"--fix", "--unsafe-fixes", "--select", "MAC106,MAC414,MAC569", "a.nc"});
    EXPECT_EQ(text_of("a.nc"), "%\rO1000\rG90 G54\rG0 X10.\rG65 P1\rG81 Z-5. R2.\rG80\rT2 M6\rM30\r%\r");
}

TEST_F(FixedFiles, AreShownByOneHunkForEachPlaceUpToALastLineWithoutItsEnd) {
    std::string text = "%\nO1000\nG0 X1O.\n";
    for (int i = 1; i <= 9; ++i) text += "X" + std::to_string(i) + ".\n";
    folder.write("a.nc", text + "G0 X2O.");
    const Finished finished = run({"--diff", "--select", "MAC106", "a.nc"});
    EXPECT_EQ(finished.out, "--- a/a.nc\n+++ b/a.nc\n"
                            "@@ -1,6 +1,6 @@\n %\n O1000\n-G0 X1O.\n+G0 X10.\n X1.\n X2.\n X3.\n"
                            "@@ -10,4 +10,4 @@\n X7.\n X8.\n X9.\n-G0 X2O.\n\\ No newline at end of file\n"
                            "+G0 X20.\n\\ No newline at end of file\n");
    folder.write("a.nc", "%\nO1000\nG0 X5.");
    EXPECT_THAT(
        run({"--diff", "--unsafe-fixes", "--select", "MAC455", "a.nc"}).out,
        HasSubstr("-G0 X5.\n\\ No newline at end of file\n+G0 X5.\n+M30\n\\ No newline at end of file\n"));
}

TEST_F(FixedFiles, KeepACommentThatAllowsWhatOnlyTheFixUncovers) {
    folder.write(
        "a.nc",
        "%\nO1000\n(MACLINT ALLOW MAC303 - WANTED)\nGOTO 2O\nWHILE[#1LT5]DO1\nN20 #1=#1+1\nEND1\nM30\n%\n");
    const Finished finished = run({"--fix", "--select", "MAC001,MAC106,MAC303,MAC305", "a.nc"});
    EXPECT_THAT(text_of("a.nc"), HasSubstr("(MACLINT ALLOW MAC303 - WANTED)\nGOTO 20\n"));
    EXPECT_THAT(finished.out, HasSubstr("1 allowed by comments"));
}

TEST_F(FixedFiles, TakeOneFixThatDoesNotHelpOnceAndAllOthers) {
    folder.write(
        "a.nc",
        "%\nO1000\nG90 G54 G0 X1O.5\nIF[#500EQ1]GOTO50\nG81 Z-5. R2. F100.\nX10.\nN50 T2 M6\nM30\n%\n");
    const Finished finished = run({"--fix", "--unsafe-fixes", "--select", "MAC106,MAC569", "a.nc"});
    EXPECT_THAT(text_of("a.nc"), HasSubstr("G0 X10.5\n"));
    EXPECT_THAT(text_of("a.nc"), HasSubstr("X10.\nN50 G80\nT2 M6\nM30\n")) << "a jump to N50 runs it, too";
    EXPECT_THAT(finished.err, Not(HasSubstr("left as it was")));
}

TEST_F(FixedFiles, MendAllPlacesOfOneFindingWhateverTheirTexts) {
    std::string text = "MACHINING\n";
    for (int i = 1; i <= 40; ++i)
        text +=
            "N" + std::to_string(i) + " G1 X6" + std::to_string(i) + " (PASS " + std::to_string(i) + ")\n";
    folder.write("a.nc", text + "N99 M30\nEND\n");
    EXPECT_THAT(run({"--fix", "--dialect", "dinplus", "--select", "DIN013", "a.nc"}).err,
                HasSubstr("in 1 file.\n"));
    EXPECT_THAT(text_of("a.nc"), HasSubstr("N40 G1 X640 [PASS 40]\n"));
    EXPECT_THAT(text_of("a.nc"), Not(HasSubstr("(PASS")));
}

TEST_F(FixedFiles, AreOfferedInTheSummary) {
    folder.write("a.nc", bad);
    EXPECT_THAT(run({"a.nc"}).out, HasSubstr("\n2 findings can be corrected by --fix; --diff shows how\n"));
    folder.write("a.nc", good);
    EXPECT_THAT(run({"a.nc"}).out, Not(HasSubstr("--fix")));
}

TEST_F(FixedFiles, LeaveFindingsAloneThatDoNotCount) {
    const std::string allowed = "%\nO1000\nG0 X1O.5 (MACLINT ALLOW MAC106 - READ BY ANOTHER SYSTEM)\n";
    folder.write("a.nc", allowed + "G0 Y1O.\nM30\n%\n");
    (void)run({"--fix", "a.nc"});
    EXPECT_EQ(text_of("a.nc"), allowed + "G0 Y10.\nM30\n%\n");
}

TEST_F(FixedFiles, RefuseWhatMakesNoSense) {
    EXPECT_THAT(run({"--unsafe-fixes", "."}).err, HasSubstr("Write --fix or --diff beside it."));
    EXPECT_THAT(run({"--fix", "--diff", "."}).err, HasSubstr("exclude each other"));
    EXPECT_THAT(run({"--fix", "-"}, "%\n").err, HasSubstr("--fix does not take standard input."));
    EXPECT_THAT(run({"--diff", "--format", "json", "."}).err, HasSubstr("--diff prints a difference"));
    EXPECT_THAT(run({"--fix", "--write-baseline", "b.json", "."}).err, HasSubstr("exclude each other"));
}

} // namespace
} // namespace maclint::test
