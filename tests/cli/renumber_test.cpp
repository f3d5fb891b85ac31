//! `maclint renumber`: what gets new numbers, what is refused, and that jumps lead where they led.
#include "tests/support/in_repository.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace maclint::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Renumber : public InRepository {
  protected:
    /// The file after it was renumbered, or what was said instead.
    [[nodiscard]] std::string renumbered(const std::string& text,
                                         std::vector<std::string> options = {}) const {
        folder.write("O1.nc", text);
        options.insert(options.begin(), "renumber");
        options.emplace_back("O1.nc");
        const Finished finished = run(options);
        const std::string after = read_file(folder.path() / "O1.nc");
        if (finished.status == 0) return after;
        EXPECT_EQ(after, text) << "refused, and changed";
        EXPECT_EQ(finished.status, 2);
        return finished.err;
    }
    /// Codes and lines of what is found.
    [[nodiscard]] std::string findings() const {
        std::string all;
        const auto report = nlohmann::json::parse(run({"--format", "json", "--select", "ALL", "O1.nc"}).out);
        for (const auto& finding : report["findings"])
            all += finding["code"].get<std::string>() + " " + finding["range"]["start"]["line"].dump() + "\n";
        return all;
    }
};

TEST_F(Renumber, ChangesJumpsWithTheBlocksThatTheyNameAndNothingElse) {
    EXPECT_EQ(renumbered("%\r\nO1(SEE N5)\r\nN5 G0X1.\r\n/2 N7 X2. (N7 IS HERE)\r\nIF[#1EQ5]GOTO "
                         "5\r\nGOTO7\r\nN9M30\r\n%\r\n"),
              "%\r\nO1(SEE N5)\r\nN10 G0X1.\r\n/2 N20 X2. (N7 IS HERE)\r\nIF[#1EQ5]GOTO "
              "10\r\nGOTO20\r\nN30M30\r\n%\r\n");
    EXPECT_EQ(renumbered("O1\nN0005 X1.\nN0010 GOTO0005\nM30\n", {"--start", "100", "--step", "5"}),
              "O1\nN0100 X1.\nN0105 GOTO0100\nM30\n");
    EXPECT_EQ(renumbered("O1\n(\xC4\xD6) N3 G0 X1.\nGOTO 3\nM30\n"),
              "O1\n(\xC4\xD6) N10 G0 X1.\nGOTO 10\nM30\n")
        << "in the encoding of the file";
}

TEST_F(Renumber, NumbersEachProgramOfAFileForItself) {
    EXPECT_EQ(renumbered("O1\nN1 M98 P2\nN2 GOTO1\nM30\nO2\nN1 X1.\nGOTO 1\nM99\n"),
              "O1\nN10 M98 P2\nN20 GOTO10\nM30\nO2\nN10 X1.\nGOTO 10\nM99\n");
}

TEST_F(Renumber, ChangesReturnsToTheCallerAndCallsThatBeginAtABlock) {
    EXPECT_EQ(renumbered("O1\nM98 P2\nX1.\nN7 X2.\nM30\nO2\nN3 X5.\nM99 P7\n"),
              "O1\nM98 P2\nX1.\nN10 X2.\nM30\nO2\nN10 X5.\nM99 P10\n");
    EXPECT_EQ(renumbered("O1\nN5 X1.\nM98 P2 Q8\nM30\nO2\nN3 X5.\nN8 X6.\nM99\n"),
              "O1\nN10 X1.\nM98 P2 Q20\nM30\nO2\nN10 X5.\nN20 X6.\nM99\n");
    EXPECT_EQ(renumbered("O1\nN5 X1.\nM99 P5\nM30\n"), "O1\nN10 X1.\nM99 P10\nM30\n")
        << "a main program's own block";
}

TEST_F(Renumber, ChangesContoursOfLatheCycles) {
    EXPECT_EQ(renumbered("O1(SHAFT)\nG50 S2000\nG0 X60. Z2. T0101\nG71 U2. R1.\nG71 P1 Q2 U0.4 W0.1 F0.3\nN1 "
                         "G0 X20.\nG1 Z-20.\n"
                         "N2 X50.\nG70 P1 Q2\nM30\n",
                         {"--control", "fanuc-16i-lathe"}),
              "O1(SHAFT)\nG50 S2000\nG0 X60. Z2. T0101\nG71 U2. R1.\nG71 P10 Q20 U0.4 W0.1 F0.3\nN10 G0 "
              "X20.\nG1 Z-20.\n"
              "N20 X50.\nG70 P10 Q20\nM30\n");
    EXPECT_EQ(renumbered("O1\nN1 G21\nG83 X1. Z-5. R1. Q2 P1 F100\nM30\n"),
              "O1\nN10 G21\nG83 X1. Z-5. R1. Q2 P1 F100\nM30\n")
        << "a dwell and a depth";
}

