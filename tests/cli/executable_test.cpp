//! The built executable on small folders: exit status, streams, discovery, configuration.
#include "tests/support/in_repository.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class Executable : public InRepository {
  protected:
    /// Findings as "file:line", one a line.
    [[nodiscard]] std::string concise(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"check", "--format", "concise", "--quiet"});
        return run(arguments).out;
    }
};

TEST_F(Executable, EndsWith0WithoutFindings) {
    folder.write("O1000.nc", without_defect);
    const Finished finished = run({});
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.out, "no findings (1 checked)\n");
    EXPECT_THAT(finished.err, IsEmpty());
}

TEST_F(Executable, ReportsForProgramsHoldNothingThatSteersATerminal) {
    // U+009B begins a control sequence, U+202E turns the text around, U+E0041 cannot be seen.
    folder.write("O1.nc", "%\nO1\nGOTO9(\xC2\x9B"
                          "31m \xE2\x80\xAE \x7F \xF3\xA0\x81\x81 gr\xC3\xBC\xC3\x9F)\nM30\n%\n");
    const std::string sarif = run({"--format", "sarif"}).out;
    for (const char* raw : {"\xC2\x9B", "\xE2\x80\xAE", "\x7F", "\xF3\xA0\x81\x81"})
        EXPECT_THAT(sarif, testing::Not(HasSubstr(raw)));
    EXPECT_THAT(sarif, HasSubstr("\\u009B31m \\u202E \\u007F \\uDB40\\uDC41 gr\xC3\xBC\xC3\x9F"));
    const std::string name = "O\xC2\x9B"
                             "2.nc";
    folder.write(name, with_defect);
    const std::string json = run({"--format", "json", name}).out;
    EXPECT_THAT(json, testing::Not(HasSubstr("\xC2\x9B")));
    EXPECT_THAT(json, HasSubstr("O\\u009B2.nc"));
}

