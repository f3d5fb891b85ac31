//! What goes wrong around maclint: full disks, pipes, files that are gone, names that nobody meant.
#include "tests/support/in_repository.hpp"

#include <csignal>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// Whether the tests, and so the executable, are compiled with a sanitizer, which takes terabytes of
/// addresses.
constexpr bool sanitized() {
#if defined(__SANITIZE_ADDRESS__)
    return true;
#elif defined(__has_feature)
    return __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
    return false;
#endif
}

class Faults : public InRepository {
  protected:
    void SetUp() override {
        InRepository::SetUp();
        folder.write("O1001.nc", with_defect);
    }

    [[nodiscard]] std::vector<std::string> names() const {
        std::vector<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder.path()))
            names.push_back(entry.path().filename());
        std::ranges::sort(names);
        return names;
    }
    /// As a report where report.json, which is not there, takes one.
    void expect_refused_beside_a_report(const std::string& other) const {
        const Finished finished = run({"--output", "json:report.json", "--output", "sarif:" + other});
        EXPECT_EQ(finished.status, 2) << other;
        EXPECT_THAT(finished.err, HasSubstr("Name another file for one of the reports.")) << other;
        EXPECT_THAT(finished.out, IsEmpty()) << other;
        EXPECT_FALSE(fs::exists(folder.path() / "report.json")) << other;
    }
    /// So many programs that their report does not fit into a pipe.
    void write_many() const {
        for (int i = 0; i < 300; ++i) folder.write("many/O" + std::to_string(2000 + i) + ".nc", with_defect);
    }
};

TEST_F(Faults, AFullDiskIsAnErrorAndEveryOtherReportIsWritten) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    const Finished printed = shell("$maclint --output json:report.json > /dev/full");
    EXPECT_EQ(printed.status, 2);
    EXPECT_THAT(printed.err, StartsWith("maclint: error: standard output: cannot be written: "));
    EXPECT_THAT(read_file(folder.path() / "report.json"), HasSubstr("MAC301"));
    const Finished written = run({"--output", "sarif:/dev/full", "--format", "concise"});
    EXPECT_EQ(written.status, 2);
    EXPECT_THAT(written.err, StartsWith("maclint: error: /dev/full: cannot be written: "));
    EXPECT_THAT(written.out, HasSubstr("O1001.nc:4:1: error[MAC301]"));
}

TEST_F(Faults, APipeThatIsClosedEndsTheRunButNotTheOtherReports) {
    write_many();
    const Finished cut =
        shell("{ $maclint --output json:report.json; echo $? > status; } | head -c 1 > /dev/null");
    EXPECT_EQ(read_file(folder.path() / "status"), "141\n"); // SIGPIPE, as of other tools
    EXPECT_THAT(cut.err, IsEmpty());
    EXPECT_THAT(read_file(folder.path() / "report.json"), EndsWith("}\n"));
    const Finished other =
        shell("mkfifo pipe; head -c 1 pipe > first & $maclint --format concise --output json:pipe");
    EXPECT_EQ(other.status, 2);
    EXPECT_THAT(other.err, StartsWith("maclint: error: pipe: cannot be written: "));
    EXPECT_THAT(other.out, HasSubstr("O1001.nc:4:1: error[MAC301]"));
}

TEST_F(Faults, APipeThatNobodyReadsIsNotWaitedForForEver) {
    const Finished finished = shell("mkfifo pipe; $maclint --format concise --output json:pipe");
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("nobody has read this pipe for 10 seconds"));
    EXPECT_THAT(finished.out, HasSubstr("O1001.nc:4:1: error[MAC301]"));
}

TEST_F(Faults, APipeThatStaysSilentIsNotWaitedForForEver) {
    const Finished program = shell("mkfifo p.nc; exec 9<>p.nc; $maclint --format concise O1001.nc p.nc");
    EXPECT_EQ(program.status, 2);
    EXPECT_THAT(program.err,
                StartsWith("maclint: error: p.nc: cannot be read: nothing has come through this pipe "
                           "for 10 seconds."));
    EXPECT_THAT(program.out, HasSubstr("O1001.nc:4:1: error[MAC301]"));
}

TEST_F(Faults, AConfigurationThatIsASilentPipeIsAnError) {
    const Finished finished = shell("mkfifo c.json; exec 9<>c.json; $maclint --config c.json");
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("nothing has come through this pipe for 10 seconds."));
}