TEST_F(Renumber, ChangesContoursOfDinPlus) {
    const std::string text =
        "PROGRAM HEAD [1]\nFINISHED PART\nN1 G0 X0 Z0\nN2 G1 X20\nN3 G1 Z-30\nMACHINING\nN5 T1\n"
        "N6 G810 NS1 NE3 P5 [NS1]\nN7 M30\nEND\n";
    EXPECT_EQ(renumbered(text, {"--dialect", "dinplus"}),
              "PROGRAM HEAD [1]\nFINISHED PART\nN10 G0 X0 Z0\nN20 G1 X20\nN30 G1 Z-30\nMACHINING\nN40 T1\n"
              "N50 G810 NS10 NE30 P5 [NS1]\nN60 M30\nEND\n");
}

TEST_F(Renumber, RefusesWhatCannotBeFollowed) {
    EXPECT_THAT(renumbered("O1\nN5 X1.\nGOTO#1\nM30\n"),
                AllOf(HasSubstr("O1.nc: line 3: '#1' jumps to a block whose number is calculated"),
                      HasSubstr("The file is left as it was.")));
    EXPECT_THAT(renumbered("O1\nN5 X1.\nGOTO[5+#1]\nM30\n"), HasSubstr("whose number is calculated"));
    EXPECT_THAT(renumbered("O1\nN5 X1.\nN5 X2.\nGOTO 5\nM30\n"),
                HasSubstr("line 4: '5' names N5, which stands more than once"));
    EXPECT_THAT(renumbered("O1\nN5 #1=#4114\nGOTO 5\nM30\n"),
                HasSubstr("'#4114' reads the number of a block"));
    EXPECT_THAT(renumbered("O1\nN5 X1.\nGOTO 10\nM30\n"),
                HasSubstr("'10' names a block that is not there, and one would"));
    EXPECT_THAT(renumbered("O1\nN5 X1.\nN6 X2.\nM30\n", {"--step", "9995"}),
                HasSubstr("the last block would be N10005"));
    EXPECT_EQ(renumbered("O1\nN5 X1.\nGOTO 99\nM30\n"), "O1\nN10 X1.\nGOTO 99\nM30\n")
        << "it led nowhere before";
}

TEST_F(Renumber, RefusesWhatAnotherFileNames) {
    folder.write("O9001.nc", "%\nO9001\n#100=1\nM99 P7\n%\n");
    EXPECT_THAT(renumbered("%\nO1\nM98 P9001\nN5 X1.\nN7 X2.\nM30\n%\n"),
                AllOf(HasSubstr("O9001.nc line 4: '7' names a block of this file from another one")));
    EXPECT_EQ(renumbered("%\nO1\nM98 P9001\nN5 X1.\nM30\n%\n"), "%\nO1\nM98 P9001\nN10 X1.\nM30\n%\n");
    folder.write("O9001.nc", "%\nO9001\nM98 P1 Q5\nM99\n%\n");
    EXPECT_THAT(renumbered("%\nO1\nN5 X1.\nM99\n%\n"),
                HasSubstr("O9001.nc line 3: 'Q5' names a block of this file"));
}

TEST_F(Renumber, FindsTheSameAfterwards) {
    const std::string text =
        "%\nO1\nN1 #1=0\nN2 WHILE[#1LT3]DO1\nIF[#1EQ2]GOTO 4\nGOTO 30\nN3 #1=#1+1\nEND1\nN4 G91 X1.\n"
        "GOTO 77\nN8 X2.\nM99\n%\n";
    folder.write("O1.nc", text);
    const std::string before = findings();
    EXPECT_THAT(before, HasSubstr("MAC301"));
    EXPECT_THAT(renumbered(text), Not(HasSubstr("refused")));
    EXPECT_EQ(findings(), before);
}

TEST_F(Renumber, ShowsADifferenceAndChangesNothing) {
    folder.write("O1.nc", "O1\nN5 X1.\nGOTO 5\nM30\n");
    const Finished finished = run({"renumber", "--diff", "O1.nc"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_THAT(finished.out,
                AllOf(HasSubstr("--- a/O1.nc\n+++ b/O1.nc\n"), HasSubstr("-N5 X1.\n"),
                      HasSubstr("+N10 X1.\n"), HasSubstr("-GOTO 5\n"), HasSubstr("+GOTO 10\n")));
    EXPECT_EQ(finished.err, "Would change 2 numbers in 1 file.\n");
    EXPECT_EQ(read_file(folder.path() / "O1.nc"), "O1\nN5 X1.\nGOTO 5\nM30\n");
}

TEST_F(Renumber, TellsWhatItCannotTake) {
    folder.write("programs/O1.nc", without_defect);
    EXPECT_THAT(run({"renumber"}).err, HasSubstr("renumber needs a program"));
    EXPECT_THAT(run({"renumber", "programs"}).err, HasSubstr("is a folder. Name the programs in it."));
    EXPECT_THAT(run({"renumber", "O7.nc"}).err, HasSubstr("O7.nc"));
    EXPECT_EQ(run({"renumber", "O7.nc"}).status, 2);
    EXPECT_THAT(run({"renumber", "-"}).err, HasSubstr("does not take standard input"));
    EXPECT_THAT(run({"renumber", "programs/O1.nc", "--step", "0"}).err,
                HasSubstr("Give a whole number from 1"));
}

} // namespace
} // namespace maclint::test