TEST_F(Executable, AConfigurationThatIsNoFileIsAnError) {
    folder.write("a/O1.nc", without_defect);
    fs::create_directories(folder.path() / "a/.maclint.json");
    const Finished finished = run({"a"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("a/.maclint.json: is a folder, a pipe or a link"));
    EXPECT_EQ(run({"--isolated", "a"}).status, 0);
}

TEST_F(Executable, AConfigurationThatIsALinkToNothingIsAnError) {
    folder.write("b/O1.nc", without_defect);
    fs::create_symlink("nowhere", folder.path() / "b/.maclint.json");
    const Finished finished = run({"b"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("b/.maclint.json: is a folder, a pipe or a link"));
    EXPECT_EQ(run({"--isolated", "b"}).status, 0);
}

TEST_F(Executable, EndsWith1WithFindingsOnStandardOutput) {
    folder.write("O1001.nc", with_defect);
    const Finished finished = run({"O1001.nc"});
    EXPECT_EQ(finished.status, 1);
    EXPECT_THAT(finished.out, AllOf(HasSubstr("error[MAC301]"), HasSubstr("--> O1001.nc:4:")));
    EXPECT_THAT(finished.err, IsEmpty());
}

TEST_F(Executable, APartOfACompleteFolderKnowsTheRestOfIt) {
    folder.write("mill/.maclint.json", R"({"complete": true})");
    folder.write("mill/bores/O1.nc", "O1\nM98P9\nM98P8\nM30\n"); // no O8
    folder.write("mill/lib/O9.nc", "O9\nGOTO7\nM99\n");
    EXPECT_THAT(concise({"mill/bores"}),
                AllOf(StartsWith("mill/bores/O1.nc:3:1: error[MAC402]"), Not(HasSubstr("O9.nc"))));
    EXPECT_THAT(concise({"."}), AllOf(HasSubstr("mill/bores/O1.nc:3:1: error[MAC402]"), HasSubstr("O9.nc:2"),
                                      Not(HasSubstr("O1.nc:2"))));
}

TEST_F(Executable, OnlyTheMCodesThatAShopNamesStopLookAheadOnItsControl) {
    const auto read_behind = [](const std::string& word) {
        return "O1\nG1X5.F100." + word + "\n#5221=#5021\nM99\n";
    };
    for (const char* word : {"M8", "M25", "M39", "M40", "M49", "M50", "M#1", "M00"})
        folder.write(std::string(word) + ".nc", read_behind(word));
    folder.write("BEHIND.nc", read_behind("\nM8\nM9"));
    EXPECT_THAT(concise({"--select", "MAC605", "."}), IsEmpty()) << "any of them may";
    folder.write(".maclint.json", R"({
        "controls": {"mill 1": {"model": "fanuc-30i", "stops-look-ahead": ["M25", "M40-M49"]}},
        "files": [{"glob": "*", "control": "mill 1"}]})");
    EXPECT_THAT(run({"--show-config", "M8.nc"}).out,
                HasSubstr("look-ahead     stopped by the words of the language, and M25 and M40-M49\n"));
    const std::string said = concise({"--select", "MAC605", "."});
    EXPECT_THAT(said, HasSubstr("BEHIND.nc:5:"));
    for (const char* name : {"M8", "M39", "M50"})
        EXPECT_THAT(said, HasSubstr(std::string(name) + ".nc:3:")) << name;
    for (const char* name : {"M25", "M40", "M49", "M#1", "M00"})
        EXPECT_THAT(said, Not(HasSubstr(std::string(name) + ".nc"))) << name;
}

TEST_F(Executable, EndsWith2WhenAFileIsMissingButReportsTheOthers) {
    folder.write("O1001.nc", with_defect);
    const Finished finished = run({"O1001.nc", "gone.nc"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.out, HasSubstr("MAC301"));
    EXPECT_THAT(finished.err, StartsWith("maclint: error: gone.nc: "));
}

TEST_F(Executable, EndsWith2AfterAMistypedOption) {
    const Finished finished = run({"--formt", "json"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.out, IsEmpty());
    EXPECT_THAT(finished.err, HasSubstr("Did you mean '--format'?"));
}

TEST_F(Executable, FailsOnlyFromTheSeverityAskedFor) {
    folder.write("O1001.nc", with_defect);
    EXPECT_EQ(run({"--fail-on", "never"}).status, 0);
    EXPECT_EQ(run({"--severity", "MAC301=note"}).status, 0);
    EXPECT_EQ(run({"--severity", "MAC301=note", "--fail-on", "note"}).status, 1);
}

TEST_F(Executable, SelectsAndIgnores) {
    folder.write("O1001.nc", with_defect);
    EXPECT_THAT(concise({"--ignore", "jump-target-missing"}), IsEmpty());
    EXPECT_THAT(concise({"--select", "MAC5"}), IsEmpty());
    EXPECT_THAT(concise({"--select", "MAC3"}), HasSubstr("O1001.nc:4:"));
}

TEST_F(Executable, ReadsStandardInputUnderAName) {
    const Finished finished =
        run_maclint(folder.path().string(), {"-", "--stdin-filename", "sub/O1.nc"}, std::string(with_defect));
    EXPECT_EQ(finished.status, 1);
    EXPECT_THAT(finished.out, HasSubstr("--> sub/O1.nc:4:"));
}

TEST_F(Executable, SearchesFoldersInOrderWithoutHiddenAndBuildFolders) {
    folder.write("b/O1001.nc", with_defect);
    folder.write("a/O1002.NC", with_defect);
    folder.write("a/O1003", with_defect);
    folder.write("a/notes.md", with_defect);
    folder.write(".old/O1.nc", with_defect);
    folder.write("build/O1.nc", with_defect);
    const std::string out = concise({"."});
    EXPECT_LT(out.find("a/O1002.NC:4"), out.find("a/O1003:4"));
    EXPECT_LT(out.find("a/O1003:4"), out.find("b/O1001.nc:4"));
    EXPECT_THAT(out, AllOf(Not(HasSubstr(".old")), Not(HasSubstr("build/")), Not(HasSubstr("notes"))));
}

TEST_F(Executable, ReadsNamedFilesWhateverTheirName) {
    folder.write("program.txt", with_defect);
    EXPECT_THAT(concise({"program.txt"}), HasSubstr("program.txt:4:"));
}

TEST_F(Executable, TellsOfAFolderWithoutProgramsAndOfForeignFiles) {
    fs::create_directory(folder.path() / "empty");
    folder.write("part.h", "0  BEGIN PGM PART MM\n1  L X+0 Y+0 FMAX\n2  END PGM PART MM\n");
    const Finished empty = run({"empty"});
    EXPECT_EQ(empty.status, 0);
    EXPECT_THAT(empty.err, HasSubstr("maclint: note: empty: no NC program"));
    const Finished foreign = run({"part.h"});
    EXPECT_EQ(foreign.status, 0);
    EXPECT_THAT(foreign.err, HasSubstr("maclint: note: part.h: this is not linted"));
    EXPECT_THAT(run({"--quiet", "part.h", "empty"}).err, IsEmpty());
}

/// One of the two tests of #501 sets #5 on every path; between them stand more blocks than a search passes.
std::string with_a_path_longer_than_is_tried() {
    std::string text = "%\nO1\nIF[#501EQ1]GOTO20\n#5=1\nN20\n";
    for (int i = 0; i < 3000; ++i) text += "#100=#100+1\n";
    return text + "IF[#501NE1]GOTO21\n#5=2\nN21 G0Z#5\nM30\n%\n";
}

TEST_F(Executable, SaysWhereTheTimeWent) {
    folder.write("O1.nc", with_a_path_longer_than_is_tried());
    folder.write("O2.nc", without_defect);
    const Finished silent = run({"--select", "MAC209"});
    const Finished timed = run({"--select", "MAC209", "--timing"});
    EXPECT_THAT(timed.err,
                testing::ContainsRegex("timing: reading +[0-9]+\\.[0-9]+ s  2 files, 0\\.04 MB\n"));
    EXPECT_THAT(timed.err, testing::ContainsRegex("timing: analysis +[0-9]+\\.[0-9]+ s  2 programs\n"));
    EXPECT_THAT(timed.err, testing::ContainsRegex("timing: rules .*  1 path looked for, 1 given up\n"));
    EXPECT_THAT(timed.err, HasSubstr("timing: the whole run "));
    EXPECT_EQ(timed.out, silent.out);
    EXPECT_EQ(timed.status, silent.status);
    EXPECT_THAT(silent.err, testing::Not(HasSubstr("timing")));
}

TEST_F(Executable, GivesOneNoteForATextThatItsDialectCannotRead) {
    std::string text;
    for (int i = 0; i < 12; ++i) text += "G0 X5. Y5.\nX5. TO THE LEFT\n";
    folder.write("odd.nc", text);
    const Finished odd = run({"odd.nc"});
    EXPECT_EQ(odd.status, 0);
    EXPECT_THAT(odd.err, HasSubstr("odd.nc: this is not linted: 12 of 24 blocks cannot be read as fanuc."));
    EXPECT_THAT(concise({"--dialect", "fanuc", "odd.nc"}), HasSubstr("odd.nc:2:"));
    folder.write("ours.nc", "O1000\n" + text);
    EXPECT_THAT(concise({"ours.nc"}), HasSubstr("ours.nc:3:"));
    folder.write("short.nc", "G0 X5. Y5.\nX5. TO THE LEFT\n");
    EXPECT_THAT(concise({"short.nc"}), HasSubstr("short.nc:2:"));
}

TEST_F(Executable, KeepsSilentAboutTextsThatNobodyTakesForPrograms) {
    folder.write("O1.nc", without_defect);
    folder.write("README.txt", "These are the programs of the hinge,\nas the customer sent them.\n");
    folder.write("driver.h", "#include <stdio.h>\n#define A 1\n");
    EXPECT_THAT(run({"."}).err, IsEmpty());
    folder.write("PART.MIN", "G0 X5\nM30\n");
    EXPECT_THAT(run({"."}).err, HasSubstr("PART.MIN: this is not linted: OKUMA OSP"));
    folder.write("PART.MPF", "G0 X5\nGOTOF NOWHERE\nM30\n");
    EXPECT_THAT(concise({"PART.MPF"}), HasSubstr("MAC301"));
}

TEST_F(Executable, TakesTheUsersWordForTheDialect) {
    folder.write("main.c", "int main(void) {\n    return 0;\n}\n");
    EXPECT_THAT(run({"main.c"}).err, HasSubstr("main.c: this is not linted: "));
    EXPECT_THAT(concise({"--dialect", "fanuc", "main.c"}), HasSubstr("main.c:1:"));
}

TEST_F(Executable, LooksAroundANamedFileForThoseItCalls) {
    folder.write("main.nc", "%\nO2000\nG65 P9000 A1.\nM30\n%\n");
    folder.write("lib/O9000.nc", "%\nO9000\nGOTO 99\nM99\n%\n");
    const std::string out = concise({"main.nc"});
    EXPECT_THAT(out, Not(HasSubstr("O9000.nc:"))); // nobody asked
    EXPECT_THAT(concise({"--select", "MAC402", "main.nc"}), IsEmpty());
}

TEST_F(Executable, EscapesWhatFilesHold) {
    folder.write("O1.nc", "%\nO1001 (A PROGRAM LONG ENOUGH TO BE TAKEN FOR ONE)\nG0 X1. Y2.\nG1 Z-1. "
                          "F100.\nGOTO 99 (\x1B[2J\x07)\nM30\n%\n");
    const Finished finished = run({"."});
    EXPECT_THAT(finished.out, AllOf(HasSubstr("MAC301"), HasSubstr("\\x1B[2J\\x07")));
    EXPECT_THAT(finished.out, AllOf(Not(HasSubstr("\x1B")), Not(HasSubstr("\x07"))));
    EXPECT_THAT(run({"x\x1B[31m"}).err, Not(HasSubstr("\x1B")));
}

TEST_F(Executable, EscapesWhatFilesAreCalled) {
    folder.write("O1\x1B[31m.nc", with_defect);
    const Finished finished = run({"."});
    EXPECT_THAT(finished.out, AllOf(HasSubstr("O1\\x1B[31m.nc"), Not(HasSubstr("\x1B"))));
}

TEST_F(Executable, ColoursOnlyWhenAsked) {
    folder.write("O1001.nc", with_defect);
    EXPECT_THAT(run({}).out, Not(HasSubstr("\x1B")));
    EXPECT_THAT(run({"--color", "always"}).out, HasSubstr("\x1B[1;31merror"));
}

TEST_F(Executable, WritesTheSameWhateverTheNumberOfThreads) {
    for (int i = 0; i < 40; ++i)
        folder.write("O" + std::to_string(2000 + i) + ".nc", "%\nO" + std::to_string(2000 + i) +
                                                                 "\nGOTO 99\nG65 P" +
                                                                 std::to_string(2001 + i) + "\nM99\n%\n");
    for (const char* format : {"text", "json", "sarif", "github", "gitlab", "junit", "checkstyle"}) {
        const std::string one = run({"--no-timestamps", "--format", format, "--jobs", "1"}).out;
        EXPECT_GT(one.size(), 1000U);
        EXPECT_EQ(one, run({"--no-timestamps", "--format", format, "--jobs", "7"}).out) << format;
    }
}

TEST_F(Executable, WritesSeveralReportsAtOnce) {
    folder.write("O1001.nc", with_defect);
    const Finished finished = run({"--output", "sarif:out.sarif", "--output", "json:out.json"});
    EXPECT_THAT(finished.out, HasSubstr("MAC301"));
    const auto sarif = nlohmann::json::parse(read_file(folder.path() / "out.sarif"));
    EXPECT_EQ(sarif["runs"][0]["results"][0]["ruleId"], "MAC301");
    EXPECT_EQ(sarif["runs"][0]["invocations"][0]["exitCode"], 1);
    EXPECT_EQ(nlohmann::json::parse(read_file(folder.path() / "out.json"))["summary"]["errors"], 1);
}

TEST_F(Executable, CountsFindingsWhereNoReportIsDisturbed) {
    folder.write("O1001.nc", with_defect);
    EXPECT_THAT(run({"--statistics"}).out, HasSubstr("findings by rule:\n  1  MAC301"));
    const Finished sarif = run({"--statistics", "--format", "sarif"});
    EXPECT_TRUE(nlohmann::json::accept(sarif.out));
    EXPECT_THAT(sarif.err, HasSubstr("findings by rule:\n  1  MAC301"));
    const Finished json = run({"--statistics", "--format", "json"});
    EXPECT_THAT(json.err, IsEmpty());
    EXPECT_EQ(nlohmann::json::parse(json.out)["statistics"]["files"][0]["findings"], 1);
}

TEST_F(Executable, EndsWith2WhenAReportCannotBeWritten) {
    folder.write("O1000.nc", without_defect);
    const Finished finished = run({"--output", "sarif:no/such/folder.sarif"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("no/such/folder.sarif: cannot be written"));
}

TEST_F(Executable, WritesNoReportOverAProgram) {
    folder.write("O1001.nc", with_defect);
    folder.write("PART7", without_defect);              // found by no name
    folder.write("PART8.txt", "G0 X1.\nG1 Y2. F100\n"); // without marks of a language
    folder.write("klartext", "0 BEGIN PGM A MM\n1 L X+1 R0 FMAX M3\n2 END PGM A MM\n");
    folder.write(".maclint.json", "{}");
    const TemporaryFolder beside;
    const std::string link = (beside.path() / "link.json").string();
    fs::create_symlink(folder.path() / "O1001.nc", link);
    const std::vector<std::pair<std::string, std::string>> refused = {
        {"O1001.nc", "is one of the files to check"}, {"./sub/../O1001.nc", "is one of the files to check"},
        {link, "is one of the files to check"},       {"PART7", "holds an NC program"},
        {"PART8.txt", "holds an NC program"},         {"klartext", "holds an NC program"},
        {".maclint.json", "is a configuration"},      {"O77", "is named like an NC program"},
        {"new.NC", "is named like an NC program"}};
    folder.write("sub/x", "");
    for (const auto& [target, reason] : refused) {
        const Finished finished = run({"O1001.nc", "--output", "json:" + target});
        EXPECT_EQ(finished.status, 2) << target;
        EXPECT_THAT(finished.out, IsEmpty()) << target;
        EXPECT_THAT(finished.err, AllOf(HasSubstr("'" + target + "'"), HasSubstr(reason))) << target;
    }
    EXPECT_EQ(read_file(folder.path() / "O1001.nc"), with_defect);
    EXPECT_EQ(read_file(folder.path() / "PART7"), without_defect);
    EXPECT_EQ(read_file(folder.path() / ".maclint.json"), "{}");
    EXPECT_FALSE(fs::exists(folder.path() / "O77"));
}

TEST_F(Executable, WritesReportsOverEarlierReports) {
    folder.write("O1001.nc", with_defect);
    folder.write("O1000.nc", without_defect);
    for (const std::string format :
         {"text:", "concise:", "json:", "sarif:", "github:", "gitlab:", "junit:", "checkstyle:"})
        for (const std::string program : {"O1001.nc", "O1000.nc", "."})
            for (const std::string name : {"report.txt", "report"}) {
                const Finished finished = run({program, "--output", format + name});
                EXPECT_NE(finished.status, 2) << format << ' ' << program << ' ' << finished.err;
            }
}

TEST_F(Executable, WritesReportsOverEarlierReportsThatQuoteAnotherControl) {
    folder.write("O1.nc", "N10 GOTOF N40\nN40 G1 X30 Y60\nN100 SKOK:\nN140 GOTOB SKOK\n");
    for (const std::string format : {"text", "concise"})
        for (int i = 0; i < 2; ++i) {
            const Finished finished = run({"--dialect", "fanuc", "O1.nc", "--output", format + ":report"});
            EXPECT_EQ(finished.status, 1) << format << ' ' << finished.err;
        }
}

TEST_F(Executable, ShowsNoMoreFindingsThanAskedButFailsForAll) {
    folder.write("O1001.nc", "%\nO1001\nGOTO98\nM30\nO1002\nGOTO99\nM30\n%\n");
    const Finished finished = run({"--max-findings", "1", "--select", "MAC301"});
    EXPECT_EQ(finished.status, 1);
    EXPECT_THAT(finished.out, HasSubstr("2 errors in 1 file (1 checked, 1 not shown: see --max-findings)"));
    EXPECT_EQ(run({"--max-findings", "0"}).status, 1);
}

TEST_F(Executable, FollowsTheConfiguration) {
    folder.write(".maclint.json",
                 R"({"exclude": ["old"], "include": ["*.part"], "per-file-ignores": {"O9*": ["MAC301"]}})");
    folder.write("old/O1.nc", with_defect);
    folder.write("tray.part", with_defect);
    folder.write("O9001.nc", with_defect);
    const std::string out = concise({"."});
    EXPECT_THAT(out, AllOf(HasSubstr("tray.part:4"), Not(HasSubstr("old/")), Not(HasSubstr("O9001"))));
    EXPECT_THAT(concise({"--isolated", "."}),
                AllOf(HasSubstr("old/O1.nc"), HasSubstr("O9001"), Not(HasSubstr("tray.part"))));
}

TEST_F(Executable, TellsOfAWrongConfigurationOnceAndEndsWith2) {
    folder.write(".maclint.json", "{\n  \"ignor\": []\n}\n");
    folder.write("O1001.nc", with_defect);
    folder.write("O1002.nc", with_defect);
    const Finished finished = run({});
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(finished.err, "maclint: error: .maclint.json: line 2, column 3: there is no key 'ignor' here. "
                            "Did you mean 'ignore'?\n");
}

TEST_F(Executable, PointsIntoTheConfigurationWhenItNamesAnUnknownRule) {
    folder.write(".maclint.json", "{\n  \"select\": [\"MAC3O1\"]\n}\n");
    folder.write("O1001.nc", with_defect);
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{}, {"--select", "MAC301"}, {"--ignore", "MAC002"}}) {
        const Finished finished = run(arguments);
        EXPECT_EQ(finished.status, 2);
        EXPECT_EQ(finished.err, "maclint: error: .maclint.json: line 2, column 14: there is no rule "
                                "'MAC3O1'. Did you mean 'MAC301'?\n");
    }
}

TEST_F(Executable, ShowsWhatHoldsForAFile) {
    folder.write(".maclint.json",
                 R"({"files": [{"glob": "*.nc", "control": "fanuc-30i"}], "ignore": ["MAC301"]})");
    folder.write("O1000.nc", without_defect);
    const Finished finished = run({"--show-config"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_THAT(finished.out,
                AllOf(HasSubstr("O1000.nc\n"), HasSubstr("fanuc-30i"), HasSubstr("files '*.nc'"),
                      HasSubstr("MAC301 off (.maclint.json: ignore)")));
}

TEST_F(Executable, ReadsALatheTextAsSuchWhateverControlIsNamed) {
    folder.write(".maclint.json", R"({"controls": {"Turn 2": {"model": "fanuc-30i"}},
        "files": [{"glob": "O1*", "control": "Turn 2"}, {"glob": "O2*", "control": "fanuc-16i"},
                  {"glob": "O3*", "control": "fanuc-16i-lathe"}]})");
    const std::string turning = "\nG50S2000\nT0101\nG96S200M3\nG0X50.Z2.\nG90X40.Z-20.F.2\nM30\n";
    for (const std::string name : {"O1", "O2", "O3", "O4"}) folder.write(name, name + turning);
    folder.write("O11", "O11\nT1M6\nG43H1Z50.\nG1X1.F100\nM30\n");
    EXPECT_THAT(run({"--show-config", "O1"}).out,
                HasSubstr("fanuc-30i-lathe, Turn 2 (FANUC Series 30i/31i/32i, lathe with G code system A) "
                          "(.maclint.json: files 'O1*'; the text is written for a lathe)"));
    EXPECT_THAT(run({"--show-config", "O2"}).out,
                AllOf(HasSubstr("fanuc-16i-lathe, "), HasSubstr("'O2*'; the text is written for a lathe)")));
    EXPECT_THAT(run({"--show-config", "O3"}).out,
                AllOf(HasSubstr("fanuc-16i-lathe, "), HasSubstr("(.maclint.json: files 'O3*')")));
    EXPECT_THAT(run({"--show-config", "O4", "--control", "haas"}).out,
                HasSubstr("(--control; the text is written for a lathe)"));
    EXPECT_THAT(run({"--show-config", "O4"}).out,
                HasSubstr("(assumed for the dialect; the text is written for a lathe)"));
    EXPECT_THAT(run({"--show-config", "O11"}).out,
                AllOf(HasSubstr("fanuc-30i, Turn 2"), HasSubstr("(.maclint.json: files 'O1*')")));
}

TEST_F(Executable, ExplainsRulesAndGuessesMistypedOnes) {
    EXPECT_THAT(run({"explain", "Jump-Into-Loop"}).out, HasSubstr("MAC303"));
    const Finished mistyped = run({"explain", "jump-into-lop"});
    EXPECT_EQ(mistyped.status, 2);
    EXPECT_THAT(mistyped.err, HasSubstr("Did you mean 'jump-into-loop'?"));
}

TEST_F(Executable, ExplainsARuleByAPartOfItsCodeOrName) {
    EXPECT_THAT(run({"explain", "220"}).out, HasSubstr("MAC220 zero-test-misses-vacant (variables"));
    const Finished jumps = run({"explain", "Jump"});
    EXPECT_EQ(jumps.status, 0);
    EXPECT_THAT(jumps.out, AllOf(HasSubstr("MAC301 jump-target-missing"), HasSubstr("MAC303 jump-into-loop"),
                                 HasSubstr("rules may be meant by 'Jump'.")));
    EXPECT_THAT(run({"explain", "MAC3"}).out,
                AllOf(HasSubstr("MAC301"), HasSubstr("MAC336"), Not(HasSubstr("MAC4"))));
    EXPECT_EQ(run({"explain", "999"}).status, 2);
}

TEST_F(Executable, ExplainsWithTheLineMarkedTheSourcesResolvedAndLinesWrapped) {
    const Finished page = run({"explain", "MAC301"});
    EXPECT_THAT(page.out, HasSubstr("\n    O9301(CHECK)\n  > IF[#100EQ1]GOTO70\n    #100=1\n"));
    EXPECT_THAT(page.out,
                HasSubstr("\n    NCT 99M/2000M, programmer's manual, the page of that number (NCT-188)\n"));
    std::istringstream lines(page.out);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
    EXPECT_THAT(page.out, Not(HasSubstr("\x1B")));
    EXPECT_THAT(run({"explain", "MAC301", "--color", "always"}).out,
                HasSubstr("\x1B[1;31m> IF[#100EQ1]GOTO70\x1B[0m"));
}

TEST_F(Executable, ExplainsHowFarToTrustASourceAndHowEachLanguageAllowsARule) {
    EXPECT_THAT(run({"explain", "MAC506"}).out, HasSubstr("T (experience, not confirmed)"));
    EXPECT_THAT(
        run({"explain", "MAC462"}).out,
        AllOf(HasSubstr("T (experience, not confirmed): search order"),
              HasSubstr(
                  "    (MACLINT ALLOW MAC462 - REASON)\n    [MACLINT ALLOW MAC462 - REASON] (dinplus)\n")));
    EXPECT_THAT(run({"explain", "DIN330"}).out, Not(HasSubstr("(MACLINT")));
}

TEST_F(Executable, NotesGlobsThatTakeNoProgram) {
    folder.write("shop/lathe/O1.nc", without_defect);
    folder.write(".maclint.json", R"({"files": [{"glob": "lathe/*.nc", "control": "fanuc-16i"}],
        "per-file-ignores": {"*.nc": ["MAC501"]}, "include": ["*.tap"], "exclude": ["old"]})");
    const std::string told = run({}).err;
    EXPECT_THAT(told,
                HasSubstr("files 'lathe/*.nc' takes no program of the folder. Write \"**/lathe/*.nc\""));
    EXPECT_THAT(told, HasSubstr("include '*.tap' takes no program"));
    EXPECT_THAT(told, testing::Not(HasSubstr("'*.nc'")));
    EXPECT_EQ(run({"shop"}).err, "") << "who looks at a part sees not all files";
    EXPECT_EQ(run({"--isolated"}).err, "");
    EXPECT_THAT(run({"--format", "sarif", "--quiet"}).out, HasSubstr("NOTE009"));
}

TEST_F(Executable, NotesFilesThatWereMeantForAConfiguration) {
    folder.write("O1.nc", without_defect);
    folder.write("maclint.json", R"({"ignore": ["MAC501"]})");
    EXPECT_THAT(run({}).err,
                HasSubstr("maclint.json: is not read: a configuration is named .maclint.json. Rename it."));
    folder.write("maclint.json", R"({"version": 1, "findings": []})");
    EXPECT_EQ(run({}).err, "") << "a report";
    fs::remove(folder.path() / "maclint.json");
    folder.write(".maclint.json.txt", R"({"ignore": ["MAC501"]})");
    EXPECT_THAT(run({}).err, HasSubstr(".maclint.json.txt: is not read"));
    folder.write(".maclint.json", "{}");
    EXPECT_EQ(run({}).err, "");
}

TEST_F(Executable, ShowsConfigurationsAsJson) {
    folder.write("shop.json", R"({"ignore": ["MAC501"]})");
    folder.write(".maclint.json", R"({"extends": "shop.json", "complete": true})");
    folder.write("O1.nc", without_defect);
    const auto json = nlohmann::json::parse(run({"--show-config", "--format", "json"}).out);
    EXPECT_EQ(json["version"], 1);
    const auto& file = json["files"][0];
    EXPECT_EQ(file["file"], "O1.nc");
    EXPECT_EQ(file["configuration"]["value"], ".maclint.json");
    EXPECT_EQ(file["configuration"]["reason"], "it extends shop.json");
    EXPECT_EQ(file["callers"]["reason"], ".maclint.json: complete");
    EXPECT_EQ(file["changes"][0],
              (nlohmann::json{{"reason", "shop.json: ignore"}, {"rules", {"MAC501 off"}}}));
    EXPECT_EQ(run({"--show-config", "--format", "sarif"}).status, 2);
    EXPECT_THAT(run({"--show-config", "--output", "json:a.json"}).err, HasSubstr("it writes no report"));
    EXPECT_THAT(run({"--show-config"}).out, HasSubstr("MAC501 off (shop.json: ignore)"));
}

/// Lines wider than a terminal of 80 columns.
std::vector<std::string> wide_lines(const std::string& text) {
    std::vector<std::string> wide;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line.size() > 80 && !line.starts_with("  maclint ")) wide.push_back(line); // which is to be typed
    return wide;
}

TEST_F(Executable, KeepsHelpAndListsWithin80ColumnsAndCutsNoWord) {
    for (const std::string command :
         {"check", "rules", "explain", "controls", "completions", "man", "help", "version"}) {
        const std::string help = run({"help", command}).out;
        EXPECT_THAT(wide_lines(help), IsEmpty()) << command;
        EXPECT_THAT(
            help, AllOf(HasSubstr("Usage: maclint "), HasSubstr("  -h, --help                 This text\n")));
    }
    for (const std::string list : {"rules", "controls"})
        EXPECT_THAT(wide_lines(run({list}).out), IsEmpty()) << list;
    EXPECT_THAT(wide_lines(run({"explain", "jump"}).out), IsEmpty());
    const std::string help = run({"--help"}).out;
    EXPECT_THAT(
        help,
        HasSubstr(
            "\nWhich rules:\n  --select RULES             Only these rules: codes, names, rows such as\n"
            "                             MAC523/G83.Q, prefixes such as MAC3, ALL\n"));
    EXPECT_THAT(help, HasSubstr("\nExamples:\n  maclint\n    Check all programs"));
    EXPECT_THAT(run({"rules"}).out,
                HasSubstr("\n  MAC005 other-control                         warning\n"
                          "         The program is written for another control; what it says here is\n"
                          "         withheld\n"));
}

TEST_F(Executable, ListsRulesAndWritesTheirPages) {
    EXPECT_THAT(run({"rules"}).out, HasSubstr("MAC303 jump-into-loop"));
    EXPECT_GT(nlohmann::json::parse(run({"rules", "--format", "json"}).out)["rules"].size(), 10U);
    EXPECT_EQ(run({"rules", "--write-docs", "docs"}).status, 0);
    folder.write("docs/MAC000.md", "gone");
    folder.write("docs/MACHINES.md", "the user's");
    folder.write("docs/DINNER.md", "the user's");
    EXPECT_EQ(run({"rules", "--write-docs", "docs"}).status, 0);
    EXPECT_TRUE(fs::exists(folder.path() / "docs/MACHINES.md"));
    EXPECT_TRUE(fs::exists(folder.path() / "docs/DINNER.md"));
    const std::string page = read_file(folder.path() / "docs/MAC303.md");
    EXPECT_THAT(page, StartsWith("# MAC303 jump-into-loop\n"));
    EXPECT_FALSE(fs::exists(folder.path() / "docs/MAC000.md"));
    EXPECT_THAT(read_file(folder.path() / "docs/README.md"), HasSubstr("[MAC303](MAC303.md)"));
}

TEST_F(Executable, WritesNoPagesIntoAFolderOfSomebodyElse) {
    folder.write("notes/README.md", "# Notes of the shop\n");
    folder.write("notes/MAC000.md", "the user's");
    const Finished finished = run({"rules", "--write-docs", "notes"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("Name an empty folder."));
    EXPECT_EQ(read_file(folder.path() / "notes/README.md"), "# Notes of the shop\n");
    EXPECT_TRUE(fs::exists(folder.path() / "notes/MAC000.md"));
    EXPECT_FALSE(fs::exists(folder.path() / "notes/MAC303.md"));
    EXPECT_THAT(run({"rules", "--write-docs", "notes/MAC000.md"}).err, HasSubstr("cannot be written"));
}

TEST_F(Executable, TakesAControlForTheFilesOfItsLanguageOnly) {
    folder.write("O1000.nc", without_defect);
    folder.write("PART.ncs", "MACHINING\nN10 G14 Q0\nN20 M30\nEND\n");
    const Finished both = run({"--control", "fanuc-30i", "--show-config"});
    EXPECT_EQ(both.status, 0) << both.err;
    EXPECT_THAT(both.out, AllOf(HasSubstr("fanuc-30i, "), HasSubstr("(--control)"), HasSubstr("dinplus, "),
                                HasSubstr("(assumed for the dialect)")));
    EXPECT_EQ(run({"--control", "fanuc-30i"}).status, 0);
    EXPECT_EQ(run({"--control", "dinplus"}).status, 0);
    EXPECT_EQ(run({"--control", "dinplus", "O1000.nc"}).status, 0);
}

TEST_F(Executable, TakesAConfiguredControlForTheFilesOfItsLanguageOnly) {
    folder.write("O1000.nc", without_defect);
    folder.write("PART.ncs", "MACHINING\nN10 G14 Q0\nN20 M30\nEND\n");
    folder.write(".maclint.json", R"({"controls": {"L": {"model": "dinplus"}, "M": {"model": "fanuc-30i"}},
        "files": [{"glob": "*", "control": "L"}, {"glob": "*", "control": "M"}]})");
    const Finished finished = run({"--show-config"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.out, AllOf(HasSubstr("fanuc-30i, M"), HasSubstr("dinplus, L")));
    EXPECT_EQ(run({}).status, 0);
}

TEST_F(Executable, RefusesAControlOfAnotherLanguageThanTheDialectAskedFor) {
    folder.write("O1000.nc", without_defect);
    const Finished finished = run({"--dialect", "fanuc", "--control", "dinplus"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, AllOf(HasSubstr("--control dinplus"), HasSubstr("--dialect fanuc")));
    EXPECT_EQ(run({"--dialect", "nct", "--control", "fanuc-30i"}).status, 0);
    folder.write(".maclint.json", R"({"files": [{"glob": "*", "control": "dinplus", "dialect": "fanuc"}]})");
    const Finished configured = run({});
    EXPECT_EQ(configured.status, 2);
    EXPECT_THAT(configured.err, AllOf(HasSubstr("'dinplus'"), HasSubstr("'fanuc'")));
}

TEST_F(Executable, CountsWhatItDoesNotShow) {
    folder.write("O1001.nc", "%\nO1001\nGOTO 97\nM30\nO1002\nGOTO 98\nM30\nO1003\nGOTO 99\nM30\n%\n");
    EXPECT_EQ(run({"--max-findings", "0"}).out,
              "3 errors in 1 file (1 checked, 3 not shown: see --max-findings)\n");
    EXPECT_THAT(run({"--max-findings", "2"}).out,
                HasSubstr("3 errors in 1 file (1 checked, 1 not shown: see --max-findings)\n"));
    const auto report = nlohmann::json::parse(run({"--max-findings", "1", "--format", "json"}).out);
    EXPECT_EQ(report.at("findings").size(), 1U);
    EXPECT_EQ(report.at("summary").at("errors"), 3);
    EXPECT_EQ(report.at("summary").at("not_shown"), 2);
}

TEST_F(Executable, ShowsATerminalAHundredFindingsAndAFileAll) {
    std::string text = "%\n";
    for (int i = 0; i < 130; ++i) text += "O" + std::to_string(1001 + i) + "\nGOTO98\nM30\n";
    folder.write("O1001.nc", text + "%\n");
    const auto count = [](const Finished& finished) {
        std::size_t findings = 0;
        for (std::size_t at = 0; (at = finished.out.find("error[MAC301]", at)) != std::string::npos; ++at)
            ++findings;
        return findings;
    };
    const auto on_terminal = [&](const std::vector<std::string>& arguments) {
        return test::run_maclint_on_terminal(folder.path().string(), arguments, 60);
    };
    const Finished shown = on_terminal({"--color", "never"});
    EXPECT_EQ(count(shown), 100U);
    EXPECT_EQ(shown.status, 1);
    EXPECT_THAT(shown.out, HasSubstr("130 errors in 1 file (1 checked, 30 not shown: see --max-findings)"));
    std::istringstream lines(shown.out.substr(0, shown.out.find("130 errors")));
    // A slow run shows its progress on the same terminal, and erases it.
    const std::string erase = "\x1b[K";
    for (std::string line; std::getline(lines, line);) {
        if (const auto erased = line.rfind(erase); erased != std::string::npos)
            line.erase(0, erased + erase.size());
        EXPECT_LE(line.size(), 60U) << line;
    }
    EXPECT_EQ(count(on_terminal({"--color", "never", "--max-findings", "all"})), 130U);
    EXPECT_EQ(count(on_terminal({"--color", "never", "--format", "concise"})), 100U);
    EXPECT_EQ(count(run({})), 130U);
    // A slow run would show its progress on the same terminal.
    EXPECT_EQ(nlohmann::json::parse(on_terminal({"--format", "json", "--quiet"}).out).at("findings").size(),
              130U);
    EXPECT_THAT(on_terminal({}).out, HasSubstr("\x1B[1;31m"));
}

TEST_F(Executable, SetsTheSeverityThatTheRuleItselfHas) {
    folder.write("PART.ncs",
                 "MACHINING\nN10 INPUT(\"Radius\",#l2)\n"
                 "N20 #l4=(((((((#l2*2)+1)*3)+2)*2)-1)*4)\nN30 PRINT(\"Feed\",#l4)\nN40 M30\nEND\n");
    EXPECT_THAT(concise({"--select", "MAC701"}), HasSubstr("note[MAC701]"));
    EXPECT_THAT(concise({"--select", "MAC701", "--severity", "MAC701=error"}), HasSubstr("error[MAC701]"));
    folder.write(".maclint.json", R"({"severity": {"MAC701": "error"}})");
    EXPECT_THAT(concise({"--select", "MAC701"}), HasSubstr("error[MAC701]"));
}

TEST_F(Executable, PassesOverWhatAnExtendedConfigurationExcludesInItsOwnFolder) {
    folder.write("shop.json", R"({"exclude": ["lathe/old"]})");
    folder.write("lathe/.maclint.json", R"({"extends": "../shop.json"})");
    folder.write("lathe/O1001.nc", with_defect);
    folder.write("lathe/old/O1002.nc", with_defect);
    EXPECT_THAT(concise({}), AllOf(HasSubstr("lathe/O1001.nc:4"), Not(HasSubstr("old"))));
}

} // namespace
} // namespace maclint::test