TEST_F(Faults, AWorkingFolderThatIsGoneIsAnError) {
    const Finished relative = shell("mkdir gone; cd gone; rmdir ../gone; $maclint; $maclint O1.nc");
    EXPECT_EQ(relative.status, 2);
    EXPECT_THAT(relative.err,
                AllOf(HasSubstr("error: .: cannot be found: the folder in which maclint was started is gone"),
                      HasSubstr("error: O1.nc: cannot be found: ")));
    const Finished absolute = shell("mkdir gone; cd gone; rmdir ../gone; $maclint --format concise " +
                                    (folder.path() / "O1001.nc").string());
    EXPECT_EQ(absolute.status, 1);
    EXPECT_THAT(absolute.out, HasSubstr("O1001.nc:4:1: error[MAC301]"));
}

TEST_F(Faults, AnEmptyPathIsAnErrorAndTheOthersAreLinted) {
    const Finished finished = run({"", "O1001.nc", "--format", "concise"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, StartsWith("maclint: error: one of the paths is empty and names no file."));
    EXPECT_THAT(finished.out, HasSubstr("O1001.nc:4:1: error[MAC301]"));
    for (const char* option : {"--config", "--stdin-filename"}) {
        const Finished refused = run({option, "", "O1001.nc"});
        EXPECT_EQ(refused.status, 2) << option;
        EXPECT_THAT(refused.err, HasSubstr(std::string(option) + " wants the name of a file."));
    }
}

TEST_F(Faults, StandardInputIsReadOnceAndStandsForTheFileOfItsName) {
    const Finished twice = run({"-", "-", "--format", "concise"}, std::string(with_defect));
    EXPECT_THAT(twice.out, HasSubstr("1 error in 1 file (1 checked)"));
    EXPECT_THAT(twice.err, IsEmpty());
    for (const char* beside : {"O1001.nc", "."}) {
        const Finished named =
            run({beside, "-", "--stdin-filename", "O1001.nc"}, std::string(without_defect));
        EXPECT_EQ(named.status, 0) << beside;
        EXPECT_THAT(named.out, HasSubstr("no findings (1 checked)")) << beside;
    }
}

TEST_F(Faults, NoFileTakesTwoReports) {
    folder.write("sub/x", "");
    for (const char* other : {"report.json", "./report.json", "sub/../report.json"})
        expect_refused_beside_a_report(other);
}

TEST_F(Faults, NoFileTakesTwoReportsThroughALinkToIt) {
    fs::create_symlink("report.json", folder.path() / "link");
    expect_refused_beside_a_report("link");
}

TEST_F(Faults, StandardOutputTakesOneReport) {
    for (const char* arguments :
         {"--output json:- --output sarif:-", "--output json:- --output sarif:/dev/stdout",
          "--format json --output sarif:/dev/stdout", "--output json:out.json",
          "--output text:../{}/out.json"}) {
        std::string words = arguments;
        if (const auto at = words.find("{}"); at != std::string::npos)
            words.replace(at, 2, folder.path().filename().string());
        const Finished finished = shell("$maclint " + words + " > out.json");
        EXPECT_EQ(finished.status, 2) << words;
        EXPECT_THAT(finished.err, StartsWith("maclint: error: --")) << words;
        EXPECT_THAT(read_file(folder.path() / "out.json"), IsEmpty()) << words;
    }
    EXPECT_EQ(shell("$maclint --output json:/dev/stdout > out.json").status, 1);
    EXPECT_THAT(read_file(folder.path() / "out.json"), StartsWith("{"));
    EXPECT_EQ(shell("$maclint --output json:/dev/null > /dev/null").status, 1);
}

TEST_F(Faults, KeysOfAHundredKilobytesGiveAShortMessage) {
    const std::string key(100'000, 'k');
    for (const std::string& text :
         {"{\"" + key + "\": 1}", R"({"controls": {"A": {"model": ")" + key + "\"}}}",
          R"({"select": [")" + key + "\"]}", R"({"files": [{"glob": "*", "control": ")" + key + "\"}]}"}) {
        folder.write(".maclint.json", text);
        const Finished finished = run({});
        EXPECT_EQ(finished.status, 2);
        EXPECT_THAT(finished.err, StartsWith("maclint: error: .maclint.json: line 1, column "));
        EXPECT_LT(finished.err.size(), 1200U);
    }
    folder.write(".maclint.json", R"({"exclude": [")" + key + R"("], "per-file-ignores": {")" + key +
                                      R"(*": ["MAC301"]},
        "controls": {")" + key + R"(": {"model": "fanuc-30i"}}})");
    EXPECT_EQ(run({}).status, 1);
}

