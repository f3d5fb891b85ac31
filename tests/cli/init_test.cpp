//! `maclint init`: what a folder is taken for, and a configuration that maclint itself accepts.
#include "tests/support/in_repository.hpp"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr std::string_view lathe =
    "%\nO2\nG50 S2000\nT0101\nG0 X60. Z2.\nG71 U2. R1.\nG71 P1 Q2 U0.4 W0.1 F0.3\nN1 G0 X20.\n"
    "G1 Z-20.\nN2 X50.\nG70 P1 Q2\nM851\nM30\n%\n";

class Init : public InRepository {
  protected:
    [[nodiscard]] std::string shown() const {
        const Finished finished = run({"init", "--print"});
        EXPECT_EQ(finished.status, 0) << finished.err;
        return finished.out;
    }
    /// What --show-config says of a file under the configuration that was written.
    [[nodiscard]] std::string held(const std::string& file) const {
        EXPECT_EQ(run({"init"}).status, 0);
        const Finished finished = run({"--show-config", file});
        EXPECT_EQ(finished.status, 0) << finished.err;
        EXPECT_EQ(finished.err, "");
        return finished.out;
    }
};

TEST_F(Init, WritesAConfigurationThatHoldsForTheFolder) {
    folder.write("O1000.nc", without_defect);
    EXPECT_THAT(held("O1000.nc"), HasSubstr("control        fanuc, Mill (FANUC"));
    EXPECT_THAT(read_file(folder.path() / ".maclint.json"),
                AllOf(HasSubstr("// 1 file taken for: fanuc"), HasSubstr("\"model\": \"fanuc\""),
                      Not(HasSubstr(",\n}")), HasSubstr("no program says which series")));
}

TEST_F(Init, NamesLathesByTheirFolder) {
    folder.write("mill/O1000.nc", without_defect);
    folder.write("lathe/O2.nc", lathe);
    EXPECT_THAT(shown(),
                AllOf(HasSubstr("\"machine\": \"lathe\""),
                      HasSubstr("{ \"glob\": \"lathe/**\", \"control\": \"Lathe\" }"),
                      HasSubstr("{ \"glob\": \"mill/**\", \"control\": \"Mill\" }"), HasSubstr("M851")));
    EXPECT_THAT(held("lathe/O2.nc"), HasSubstr("control        fanuc-lathe, Lathe ("));
    EXPECT_THAT(run({"--show-config", "mill/O1000.nc"}).out, HasSubstr("control        fanuc, Mill ("));
    EXPECT_THAT(run({}).err, Not(HasSubstr("takes no program"))) << "all globs are of use";
}

TEST_F(Init, LeavesAFolderOfBothToTheirTexts) {
    folder.write("O1000.nc", without_defect);
    folder.write("O2.nc", lathe);
    EXPECT_THAT(shown(), Not(HasSubstr("\"glob\"")));
    EXPECT_THAT(held("O2.nc"), HasSubstr("the text is written for a lathe"));
}

TEST_F(Init, SaysWhatElseThereIs) {
    folder.write("O1000.nc", "%\nO1000 (MAIN)\nM98 P9001\nM98 P9002\nM30\n%\n");
    folder.write("O9001.nc", "%\nO9001 (COPYRIGHT 2020 PROBES LTD)\nG0 X1.\nM99\n%\n");
    folder.write("heidenhain/PLATE.H",
                 "BEGIN PGM PLATE MM\nTOOL CALL 1 Z S2000\nL X+0 Y+0 R0 FMAX M3\nEND PGM PLATE MM\n");
    folder.write("klartext/PART.nc",
                 "0 BEGIN PGM PART MM\n1 TOOL CALL 1 Z S2000\n2 L X+0 Y+0 R0 FMAX M3\n3 END PGM PART MM\n");
    EXPECT_THAT(shown(), AllOf(HasSubstr("Called, and not here: O9002"),
                               HasSubstr("claim rights of a maker: O9001.nc"),
                               HasSubstr("// \"complete\": true,"), HasSubstr("\"klartext\"")));
}

TEST_F(Init, NeverWritesOverAFile) {
    folder.write("O1000.nc", without_defect);
    folder.write(".maclint.json", "{}");
    const Finished finished = run({"init"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr(".maclint.json: is there already, and is left as it is"));
    EXPECT_EQ(read_file(folder.path() / ".maclint.json"), "{}");
    EXPECT_EQ(run({"init", "--print"}).status, 0);
    std::filesystem::remove(folder.path() / ".maclint.json");
    std::filesystem::create_symlink("nowhere", folder.path() / ".maclint.json");
    EXPECT_EQ(run({"init"}).status, 2) << "a link that leads nowhere";
    EXPECT_THAT(run({"init", "no-such-folder"}).err, HasSubstr("there is no such folder"));
}

TEST_F(Init, PrintsForAFolderWithoutPrograms) {
    EXPECT_THAT(shown(), HasSubstr("No NC programs were found here."));
    EXPECT_EQ(run({"init"}).status, 0);
    EXPECT_EQ(run({}).status, 0) << "the configuration is one";
}

} // namespace
} // namespace maclint::test
