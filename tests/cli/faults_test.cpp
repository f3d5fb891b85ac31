//! What goes wrong around maclint: full disks, pipes, files that are gone, names that nobody meant.
#include "tests/support/in_repository.hpp"
#include "tests/support/lines.hpp"
#include "tests/support/sanitized.hpp"

#include <csignal>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

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

TEST_F(Faults, AFileThatIsTooLargeIsOneErrorAndTheOthersAreLinted) {
    const Finished sparse = shell("truncate -s 4294967296 big.nc; timeout 8 $maclint --format concise .");
    EXPECT_EQ(sparse.status, 2);
    EXPECT_EQ(sparse.err,
              "maclint: error: big.nc: cannot be read: it is larger than 1 GiB. Leave it out, or raise "
              "--max-file-size.\n");
    EXPECT_THAT(sparse.out, HasSubstr("O1001.nc:4:1: error[MAC301]"));
    const Finished limited = run({"--format", "concise", "--max-file-size", "20", "O1001.nc"});
    EXPECT_EQ(limited.status, 2);
    EXPECT_THAT(limited.err, HasSubstr("it is larger than 20 bytes."));
    EXPECT_EQ(run({"--format", "concise", "--max-file-size", "1 kB", "O1001.nc"}).status, 1);
}

TEST_F(Faults, StandardInputThatIsTooLargeIsAnError) {
    for (const char* input : {"cat O1001.nc |", "< O1001.nc"}) {
        const std::string words = "$maclint --format concise --max-file-size 20 -";
        const Finished finished =
            shell(std::string_view(input).ends_with('|') ? input + words : words + " " + input);
        EXPECT_EQ(finished.status, 2) << input;
        EXPECT_EQ(finished.err,
                  "maclint: error: stdin.nc: cannot be read: it is larger than 20 bytes. Leave it out, "
                  "or raise --max-file-size.\n")
            << input;
    }
    const Finished endless = shell("yes G0 | timeout 8 $maclint --format concise --max-file-size 5M -");
    EXPECT_EQ(endless.status, 2);
    EXPECT_THAT(endless.err, HasSubstr("it is larger than 5 MiB."));
}

TEST_F(Faults, ConfigurationsAndBaselinesThatAreTooLargeAreErrors) {
    static_cast<void>(shell("truncate -s 17M config.json; truncate -s 257M base.json"));
    const Finished configuration = run({"--config", "config.json", "O1001.nc"});
    EXPECT_EQ(configuration.status, 2);
    EXPECT_THAT(configuration.err, HasSubstr("config.json: cannot be read: it is larger than 16 MiB."));
    const Finished baseline = run({"--baseline", "base.json", "O1001.nc"});
    EXPECT_EQ(baseline.status, 2);
    EXPECT_THAT(baseline.err, HasSubstr("base.json: cannot be read: it is larger than 256 MiB."));
}

TEST_F(Faults, AFileThatMayNotGrowLeavesTheOldReportAndNothingElse) {
    write_many();
    folder.write("report.json", "old");
    const auto before = names();
    const Finished file =
        shell("ulimit -f 20; $maclint --format concise --output json:report.json > /dev/null");
    EXPECT_EQ(file.status, 2);
    EXPECT_EQ(file.err,
              "maclint: error: report.json: cannot be written: it would be larger than the system allows. "
              "Raise the limit (ulimit -f), or write it elsewhere.\n");
    EXPECT_EQ(names(), before);
    EXPECT_EQ(read_file(folder.path() / "report.json"), "old");
    const Finished printed = shell("ulimit -f 20; $maclint --format json > printed");
    EXPECT_EQ(printed.status, 2);
    EXPECT_THAT(printed.err,
                StartsWith("maclint: error: standard output: cannot be written: it would be larger"));
}

TEST_F(Faults, AnOldReportOfAnySizeIsReplacedWithoutReadingIt) {
    if (sanitized()) GTEST_SKIP() << "a sanitizer takes more memory than may be given";
    const std::string limited = "truncate -s 3900M old; ulimit -v 1500000; $maclint --quiet --output "
                                "sarif:old > /dev/null; echo $?; ";
    EXPECT_EQ(shell(limited + "test $(wc -c < old) -lt 9000000").status, 0);
    EXPECT_EQ(shell(limited).out, "1\n");
    folder.write("program", with_defect);
    const Finished over =
        shell("truncate -s 3900M program; ulimit -v 1500000; $maclint --output sarif:program");
    EXPECT_EQ(over.status, 2);
}