TEST_F(Faults, AFileTooLargeForMemoryDoesNotEndTheRunForOthers) {
    if (sanitized()) GTEST_SKIP() << "a sanitizer takes more memory than may be given";
    folder.write("huge.nc", "");
    fs::resize_file(folder.path() / "huge.nc", std::uintmax_t{3} << 30U); // takes no disk space
    const Finished finished = shell("ulimit -v 1500000; $maclint --format concise --jobs 2");
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err,
                StartsWith("maclint: error: huge.nc: cannot be analysed: it does not fit into memory."));
    EXPECT_THAT(finished.out, HasSubstr("O1001.nc:4:1: error[MAC301]"));
    EXPECT_THAT(finished.out, HasSubstr("(1 checked)"));
}

TEST_F(Faults, AGroupTooLargeForMemoryDoesNotEndTheRunForOthers) {
    if (sanitized()) GTEST_SKIP() << "a sanitizer takes more memory than may be given";
    std::string text = "%\nO2000\n";
    for (int i = 0; i < 150'000; ++i)
        text += "IF[#" + std::to_string(i % 33 + 1) + "GT#" + std::to_string(500 + i % 200) + "]GOTO" +
                std::to_string(i % 1000) + "\n#" + std::to_string(i % 29 + 1) + "=#" +
                std::to_string(i % 31 + 1) + "+1\n";
    folder.write("large.nc", text + "M30\n%\n");
    const Finished finished = shell("ulimit -v 250000; $maclint --format concise --jobs 1");
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, StartsWith("maclint: error: large.nc: cannot be analysed: "));
    EXPECT_THAT(finished.out, HasSubstr("O1001.nc:4:1: error[MAC301]"));
}

TEST_F(Faults, FilesThatGoWhileTheyAreLintedAreErrorsNotDefects) {
    write_many();
    const Finished finished =
        shell("(for f in many/*; do rm $f; done) & $maclint --format concise; echo $?; wait");
    EXPECT_THAT(finished.err, Not(HasSubstr("inside maclint")));
    EXPECT_THAT(finished.out, HasSubstr("O1001.nc:4:1: error[MAC301]"));
}

TEST_F(Faults, WhatMayNotBeReadIsAnErrorAndTheOthersAreLinted) {
    folder.write("locked.nc", with_defect);
    folder.write("closed/O1.nc", with_defect);
    fs::permissions(folder.path(), fs::perms::all);
    fs::permissions(folder.path() / "locked.nc", fs::perms::none);
    fs::permissions(folder.path() / "closed", fs::perms::none);
    const auto finished = run_maclint_without_privileges(folder.path().string(), {"--format", "concise"});
    fs::permissions(folder.path() / "closed", fs::perms::owner_all);
    if (!finished) GTEST_SKIP() << "the executable cannot be started without privileges";
    EXPECT_EQ(finished->status, 2);
    EXPECT_THAT(finished->err, AllOf(HasSubstr("error: locked.nc: cannot be read: you have no permission"),
                                     HasSubstr("error: closed: this folder cannot be read")));
    EXPECT_THAT(finished->out, HasSubstr("O1001.nc:4:1: error[MAC301]"));
}

TEST_F(Faults, AnInterruptEndsTheRunAtOnceAndLeavesNoPartOfAReport) {
    std::string text = "%\nO2000\n";
    for (int i = 0; i < 20'000; ++i) text += "GOTO" + std::to_string(100 + i % 800) + "\n";
    folder.write("O2000.nc", text + "M30\n%\n");
    folder.write("report.json", "old");
    for (const char* delay : {"0.02", "0.1", "0.2", "0.4", "0.6", "0.8", "1"}) {
        const Finished finished =
            shell("$maclint --format concise --output json:report.json O2000.nc & sleep " +
                  std::string(delay) + "; kill -TERM $!; wait $!");
        EXPECT_THAT(finished.status, testing::AnyOf(128 + SIGTERM, 1)) << delay;
        EXPECT_THAT(names(), ElementsAre(".git", "O1001.nc", "O2000.nc", "report.json")) << delay;
        EXPECT_THAT(read_file(folder.path() / "report.json"), testing::AnyOf("old", EndsWith("}\n")))
            << delay;
    }
}

} // namespace
} // namespace maclint::test
