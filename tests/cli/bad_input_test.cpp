//! What bad input gets from the executable: findings or one line on standard error, and every other file is
//! linted all the same.
#include "tests/support/bad_input.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;
using namespace std::string_literals;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::string replaced(std::string_view text, std::string_view line_end) {
    std::string out;
    for (const char c : text) {
        if (c == '\n')
            out += line_end;
        else
            out += c;
    }
    return out;
}

/// Lints bytes under a name beside the neighbour.
class BadBytes : public BadInput {
  protected:
    [[nodiscard]] std::vector<std::string> findings_in(std::string_view bytes) const {
        folder.write("bad.nc", bytes);
        const Finished finished = lint({"."});
        EXPECT_EQ(finished.status, 1);
        EXPECT_THAT(finished.err, IsEmpty());
        return codes(finished, "bad.nc");
    }
    [[nodiscard]] std::vector<std::string> findings_in_fixture(const std::string& name) const {
        return findings_in(read_file(fs::path(MACLINT_SOURCE_DIR) / "tests/fixtures/bad-input" / name));
    }
};

TEST_F(BadInput, EmptyFile) {
    take_fixture("empty.nc");
    for (const std::vector<std::string>& paths : {std::vector{"."s}, {"empty.nc"s, "neighbour.nc"s}}) {
        const Finished finished = lint(paths);
        EXPECT_EQ(finished.status, 1);
        EXPECT_THAT(lines_of(finished.err),
                    ElementsAre("maclint: note: empty.nc: this file is empty, so there is nothing to "
                                "check. Fetch it again if it should hold a program."));
    }
}

