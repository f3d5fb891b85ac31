//! Files that are not linted: one note a kind, --show-files, names without an extension, encodings.
#include "cli/gather_notices.hpp"
#include "tests/support/in_repository.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace maclint::test {
namespace {

using cli::Notice;
using cli::NoticeKind;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Notice note(std::string path, std::string what, bool named) {
    return {NoticeKind::foreign, std::move(path), "this is not linted", std::move(what), named};
}

TEST(GatherNotices, OfFilesThatWereFoundOneSpeaksForAllOfItsKind) {
    const auto gathered = cli::gather_by_kind({note("shop/a/1.mpf", "SINUMERIK", false),
                                               note("shop/a/2.mpf", "SINUMERIK", false),
                                               note("shop/ab/3.mpf", "SINUMERIK", false),
                                               note("shop/b.nc", "OKUMA OSP", false),
                                               {NoticeKind::left_out, "c", "is empty"}});
    ASSERT_EQ(gathered.size(), 3U);
    EXPECT_EQ(gathered[0].path, "shop");
    EXPECT_EQ(gathered[0].message,
              "3 files are not linted: SINUMERIK (shop/a/1.mpf and others). Say --show-files to see which.");
    EXPECT_EQ(gathered[1].message, "this is not linted");
    EXPECT_EQ(gathered[2].message, "is empty");
}

TEST(GatherNotices, ThreeFilesThatWereNamedAreToldOneByOne) {
    std::vector<Notice> notices;
    for (const char* path : {"1.mpf", "2.mpf", "3.mpf"}) notices.push_back(note(path, "SINUMERIK", true));
    EXPECT_EQ(cli::gather_by_kind(notices).size(), 3U);
    notices.push_back(note("4.mpf", "SINUMERIK", true));
    const auto gathered = cli::gather_by_kind(notices);
    ASSERT_EQ(gathered.size(), 1U);
    EXPECT_EQ(gathered[0].path, ".");
}

TEST(GatherNotices, TheFolderOfAbsolutePathsMayBeTheRoot) {
    EXPECT_EQ(cli::gather_by_kind({note("/a/1", "X", false), note("/b/2", "X", false)}).at(0).path, "/");
}

class OtherFiles : public InRepository {};

TEST_F(OtherFiles, AFolderOfAnotherLanguageGivesOneNote) {
    for (const char* name : {"shop/1.min", "shop/2.min", "shop/below/3.min"})
        folder.write(name, "G0 X5\nM30\n");
    const Finished finished = run({"shop"});
    EXPECT_EQ(finished.err,
              "maclint: note: shop: 3 files are not linted: OKUMA OSP (shop/1.min and others). Say "
              "--show-files to see which.\n");
    EXPECT_EQ(finished.status, 0);
}

TEST_F(OtherFiles, ShowFilesListsWhatIsReadAndPassedOverAndWhyAndChecksNothing) {
    folder.write(".maclint.json", R"({"exclude": ["old"]})");
    folder.write(".gitignore", "*.tmp.nc\n");
    folder.write("shop/bad.nc", with_defect);
    folder.write("shop/a.tmp.nc", with_defect);
    folder.write("shop/part.mpf", "G0 X5\nM30\n");
    folder.write("shop/data.txt", "%\n#500=1.\n#501=2.\n%\n");
    folder.write("shop/PIN", with_defect);
    folder.write("shop/Makefile", "all:\n\tmake pin\n");
    folder.write("shop/plan.pdf", "%PDF-1.4\n");
    folder.write("shop/build/x.nc", with_defect);
    folder.write("old/x.nc", with_defect);
    const Finished finished = run({"--show-files", "."});
    EXPECT_EQ(finished.out, "old: passed over: excluded by the configuration\n"
                            "shop/Makefile: passed over: no extension, and not plainly a program\n"
                            "shop/PIN: read as fanuc (content)\n"
                            "shop/a.tmp.nc: passed over: ignored by git\n"
                            "shop/bad.nc: read as fanuc (extension .nc and content)\n"
                            "shop/build: passed over: a folder of what programs made\n"
                            "shop/data.txt: not linted: data, no program (values of variables)\n"
                            "shop/part.mpf: read as sinumerik (extension .mpf)\n"
                            "shop/plan.pdf: passed over: another name\n");
    EXPECT_EQ(finished.err, "");
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(run({"--show-files", "gone.nc"}).status, 2);
    EXPECT_EQ(run({"--show-files", "--show-config"}).status, 2);
}

TEST_F(OtherFiles, ProgramsWithoutAnExtensionAreFoundWhereTheirTextIsPlainlyOne) {
    folder.write("PIN", with_defect);
    folder.write("COVER 2", "%\nN10G21\nN20G0X5.\nN30GOTO99\n%\n");
    folder.write("x.ncd", with_defect);
    for (const char* name : {"README", "LICENSE", "notes"})
        folder.write(name, "O1001 is the pin.\nG0 is rapid.\nRun it at night.\n");
    folder.write("list", "T1 end mill\nT2 drill\n");
    folder.write("values", "%\n#500=1.\n#501=2.\n%\n");
    folder.write("picture", "\x89PNG\r\n\x1A\n\x01\x02");
    const Finished finished = run({"--format", "concise", "."});
    EXPECT_THAT(finished.out, AllOf(HasSubstr("PIN:4:1: error[MAC301]"), HasSubstr("COVER 2:4:"),
                                    HasSubstr("x.ncd:4:1"), HasSubstr("(3 checked, ")));
    EXPECT_EQ(finished.err, "");
}

TEST_F(OtherFiles, DataIsANoteAlsoWhereItIsNamedAndATextIsNoProgram) {
    folder.write("values.nc", "%\n#500=1.\n#501=2.\n%\n");
    folder.write("tools.nc", "T1 end mill\nT2 drill\n");
    const Finished data = run({"--format", "concise", "values.nc"});
    EXPECT_THAT(data.err, HasSubstr("data, no program (values of variables)"));
    EXPECT_EQ(data.status, 0);
    EXPECT_THAT(run({"--format", "concise", "tools.nc"}).out, HasSubstr("error[MAC003]"));
    EXPECT_THAT(run({"--format", "concise", "--dialect", "fanuc", "values.nc"}).out,
                HasSubstr("(1 checked)"));
}

// ---- encodings

TEST_F(OtherFiles, JapaneseIsShownInEveryReportAndItsBytesAreNoBrackets) {
    folder.write("O1.nc", "O1(\x83\x5C\x95\x5C)\n#100=1(\x83\x5C)\nG1Z\x81\x5B"
                          "5.\nM30\n");
    EXPECT_THAT(run({"O1.nc"}).out, AllOf(HasSubstr("O1.nc:3:4"), HasSubstr("'ー'"), HasSubstr("G1Zー5."),
                                          HasSubstr("Write '-'.")));
    const auto sarif = nlohmann::json::parse(run({"--format", "sarif", "O1.nc"}).out);
    const auto& region = sarif["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["region"];
    EXPECT_EQ(region["startColumn"], 4);
    EXPECT_EQ(region["endColumn"], 5);
    EXPECT_EQ(sarif["runs"][0]["artifacts"][0]["encoding"], "Shift_JIS");
    EXPECT_THAT(run({"--format", "json", "O1.nc"}).out, HasSubstr("'ー'"));
    EXPECT_THAT(run({"--show-config", "O1.nc"}).out, HasSubstr("encoding       shift-jis\n"));
}

TEST_F(OtherFiles, TheConfigurationNamesAnEncodingWhereTheBytesLeaveADoubt) {
    const std::string text = "O1(\x92\x5B)\nGOTO9(\x92\x5B)\nM30\n"; // one kanji, whose second byte is '['
    folder.write("O1.nc", text);
    EXPECT_THAT(run({"--show-config", "O1.nc"}).out, HasSubstr("encoding       windows-1252\n"));
    folder.write(".maclint.json", R"({"encoding": "shift-jis"})");
    EXPECT_THAT(run({"O1.nc"}).out, HasSubstr("GOTO9(端)"));
    folder.write(".maclint.json", R"({"encoding": "gbk"})");
    EXPECT_THAT(run({"O1.nc"}).out, AllOf(HasSubstr("GOTO9(抂)"), Not(HasSubstr("端"))));
}

TEST_F(OtherFiles, WideSignsOfAnyEncodingAreTold) {
    folder.write("u.nc", "O1\nG1 X–5.0 F100\nG1 Y５. F100\nG1 Z−1.\nM30\n");
    folder.write("w.nc", "O2\nG1 X\x96"
                         "5.0 F100\nM30\n");
    folder.write("d.nc", "MACHINING\nN1 G0 X–5 Z2\nN2 G1 X10\nEND\n");
    const std::string out = run({"--format", "concise", "."}).out;
    EXPECT_THAT(out, AllOf(HasSubstr("u.nc:2:5: error[MAC121] Wide character '–'"), HasSubstr("u.nc:3:5"),
                           HasSubstr("Write '5'."), HasSubstr("u.nc:4:5"), HasSubstr("w.nc:2:5"),
                           HasSubstr("d.nc:2:8: error[MAC121]")));
    // In a remark they are letters as any other, and a program full of them is one.
    folder.write("r.nc", "O3(X–5)\nG1 X5. F100\nM30\n");
    EXPECT_THAT(run({"--format", "concise", "r.nc"}).out, HasSubstr("no findings"));
    folder.write("p.nc", "G1 X–5. F100\nG1 Y–6.\nG1 Z–7.\n");
    EXPECT_THAT(run({"--format", "concise", "p.nc"}).out, HasSubstr("MAC121"));
}

} // namespace
} // namespace maclint::test
