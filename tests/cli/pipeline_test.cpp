//! The executable in a pipeline: what is passed over, what is no program, and words of the command line.
#include "tests/support/in_repository.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace maclint::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

class Pipeline : public InRepository {
  protected:
    [[nodiscard]] Finished run(const std::vector<std::string>& arguments) const {
        return InRepository::run(arguments, std::string(with_defect));
    }
};

TEST_F(Pipeline, OptionsEndBehindTwoDashes) {
    folder.write("-q", with_defect);
    const Finished finished = run({"--format", "concise", "--", "-q"});
    EXPECT_THAT(finished.out, AllOf(StartsWith("-q:4:1: error[MAC301]"), HasSubstr("(1 checked)")));
    EXPECT_EQ(run({"--", "--", "-q"}).status, 2); // there is no file named --
    EXPECT_THAT(run({"rules", "--", "--format"}).err, HasSubstr("one word too many: '--format'"));
}

TEST_F(Pipeline, AUsageErrorPrintsNothingElse) {
    folder.write("O1.nc", with_defect);
    folder.write("part.mpf", "G0 X5\nM30\n");
    const std::vector<std::vector<std::string>> wrong = {{"--formt", "json"},
                                                         {"--format", "jsn"},
                                                         {"--jobs"},
                                                         {"--select", "MAC30l"},
                                                         {"--control", "nothing", "."},
                                                         {"--config", "gone", "."},
                                                         {"--output", "json:O1.nc"},
                                                         {"help", "me"}};
    for (const auto& arguments : wrong) {
        const Finished finished = run(arguments);
        EXPECT_EQ(finished.status, 2) << arguments.front();
        EXPECT_THAT(finished.out, IsEmpty()) << arguments.front();
        EXPECT_THAT(finished.err, StartsWith("maclint: error: ")) << arguments.front();
        EXPECT_EQ(std::ranges::count(finished.err, '\n'), 1) << finished.err;
    }
}

TEST_F(Pipeline, PassesOverWhatGitIgnoresInFolders) {
    folder.write(".gitignore", "out/\n*.tap\n");
    folder.write("O1.nc", without_defect);
    folder.write("O2.tap", with_defect);
    folder.write("out/O3.nc", with_defect);
    folder.write("README.md", "");
    folder.write("O1.old", "");
    const Finished finished = run({"."});
    EXPECT_EQ(finished.out,
              "no findings (1 checked, 1 file with another name passed over, 1 program ignored by git)\n");
    const auto summary = nlohmann::json::parse(run({"--format", "json"}).out)["summary"];
    EXPECT_EQ(summary["passed_over"],
              (nlohmann::json{{"other_names", 1}, {"ignored_by_git", 1}, {"links_out", 0}}));
    EXPECT_THAT(run({"--no-gitignore"}).out, HasSubstr("(3 checked, 1 file with another name passed over)"));
    EXPECT_THAT(run({"O2.tap"}).out, HasSubstr("(1 checked)")); // it was named
    EXPECT_THAT(run({"out"}).out, HasSubstr("(1 checked)"));
}

TEST_F(Pipeline, ExcludesHoldForNamedFilesWhenForced) {
    folder.write(".maclint.json", R"({"exclude": ["old"]})");
    folder.write(".gitignore", "*.tap\n");
    for (const char* name : {"old/O1.nc", "O2.tap", "O3.nc"}) folder.write(name, with_defect);
    folder.write("old/deep/.maclint.json", "{}"); // the nearest, which excludes nothing
    folder.write("old/deep/O4.nc", with_defect);
    const std::vector<std::string> named = {"old/O1.nc", "O2.tap", "O3.nc", "old/deep/O4.nc"};
    EXPECT_THAT(run(named).out, HasSubstr("(4 checked)"));
    auto forced = named;
    forced.emplace_back("--force-exclude");
    const Finished finished = run(forced);
    EXPECT_THAT(finished.out, HasSubstr("(1 checked)"));
    EXPECT_THAT(finished.err, HasSubstr("note: old/O1.nc: this is excluded or ignored by git"));
    forced.emplace_back("--no-gitignore");
    EXPECT_THAT(run(forced).out, HasSubstr("(2 checked)"));
    EXPECT_THAT(run({"--force-exclude", "old"}).out, HasSubstr("(0 checked)"));
    EXPECT_THAT(run({"--force-exclude", "-", "--stdin-filename", "old/O9.nc"}).out, HasSubstr("(0 checked)"));
    EXPECT_THAT(run({"-", "--stdin-filename", "old/O9.nc"}).out, HasSubstr("(1 checked)"));
}