TEST_F(BadBytes, SeventyThousandCommentsInOneBlock) {
    std::string comments;
    for (int i = 0; i < 70'000; ++i) comments += "()";
    EXPECT_THAT(findings_in("%\nO1\n#1=5" + comments + "\nGOTO 99\nM30\n%\n"),
                ElementsAre("3:1 MAC004", "4:1 MAC301"));
    EXPECT_THAT(findings_in("%\nO1\nG0 X5." + comments + "\nGOTO 99\nM30\n%\n"), ElementsAre("4:1 MAC301"));
}

TEST_F(BadInput, FolderWithoutPrograms) {
    folder.write("bare/part.old", "G0 X1.\n");
    const Finished finished = lint({"bare", "neighbour.nc"});
    EXPECT_EQ(finished.status, 1);
    EXPECT_THAT(
        lines_of(finished.err),
        ElementsAre(AllOf(StartsWith("maclint: note: bare: no NC program is in this folder (1 file with "
                                     "another name passed over). "),
                          HasSubstr("include"))));
}

TEST_F(BadInput, FileWithoutPermission) {
    fs::permissions(folder.path(), fs::perms::others_read | fs::perms::others_exec, fs::perm_options::add);
    fs::permissions(folder.write("secret.nc", with_defect), fs::perms::none);
    const auto finished =
        run_maclint_without_privileges(folder.path().string(), {"--format", "concise", "."});
    if (!finished) GTEST_SKIP() << "the executable cannot be started by a user who may not read everything";
    EXPECT_EQ(finished->status, 2);
    EXPECT_THAT(codes(*finished, "neighbour.nc"), ElementsAre("4:1 MAC301"));
    EXPECT_THAT(lines_of(finished->err),
                ElementsAre("maclint: error: secret.nc: cannot be read: you have no permission. "
                            "Ask its owner for read access or leave the file out."));
}

TEST_F(BadInput, LoopsOfFoldersAndLinks) {
    fs::create_directories(folder.path() / "a");
    fs::create_directory_symlink(folder.path(), folder.path() / "a/up");
    fs::create_symlink("../neighbour.nc", folder.path() / "a/again.nc");
    fs::create_symlink("O-loop.nc", folder.path() / "a/O-loop.nc");
    const Finished finished =
        run_maclint(folder.path().string(), {"--format", "concise", "--quiet", "neighbour.nc", ".", "a"}, "");
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(lines_of(finished.out), ElementsAre(StartsWith("neighbour.nc:4:1: error[MAC301]")));
    EXPECT_THAT(
        lines_of(finished.err),
        ElementsAre(HasSubstr("O-loop.nc: cannot be read: its symbolic links lead in a circle. Mend")));
}

TEST_F(BadInput, TwoHundredMegabytesWithADefectInTheLastBlock) {
#ifdef __SANITIZE_ADDRESS__
    constexpr std::size_t bytes = 4'000'000;
#else
    constexpr std::size_t bytes = 200'000'000;
#endif
    std::string pass = "G1 F2400\n";
    std::size_t lines = 1;
    for (int x = 0; pass.size() < 1'000'000; x = (x + 37) % 9000, ++lines)
        pass += "X" + std::to_string(x / 100.0) + " Y-" + std::to_string(x % 700) + ". Z-0.125\n";
    std::ofstream mould(folder.path() / "mould.nc", std::ios::binary);
    mould << "%\nO2000 (MOULD)\nG90 G54 G0 X0 Y0 S9000 M3\n";
    std::size_t last = 4;
    for (std::size_t written = 0; written < bytes; written += pass.size(), last += lines) mould << pass;
    mould << "GOTO 99";
    mould.close();
    const Finished finished = lint({"."});
    EXPECT_EQ(finished.status, 1);
    EXPECT_THAT(finished.err, IsEmpty());
    EXPECT_THAT(codes(finished, "mould.nc"), ElementsAre(std::to_string(last) + ":1 MAC301"));
}

TEST_F(BadInput, BinaryFile) {
    take_fixture("png-header.nc");
    const Finished named = lint({"neighbour.nc", "png-header.nc"});
    EXPECT_EQ(named.status, 1);
    EXPECT_THAT(codes(named, "png-header.nc"), ElementsAre("1:1 MAC003"));
    EXPECT_THAT(named.err, IsEmpty());
    const Finished found = lint({"."});
    EXPECT_THAT(codes(found, "png-header.nc"), IsEmpty());
    EXPECT_THAT(lines_of(found.err),
                ElementsAre(StartsWith(
                    "maclint: note: png-header.nc: this is not linted: a binary file (PNG image). ")));
}

TEST_F(BadInput, TextOfAnotherKind) {
    for (const char* name : {"klartext-named.nc", "c-source.nc", "json.nc"}) take_fixture(name);
    const Finished found = lint({"."});
    EXPECT_EQ(found.status, 1);
    EXPECT_THAT(
        lines_of(found.err),
        ElementsAre(
            AllOf(StartsWith("maclint: note: c-source.nc: this is not linted: "), HasSubstr("--dialect")),
            AllOf(StartsWith("maclint: note: json.nc: this is not linted: JSON"), HasSubstr("--dialect")),
            AllOf(StartsWith("maclint: note: klartext-named.nc: this is not linted: "), HasSubstr("Klartext"),
                  HasSubstr("on line 1"), HasSubstr("--dialect"))));
    const Finished named = lint({"neighbour.nc", "c-source.nc", "json.nc"});
    EXPECT_THAT(codes(named, "c-source.nc"), ElementsAre("1:1 MAC003"));
    EXPECT_THAT(codes(named, "json.nc"), ElementsAre("1:1 MAC003"));
}

TEST_F(BadBytes, LineOfTenMegabytes) {
    const std::string brackets = "%\nO1\n#1=" + repeated("[1+", 10'000'000) + "\nGOTO 99\nM30\n%\n";
    EXPECT_THAT(findings_in(brackets), ElementsAre("3:1 MAC004", "4:1 MAC301"));
    const std::string words = "%\nO1\n" + repeated("X1.Y2. ", 10'000'000) + "\nGOTO 99\nM30\n%\n";
    // The last of 1,428,572 pieces of seven bytes begins with the X that the control takes.
    EXPECT_THAT(findings_in(words), ElementsAre("3:9999998 MAC559", "4:1 MAC301"));
}

/// Between two programs that have a defect each: the lines of both, and how much was found in all.
void expect_both_found(const std::vector<std::string>& found, const std::string& noise,
                       std::size_t in_noise) {
    const auto lines = std::count(noise.begin(), noise.end(), '\n');
    EXPECT_GT(found.size(), in_noise);
    EXPECT_THAT(found, testing::Contains("3:1 MAC301"));
    EXPECT_THAT(found, testing::Contains(std::to_string(lines + 8) + ":1 MAC301"));
}

TEST_F(BadBytes, MegabyteOfLineNoiseBetweenTwoGoodPrograms) {
    const auto between_programs = [](const std::string& noise) {
        return "O1001 (ONE)\nG0 X1.\nGOTO 98\nM30\n" + noise + "\nO1002 (TWO)\nG0 X1.\nGOTO 99\nM30\n";
    };
    std::mt19937 random(7);
    std::string noise(1 << 20, ' ');
    for (char& c : noise) c = random() % 64 == 0 ? '\n' : static_cast<char>(' ' + random() % 95);
    expect_both_found(findings_in(between_programs(noise)), noise, 2);
    for (char& c : noise) c = static_cast<char>(random());
    std::ranges::replace(noise, '\r', ' '); // only LF ends a line here, so that lines can be counted
    expect_both_found(findings_in(between_programs(noise)), noise, 2);
}

TEST_F(BadBytes, UnclosedComment) {
    EXPECT_THAT(findings_in_fixture("unclosed-comment.nc"), ElementsAre("2:7 MAC102")) << "one cause";
}

TEST_F(BadBytes, UnclosedBracket) {
    EXPECT_THAT(findings_in_fixture("unclosed-bracket.nc"), ElementsAre("4:4 MAC117", "5:8 MAC117"));
}

TEST_F(BadBytes, NulBytesAsTapeLeader) {
    EXPECT_THAT(findings_in_fixture("nul-leader.nc"), IsEmpty());
    const std::string leader(1000, '\0');
    EXPECT_THAT(findings_in(leader + std::string(with_defect) + leader), ElementsAre("4:1 MAC301"));
}

TEST_F(BadBytes, NulBytesInTheText) {
    EXPECT_THAT(findings_in("%\nO1\nG0 X1.\0\0\0\0Y2.\n\0GOTO 99\nM30\n%\n"s), ElementsAre("4:2 MAC301"));
    folder.write("bad.nc", "G0X1\0Y2\0\n"s);
    const Finished finished = lint({"bad.nc", "neighbour.nc"});
    EXPECT_THAT(codes(finished, "bad.nc"), ElementsAre("1:1 MAC003"));
}

TEST_F(BadBytes, LinesThatEndInCarriageReturnsOnly) {
    EXPECT_THAT(findings_in_fixture("cr-only.nc"), IsEmpty());
    EXPECT_THAT(findings_in(replaced(with_defect, "\r")), ElementsAre("4:1 MAC301"));
}

TEST_F(BadBytes, LineEndsOfPaperTape) {
    EXPECT_THAT(findings_in_fixture("tape-lf-cr-cr.nc"), IsEmpty());
    EXPECT_THAT(findings_in(replaced(with_defect, "\n\r\r")), ElementsAre("4:1 MAC301"));
}

TEST_F(BadBytes, Utf8WithByteOrderMark) {
    EXPECT_THAT(findings_in_fixture("utf8-bom.nc"), IsEmpty());
    EXPECT_THAT(findings_in("\xEF\xBB\xBF" + std::string(with_defect)), ElementsAre("4:1 MAC301"));
}

TEST_F(BadBytes, Latin1Comments) {
    EXPECT_THAT(findings_in_fixture("latin1-comment.nc"), IsEmpty());
    EXPECT_THAT(findings_in("%\nO1 (T\xDCR)\n(H\xD6HE) GOTO 99\nM30\n%\n"), ElementsAre("3:8 MAC301"));
    folder.write("bad.nc", "%\nO1\nG0 X1. (H\xD6HE\nM30\n%\n");
    EXPECT_THAT(lint({"."}).out, HasSubstr("'(HÖHE' is never closed"));
}

TEST_F(BadBytes, ShiftJisComments) {
    EXPECT_THAT(findings_in_fixture("shift-jis-comment.nc"), IsEmpty());
    // The second byte of the characters is '\\', '[' and '{'.
    EXPECT_THAT(findings_in("%\nO1 (\x95\x5C\x81\x5B\x83\x7B)\n(\x95\x5C) GOTO 99\nM30\n%\n"),
                ElementsAre("3:5 MAC301"));
}

TEST_F(BadBytes, JumpsToHugeNumbers) {
    EXPECT_THAT(findings_in_fixture("goto-huge-number.nc"),
                ElementsAre("4:12 MAC301", "5:1 MAC301", "6:1 MAC301", "7:1 MAC301"));
    const Finished finished = lint({"."});
    EXPECT_THAT(finished.out,
                HasSubstr("jumps to N99999999999999999999999999, but they go from 1 to 99999999"));
}

TEST_F(BadBytes, HundredThousandNestedBrackets) {
    constexpr std::size_t depth = 100'000;
    EXPECT_THAT(findings_in("%\nO1\n#1=" + std::string(depth, '[') + "1" + std::string(depth, ']') +
                            "\nGOTO 99\nM30\n%\n"),
                ElementsAre("3:1 MAC004", "4:1 MAC301"));
    EXPECT_THAT(findings_in("%\nO1\n" + repeated("#1=[[[[[[[[[\n", depth) + "GOTO 99\nM30\n%\n"),
                ElementsAre("3:12 MAC117", std::to_string(depth / 13 + 4) + ":1 MAC301"))
        << "one cause";
}

TEST_F(BadBytes, ProgramThatCallsItselfThroughThreeOthers) {
    EXPECT_THAT(findings_in_fixture("recursion-through-three.nc"), ElementsAre("12:1 MAC412"));
    EXPECT_THAT(lint({"."}).out, HasSubstr("O7021 > O7022 > O7023 > O7021"));
}

TEST_F(BadInput, TerminalEscapesInComments) {
    take_fixture("escape-sequences.nc");
    for (const char* format : {"text", "concise", "json", "sarif"}) {
        const Finished finished =
            run_maclint(folder.path().string(), {"--format", format, "--color", "never", "."}, "");
        EXPECT_EQ(finished.status, 1);
        EXPECT_THAT(finished.err, IsEmpty());
        EXPECT_THAT(finished.out, AllOf(HasSubstr("neighbour.nc"), HasSubstr("escape-sequences.nc")));
        for (const char control : {'\x1B', '\x07', '\x08'})
            EXPECT_EQ(finished.out.find(control), std::string::npos) << format << ' ' << int{control};
    }
}

} // namespace
} // namespace maclint::test