TEST_F(Faults, WhatIsOpenIsWrittenBehindWhatIsThere) {
    for (const std::string name : {"/dev/stderr", "/dev/fd/2", "/proc/self/fd/2"}) {
        const Finished finished = shell("echo before > log; { $maclint --output json:" + name +
                                        "; echo after >&2; } 2>> log > /dev/null; cat log");
        EXPECT_THAT(finished.out, AllOf(StartsWith("before\n{"), EndsWith("}\nafter\n"))) << name;
    }
    EXPECT_THAT(shell("echo before > log; $maclint --output json:/dev/fd/3 3>> log > /dev/null; cat log").out,
                StartsWith("before\n{"));
    EXPECT_THAT(shell("$maclint --output json:/dev/fd/3 3>&1 > /dev/null | cat").out, StartsWith("{"));
    EXPECT_EQ(shell("$maclint --output json:/dev/fd/77").status, 2);
    EXPECT_EQ(shell("$maclint --output json:/dev/fd/3 3< O1001.nc").status, 2);
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
    const TemporaryFolder beside;
    fs::create_symlink(folder.path() / "report.json", beside.path() / "link");
    expect_refused_beside_a_report((beside.path() / "link").string());
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
    const Finished finished =
        shell("ulimit -v 1500000; $maclint --format concise --max-file-size 4000M --jobs 2");
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

/// Programs that take some memory to analyse, and more of it on several threads.
std::string wide_program(int number) {
    std::string text = "%\nO" + std::to_string(number) + "\n";
    for (int i = 1; i < 400; ++i)
        text += "N" + std::to_string(i) + "#" + std::to_string(i % 900 + 1) + "=#" +
                std::to_string(i * 7 % 900 + 1) + "+" + std::to_string(i) + ".\nIF[#" +
                std::to_string(i % 33 + 1) + "EQ" + std::to_string(i) + "]GOTO" + std::to_string(i + 1) +
                "\n(ON)\n";
    return text + "N400M30\n%\n";
}

/// A program that the parser and the reader of expressions go deep into.
std::string deep_program() {
    constexpr std::size_t depth = 1300;
    std::string sum = "#2";
    for (std::size_t i = 0; i < depth; ++i) sum += "+#2";
    return "%\nO2000\n#1=" + copies_of("[", depth) + "#2" + copies_of("]", depth) +
           "\n#1=" + copies_of("SIN[", depth / 2) + "#2" + copies_of("]", depth / 2) + "\n#1=" + sum +
           "\nGOTO 99\nM30\n%\n";
}

/// Runs under limits, compared with one that has none.
class LimitedRuns : public Faults {
  protected:
    [[nodiscard]] Finished lint(const std::string& limits, const std::string& jobs) const {
        folder.write("report.json", "old");
        return shell(limits +
                     "; $maclint --format concise --no-timestamps --output json:report.json --jobs " + jobs +
                     " .");
    }
    [[nodiscard]] std::string report() const { return read_file(folder.path() / "report.json"); }

    /// Below some memory the system cannot even load the executable.
    [[nodiscard]] bool can_be_loaded(const std::string& limit) const {
        constexpr int not_loaded = 127;
        return shell(limit + "; $maclint --version").status != not_loaded;
    }

    /// The whole report, or errors: then there may be a report that tells of them, or the old one.
    void expect_whole_or_refused(const std::string& limits, const std::string& jobs) {
        const Finished finished = lint(limits, jobs);
        SCOPED_TRACE(limits + " jobs " + jobs + " status " + std::to_string(finished.status) + "\n" +
                     finished.err);
        EXPECT_THAT(names(), ElementsAreArray(names_));
        if (finished.status == whole_.status) {
            EXPECT_EQ(finished.out, whole_.out);
            EXPECT_EQ(finished.err, whole_.err);
            EXPECT_EQ(report(), whole_report_);
            ++whole_runs_;
            return;
        }
        EXPECT_EQ(finished.status, 2);
        for (const std::string& line : lines_of(finished.err))
            EXPECT_THAT(line, StartsWith("maclint: error: "));
        EXPECT_THAT(finished.err, Not(IsEmpty()));
        if (finished.out.empty())
            EXPECT_EQ(report(), "old");
        else
            EXPECT_THAT(report(), AllOf(HasSubstr("cannot be analysed"), EndsWith("}\n")));
    }

    void lint_without_limits() {
        whole_ = lint("true", "8");
        ASSERT_EQ(whole_.status, 1);
        whole_report_ = report();
        names_ = names();
    }

    std::size_t whole_runs_ = 0;

  private:
    Finished whole_;
    std::string whole_report_;
    std::vector<std::string> names_;
};

TEST_F(LimitedRuns, OfMemoryEndWithTheWholeReportOrAnError) {
    if (sanitized()) GTEST_SKIP() << "a sanitizer takes more memory than may be given";
    for (int i = 1; i <= 12; ++i) folder.write("O" + std::to_string(i) + ".nc", wide_program(i));
    lint_without_limits();
    for (const int megabytes : {20, 22, 24, 26, 28, 30, 32, 36, 40, 45, 50, 60, 70, 80, 100, 120, 200, 300}) {
        const std::string limit = "ulimit -v " + std::to_string(megabytes * 1000);
        if (!can_be_loaded(limit)) continue;
        for (const char* jobs : {"1", "8"}) expect_whole_or_refused(limit, jobs);
    }
    EXPECT_GE(whole_runs_, 8U);
}

TEST_F(LimitedRuns, OfTheStackAreWhole) {
    folder.write("O2000.nc", deep_program());
    folder.write("O2001.ncs", "%O2001.ncs\nMACHINING\nN1 #l1=" + copies_of("(", 1500) + "1" +
                                  copies_of(")", 1500) + "\nM30\nEND\n");
    lint_without_limits();
    for (const char* limit : {"ulimit -s 32", "ulimit -s 64", "ulimit -s 128"})
        for (const char* jobs : {"1", "8"}) expect_whole_or_refused(limit, jobs);
    EXPECT_EQ(whole_runs_, 6U);
}

TEST_F(LimitedRuns, OfTheStackWithoutMemoryForAnotherAreRefused) {
    if (sanitized()) GTEST_SKIP() << "a sanitizer takes more memory than may be given";
    lint_without_limits();
    for (const int megabytes : {20, 24, 28, 32, 36, 40, 50}) {
        const std::string limit = "ulimit -s 64; ulimit -v " + std::to_string(megabytes * 1000);
        if (can_be_loaded(limit)) expect_whole_or_refused(limit, "8");
    }
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