TEST_F(Pipeline, ARunWithoutProgramsIsAnErrorWhenAsked) {
    folder.write("program.old", "");
    EXPECT_EQ(run({"."}).status, 0);
    EXPECT_THAT(run({"."}).err,
                HasSubstr("no NC program is in this folder (1 file with another name passed over)"));
    const Finished empty = run({"--error-on-empty", "--quiet", "."});
    EXPECT_EQ(empty.status, 2);
    EXPECT_EQ(empty.err,
              "maclint: error: no NC program was checked. Correct the paths, or leave --error-on-empty "
              "out.\n");
    folder.write("notes.md", "");
    EXPECT_EQ(run({"--error-on-empty", "notes.md"}).status, 2);
    folder.write("O1.nc", without_defect);
    EXPECT_EQ(run({"--error-on-empty", "."}).status, 0);
}

TEST_F(Pipeline, NamedFilesThatArePlainlyNoProgramsAreANote) {
    const std::vector<std::pair<std::string, std::string>> files = {
        {"logo.png", std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16)},
        {"parts.zip", std::string("PK\x03\x04\x14\0\0\0", 8)},
        {"drawing", "%PDF-1.4\n1 0 obj\nG0 X1.\n"},
        {"tool", std::string("\x7F"
                             "ELF\x02\x01\x01\0\0\0",
                             10)},
        {"main.cpp", "#include <vector>\nint main() {\n    return 0;\n}\n"},
        {"script", "import os\ndef first(name):\n    return 1\nclass X:\n    N = 5\n"},
        {"table.py", "G0 = 1\nG1 = 2\n"},
        {"data", "{\"a\": 1}\n"},
        {"data.xml", "<?xml version=\"1.0\"?>\n<a/>\n"},
        {"report", std::string()}};
    std::vector<std::string> names;
    for (const auto& [name, text] : files) folder.write(name, text), names.push_back(name);
    folder.write("O1.nc", with_defect);
    ASSERT_EQ(run({"O1.nc", "--output", "text:report"}).status, 1);
    const Finished finished = run(names);
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.out, "no findings (0 checked)\n");
    for (const std::string& name : names)
        EXPECT_THAT(finished.err, HasSubstr("maclint: note: " + name + ": this is not linted: ")) << name;
    for (const char* kind :
         {"(PNG image)", "(ZIP archive)", "(ELF program)", "Python source", "a report of maclint"})
        EXPECT_THAT(finished.err, HasSubstr(kind));
}

TEST_F(Pipeline, LintsNoneOfItsOwnReports) {
    folder.write("O1.nc", "O1\nGOTO 9 (A)\nG0 X1.\nM30\n");
    for (const char* format :
         {"text", "concise", "json", "sarif", "github", "gitlab", "junit", "checkstyle"}) {
        const std::string report = std::string("report-") + format + ".txt";
        ASSERT_EQ(run({"O1.nc", "--output", std::string(format) + ":" + report}).status, 1) << format;
        EXPECT_THAT(run({"."}).out, HasSubstr("(1 checked)")) << format;
        EXPECT_THAT(run({report}).err, HasSubstr(report + ": this is not linted")) << format;
        std::filesystem::remove(folder.path() / report);
    }
    ASSERT_EQ(run({"O1.nc", "--write-baseline", "base.json"}).status, 0);
    for (const char* format : {"text", "concise", "github"}) {
        const std::string output = std::string(format) + ":report.txt";
        ASSERT_EQ(run({"O1.nc", "--baseline", "base.json", "--output", output}).status, 0) << format;
        EXPECT_THAT(read_file(folder.path() / "report.txt"), StartsWith("no new findings (1 checked)\n"));
        EXPECT_THAT(run({"report.txt"}).err, HasSubstr("report.txt: this is not linted: ")) << format;
        EXPECT_EQ(run({"O1.nc", "--output", output}).status, 1) << format; // it may be written over
    }
    folder.write(
        "report.txt",
        "maclint: note: part.mpf: this is not linted.\nO1.nc:2:1: error[MAC301] Missing label: 'X'.\n");
    EXPECT_THAT(run({"report.txt"}).err, HasSubstr("report.txt: this is not linted: "));
    std::filesystem::remove(folder.path() / "report.txt");
    folder.write("O2.txt", "(ALL BORES checked)\nO2\nGOTO 9\nM30\n"); // begins like none
    folder.write("O3.txt", "(BORES) (4 checked)\nO3\nGOTO 9\nM30\n");
    EXPECT_THAT(run({"."}).out, HasSubstr("(3 checked)"));
}

TEST_F(Pipeline, KnowsProgramsByUnusualNames) {
    for (const char* name : {"O9010_TORUS", "o12-A", "nc40", "1234", "shaft.DIN", "a.min", "b.eia"})
        folder.write(name, without_defect);
    for (const char* name : {"O9010TORUS", "nc", "nc40a", "123456789", "Oil"})
        folder.write(name, "Oil the chuck.\n");
    EXPECT_EQ(run({"."}).out, "no findings (7 checked, 5 files with other names passed over)\n");
    folder.write("2024", "Minutes of the meeting,\nas everybody knows.\n"); // no program: nobody hears of it
    EXPECT_THAT(run({"."}).err, IsEmpty());
}

} // namespace
} // namespace maclint::test
