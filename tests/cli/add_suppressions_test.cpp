//! `--add-suppressions`: comments in the language of the program, at places where they work.
#include "tests/support/in_repository.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class AddSuppressions : public InRepository {
  protected:
    [[nodiscard]] Finished add(std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"--add-suppressions", "--reason", "proven on the machine"});
        return run(more);
    }
    [[nodiscard]] std::string text(const std::string& file = "O1.nc") const {
        return read_file(folder.path() / file);
    }
};

TEST_F(AddSuppressions, AllowsAFindingAtTheEndOfItsLine) {
    folder.write("O1.nc", "%\r\nO1\r\nGOTO 99  \r\nGOTO 98;\r\nM30\r\n%\r\n");
    const Finished finished = add();
    EXPECT_EQ(finished.status, 0) << finished.out;
    EXPECT_THAT(finished.err, HasSubstr("Allowed 2 findings in 1 file.\n"));
    EXPECT_EQ(text(), "%\r\nO1\r\nGOTO 99 (MACLINT ALLOW MAC301 - PROVEN ON THE MACHINE)  \r\n"
                      "GOTO 98 (MACLINT ALLOW MAC301 - PROVEN ON THE MACHINE);\r\nM30\r\n%\r\n");
    EXPECT_EQ(run({}).status, 0) << "nothing new is found";
}

TEST_F(AddSuppressions, WritesOneCommentForTheFindingsOfALine) {
    folder.write("O1.nc", "O1\nG90 G54 G0 X0 Y0\nIF[#100EQ1]GOTO 99\nG65 X1.\nM30\n");
    EXPECT_EQ(add().status, 0);
    EXPECT_EQ(run({}).status, 0);
}

TEST_F(AddSuppressions, WritesDinPlusInItsBrackets) {
    folder.write("A.nc", "PROGRAM HEAD [1]\nMACHINING\nN1 T1\nN2 G810 NS7 NE9 P5\nN3 M30\nEND\n");
    ASSERT_EQ(run({"--dialect", "dinplus"}).status, 1);
    EXPECT_EQ(add({"--dialect", "dinplus"}).status, 0);
    EXPECT_THAT(text("A.nc"), AllOf(HasSubstr("[MACLINT ALLOW "), HasSubstr(" - proven on the machine]\n")));
}

TEST_F(AddSuppressions, NamesLinesThatCannotHoldOne) {
    folder.write("O1.nc", "%\nO1\nGOTO 99\nX1. (OPEN\nM30\n%\n");
    const Finished finished = add({"--fail-on", "note"});
    EXPECT_THAT(text(), HasSubstr("GOTO 99 (MACLINT ALLOW MAC301 - PROVEN ON THE MACHINE)\n"));
    EXPECT_THAT(text(), HasSubstr("X1. (OPEN"));
}

TEST_F(AddSuppressions, LeavesWhatDoesNotCount) {
    folder.write("O1.nc", with_defect);
    ASSERT_EQ(run({"--write-baseline", "known.json"}).status, 0);
    EXPECT_THAT(add({"--baseline", "known.json"}).err, HasSubstr("Allowed 0 findings in 0 files."));
    EXPECT_EQ(text(), with_defect);
}

TEST_F(AddSuppressions, ShowsADifferenceAndChangesNothing) {
    folder.write("O1.nc", with_defect);
    const Finished finished = add({"--diff"});
    EXPECT_THAT(finished.out, HasSubstr("+GOTO 99 (MACLINT ALLOW MAC301 - PROVEN ON THE MACHINE)\n"));
    EXPECT_THAT(finished.err, HasSubstr("Would allow 1 finding in 1 file.\n"));
    EXPECT_EQ(text(), with_defect);
}

TEST_F(AddSuppressions, WantsAReasonThatACommentCanHold) {
    folder.write("O1.nc", with_defect);
    EXPECT_THAT(run({"--add-suppressions"}).err, HasSubstr("wants to know why"));
    EXPECT_THAT(run({"--add-suppressions", "--reason", "a) b"}).err,
                HasSubstr("--reason goes into comments"));
    EXPECT_THAT(run({"--reason", "x"}).err, HasSubstr("Write --add-suppressions beside it"));
    EXPECT_THAT(run({"--add-suppressions", "--fix", "--reason", "x"}).err, HasSubstr("exclude each other"));
    EXPECT_EQ(text(), with_defect);
}

} // namespace
} // namespace maclint::test
