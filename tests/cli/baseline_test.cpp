//! --baseline, --write-baseline and --prune-baseline of the built executable.
#include "tests/support/in_repository.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr std::string_view bad = "%\nO1001\nN10 G0 X1.\nN20 GOTO 99\nN30 M30\n%\n"; // MAC301 on line 4
// The same, moved, numbered and spaced otherwise, with other line ends.
constexpr std::string_view bad_moved =
    "%\r\nO1001\r\n(NEW)\r\nN100 G0X1.\r\nN200  goto 99\r\nN300 M30\r\n%\r\n";
constexpr std::string_view worse = "%\nO1001\nN1 G0 X1.\nGOTO 99\nG1 X1. F9. F8.\nM30\n%\n";
constexpr std::string_view good = "%\nO1001\nG0 X1.\nM30\n%\n";

class BaselineOption : public InRepository {
  protected:
    void SetUp() override {
        InRepository::SetUp();
        folder.write("O1001.nc", bad);
    }

    [[nodiscard]] Finished run(const std::vector<std::string>& arguments, const std::string& in = "") const {
        return run_maclint((folder.path() / in).string(), arguments, "");
    }
    /// What is found, a line each, and the status.
    [[nodiscard]] std::string found(std::vector<std::string> arguments, const std::string& in = "") const {
        arguments.insert(arguments.begin(), {"--format", "concise", "--quiet", "--select", "MAC301,MAC559"});
        const Finished finished = run(arguments, in);
        return finished.err + finished.out + std::to_string(finished.status);
    }
    void write_baseline() const {
        ASSERT_EQ(run({"--write-baseline", "base.json"}).status, 0);
        ASSERT_EQ(run({"--baseline", "base.json"}).status, 0);
    }
    [[nodiscard]] std::string baseline() const { return read_file(folder.path() / "base.json"); }
};

TEST_F(BaselineOption, WhatIsWrittenIsKnownFromThenOn) {
    const Finished written = run({"--write-baseline", "base.json"});
    EXPECT_EQ(written.status, 0);
    EXPECT_EQ(written.err, "maclint: note: base.json: 1 finding is known from now on.\n");
    EXPECT_EQ(written.out, "no new findings (1 checked)\n1 known finding of base.json not shown\n");
    const Finished known = run({"--baseline", "base.json"});
    EXPECT_EQ(known.status, 0);
    EXPECT_EQ(known.err, "");
    EXPECT_EQ(known.out, written.out);
    EXPECT_EQ(run({"--baseline", "base.json", "--format", "concise"}).out, written.out);
    EXPECT_EQ(found({"--baseline", "base.json"}), "0");
    EXPECT_THAT(baseline(),
                AllOf(StartsWith("{\n  \"maclint-baseline\": 1,\n  \"findings\": [\n    {\"file\":"
                                 "\"O1001.nc\",\"rule\":\"MAC301\",\"fingerprint\":\""),
                      testing::EndsWith("\",\"block\":\"GOTO99\"}\n  ]\n}\n")));
}

TEST_F(BaselineOption, IsAsItsPageShowsIt) {
    const std::string page = read_file("docs/baseline.md");
    std::vector<std::string> blocks;
    for (auto begin = page.find("```\n"); begin != std::string::npos; begin = page.find("```\n", begin + 4)) {
        const auto end = page.find("```\n", begin + 4);
        blocks.push_back(page.substr(begin + 4, end - begin - 4));
        begin = end;
    }
    ASSERT_GE(blocks.size(), 2U);
    folder.write("O9100.nc", blocks[0]);
    EXPECT_EQ(run({"--write-baseline", "base.json", "O9100.nc"}).status, 0);
    EXPECT_EQ(baseline(), blocks[1]);
}

TEST_F(BaselineOption, KnowsFindingsAgainThatMovedOrWereNumberedOtherwise) {
    write_baseline();
    folder.write("O1001.nc", bad_moved);
    EXPECT_EQ(found({"--baseline", "base.json"}), "0");
    const std::string before = baseline();
    EXPECT_EQ(run({"--write-baseline", "base.json"}).status, 0);
    EXPECT_EQ(baseline(), before) << "nothing that matters has changed";
}

TEST_F(BaselineOption, ShowsAndFailsOnWhatIsNew) {
    write_baseline();
    folder.write("O1001.nc", worse);
    EXPECT_THAT(found({"--baseline", "base.json"}), AllOf(StartsWith("O1001.nc:5:12: warning[MAC559]"),
                                                          Not(HasSubstr(":4:")), testing::EndsWith("\n1")));
}

TEST_F(BaselineOption, AKnownCauseWithAFurtherPlaceIsNew) {
    write_baseline();
    folder.write("O1001.nc", "%\nO1001\nN1 G0 X1.\nGOTO 99\nGOTO 99\nM30\n%\n");
    const std::string both = found({"--baseline", "base.json"});
    EXPECT_THAT(both, AllOf(StartsWith("O1001.nc:4:1: error[MAC301]"), HasSubstr("1 more place: line 5")));
    EXPECT_EQ(run({"--baseline", "base.json"}).err, "");
}

TEST_F(BaselineOption, KnowsFindingsWhateverTheirSeverity) {
    write_baseline();
    EXPECT_EQ(found({"--baseline", "base.json", "--severity", "MAC301=note", "--fail-on", "note"}), "0");
    folder.write(".maclint.json", R"({"severity": {"MAC301": "note"}})");
    EXPECT_EQ(run({"--write-baseline", "base.json"}).status, 0);
    EXPECT_EQ(found({"--isolated", "--baseline", "base.json"}), "0") << "notes are known, too";
}

TEST_F(BaselineOption, IsTheSameFromEveryFolder) {
    folder.write("mill/bores/O2.nc", bad);
    fs::create_directories(folder.path() / "other");
    EXPECT_EQ(run({"--write-baseline", "../base.json", ".."}, "other").status, 0);
    EXPECT_THAT(baseline(), HasSubstr("\"file\":\"mill/bores/O2.nc\""));
    EXPECT_EQ(found({"--baseline", "../../base.json", "O2.nc", "../../O1001.nc"}, "mill/bores"), "0");
    const std::string absolute = (folder.path() / "base.json").string();
    EXPECT_EQ(found({"--baseline", absolute, "../mill/bores/O2.nc"}, "other"), "0");
}

TEST_F(BaselineOption, KnowsAFileThroughALinkToItsFolder) {
    folder.write("mill/O2.nc", bad);
    write_baseline();
    fs::create_directory_symlink("mill", folder.path() / "link");
    EXPECT_THAT(baseline(), HasSubstr("\"file\":\"mill/O2.nc\""));
    EXPECT_EQ(found({"--baseline", "base.json", "link/O2.nc"}), "0");
}

TEST_F(BaselineOption, KnowsAFileByTheNameThatItHasNotByTheCaseThatWasTyped) {
    write_baseline();
    folder.write("links/x", "");
    fs::create_symlink("O1001.nc", folder.path() / "o1001.NC"); // as if this system did not mind case
    fs::create_symlink("../O1001.nc", folder.path() / "links/O1001.nc");
    EXPECT_EQ(found({"--baseline", "base.json", "o1001.NC"}), "0");
    EXPECT_THAT(found({"--baseline", "base.json", "links/O1001.nc"}), StartsWith("links/O1001.nc:4:5: "));
}

TEST_F(BaselineOption, TheConfigurationNamesItFromItsOwnFolder) {
    folder.write("shop/mill/O2.nc", bad);
    folder.write("shop/.maclint.json", R"({"baseline": "known/base.json"})");
    folder.write("shop/known/.keep", "");
    EXPECT_THAT(run({}, "shop/mill"),
                AllOf(testing::Field(&Finished::status, 2),
                      testing::Field(&Finished::err, AllOf(StartsWith("maclint: error: ../known/base.json: "
                                                                      "there is no such baseline."),
                                                           HasSubstr("--write-baseline")))));
    EXPECT_EQ(run({"--write-baseline", "../known/base.json"}, "shop/mill").status, 0);
    EXPECT_EQ(found({"."}, "shop/mill"), "0");
    EXPECT_EQ(found({"shop"}), "0");
    EXPECT_THAT(found({"--no-baseline", "shop"}), HasSubstr("MAC301"));
    EXPECT_THAT(found({"shop", "O1001.nc"}), AllOf(StartsWith("O1001.nc:4"), Not(HasSubstr("O2"))));
    EXPECT_THAT(run({"--show-config", "shop"}).out,
                HasSubstr("baseline       shop/known/base.json (shop/.maclint.json: baseline)\n"));
    folder.write("shop/known/base.json", R"({"maclint-baseline": 1, "findings": []})");
    EXPECT_THAT(found({"shop"}), HasSubstr("O2.nc:4"));
}

TEST_F(BaselineOption, SaysWhatIsKnownInEveryReport) {
    write_baseline();
    folder.write("O1001.nc", worse);
    const Finished finished =
        run({"--baseline", "base.json", "--format", "json", "--output", "sarif:r.sarif"});
    const json report = json::parse(finished.out);
    ASSERT_EQ(report["findings"].size(), 1U);
    ASSERT_EQ(report["known"].size(), 1U);
    EXPECT_EQ(report["known"][0]["baseline"], "base.json");
    EXPECT_EQ(report["known"][0]["range"]["start"]["line"], 4);
    EXPECT_EQ(report["summary"]["known"], 1);
    EXPECT_EQ(report["summary"]["errors"], 0);
    EXPECT_EQ(report["summary"]["suppressed"], 0);
    const json results = json::parse(read_file(folder.path() / "r.sarif"))["runs"][0]["results"];
    ASSERT_EQ(results.size(), 2U);
    EXPECT_EQ(results[0]["baselineState"], "unchanged");
    EXPECT_EQ(results[0]["suppressions"][0]["kind"], "external");
    EXPECT_EQ(results[0]["suppressions"][0]["status"], "accepted");
    EXPECT_EQ(results[1]["baselineState"], "new");
    EXPECT_THAT(results[1]["suppressions"], IsEmpty());
    EXPECT_THAT(run({"--format", "sarif"}).out, Not(HasSubstr("baselineState")));
}

TEST_F(BaselineOption, TellsWhatIsGoneAndPrunesIt) {
    folder.write("O2.nc", bad);
    folder.write("O3.nc", bad);
    write_baseline();
    const std::string before = baseline();
    folder.write("O1001.nc", good);
    fs::remove(folder.path() / "O3.nc");
    const Finished gone = run({"--baseline", "base.json", "O1001.nc"});
    EXPECT_EQ(gone.status, 0);
    EXPECT_EQ(gone.err,
              "maclint: note: base.json: 1 entry is gone from the files checked. --prune-baseline takes "
              "it out.\n");
    EXPECT_EQ(run({"--baseline", "base.json", "O2.nc"}).err, "") << "O1001.nc was not looked at";
    EXPECT_EQ(run({"--baseline", "base.json", "--fail-on-gone", "O1001.nc"}).status, 1);
    EXPECT_EQ(run({"--baseline", "base.json", "--fail-on-gone", "--fail-on", "never", "O1001.nc"}).status, 1);
    EXPECT_EQ(run({"--baseline", "base.json", "--fail-on-gone", "--select", "MAC301", "O2.nc"}).status, 0);
    EXPECT_THAT(run({"--fail-on-gone", "O2.nc"}).err, HasSubstr("--fail-on-gone finds no baseline"));
    EXPECT_EQ(run({"--baseline", "base.json", "--fail-on-gone", "--prune-baseline"}).status, 2);
    EXPECT_EQ(run({"--baseline", "base.json", "--ignore", "MAC301", "O1001.nc"}).err, "");
    EXPECT_EQ(baseline(), before);
    const Finished pruned = run({"--baseline", "base.json", "--prune-baseline", "O1001.nc"});
    EXPECT_EQ(pruned.status, 0);
    EXPECT_EQ(pruned.err, "maclint: note: base.json: 2 entries removed, 1 left.\n");
    EXPECT_THAT(baseline(), AllOf(HasSubstr("O2.nc"), Not(HasSubstr("O3.nc")), Not(HasSubstr("O1001.nc"))));
    EXPECT_THAT(run({"--baseline", "base.json", "--prune-baseline"}).err,
                HasSubstr("nothing is to be pruned"));
}

TEST_F(BaselineOption, FollowsAFileThatWasRenamedAndSaysSo) {
    write_baseline();
    fs::create_directories(folder.path() / "new");
    fs::rename(folder.path() / "O1001.nc", folder.path() / "new/O7.nc");
    const Finished renamed = run({"--baseline", "base.json"});
    EXPECT_EQ(renamed.status, 0);
    EXPECT_EQ(renamed.err,
              "maclint: note: base.json: 'O1001.nc' is gone and 'new/O7.nc' has its findings: taken for "
              "renamed. --prune-baseline writes the new name.\n");
    EXPECT_EQ(run({"--baseline", "base.json", "--prune-baseline"}).status, 0);
    EXPECT_THAT(baseline(), HasSubstr("\"new/O7.nc\""));
    EXPECT_EQ(run({"--baseline", "base.json"}).err, "");
}

TEST_F(BaselineOption, WritingForAPartKeepsTheRest) {
    std::string other(bad);
    folder.write("O2.nc", other.replace(other.find("O1001"), 5, "O2"));
    write_baseline();
    folder.write("O1001.nc", worse);
    const Finished part = run({"--write-baseline", "base.json", "O1001.nc"});
    EXPECT_EQ(part.err,
              "maclint: note: base.json: 2 findings are known from now on. 1 entry of other files or "
              "rules is kept.\n");
    EXPECT_EQ(found({"--baseline", "base.json"}), "0");
    fs::remove(folder.path() / "O2.nc");
    EXPECT_EQ(run({"--write-baseline", "base.json"}).status, 0);
    EXPECT_THAT(baseline(), Not(HasSubstr("O2.nc")));
}

TEST_F(BaselineOption, WhatACommentAllowsIsNoBusinessOfIt) {
    folder.write("O1001.nc", "%\nO1001\nGOTO 99 (MACLINT ALLOW MAC301 - WANTED)\nM30\n%\n");
    EXPECT_THAT(run({"--write-baseline", "base.json"}).err, HasSubstr("0 findings are known"));
    EXPECT_THAT(baseline(), testing::EndsWith("\"findings\": []\n}\n"));
}

TEST_F(BaselineOption, TakesNamesOfAllKinds) {
    for (const char* name : {"W\xC3\xBCrfel Gr\xC3\xB6\xC3\x9F\x65.nc", "it's \"5%\".nc", "two\nlines.nc",
                             "w\xFCrfel.nc", "100%25.nc"})
        folder.write(name, bad);
    write_baseline();
    EXPECT_EQ(found({"--baseline", "base.json"}), "0");
    EXPECT_THAT(baseline(), AllOf(HasSubstr("\"W\xC3\xBCrfel Gr\xC3\xB6\xC3\x9F"
                                            "e.nc\""),
                                  HasSubstr(R"("it's \"5%25\".nc")"), HasSubstr(R"("two\nlines.nc")"),
                                  HasSubstr("\"w%FCrfel.nc\""), HasSubstr("\"100%2525.nc\"")));
    const std::string before = baseline();
    EXPECT_EQ(run({"--baseline", "base.json", "--prune-baseline", "O1001.nc"}).status, 0);
    EXPECT_EQ(baseline(), before) << "all of them are there";
}

struct Wrong {
    const char* text;
    const char* message;
};

TEST_F(BaselineOption, RefusesWhatIsNoBaseline) {
    for (const auto& [text, message] : std::initializer_list<Wrong>{
             {"", "line 1, column 1: "},
             {"{\n<<<<<<< HEAD\n", "line 2, column 1: this is no JSON"},
             {"[]", "this is no baseline of maclint"},
             {R"({"version": "2.1.0", "runs": []})", "this is a SARIF report"},
             {R"({"version": 1, "tool": {}, "findings": []})", "this is a JSON report"},
             {R"({"select": []})", "this is JSON, but no baseline of maclint"},
             {R"({"maclint-baseline": 2, "findings": 1})", "a newer maclint wrote this baseline (version 2"},
             {R"({"maclint-baseline": "1"})", "'maclint-baseline' must be a whole number"},
             {R"({"maclint-baseline": 1})", "it has no list 'findings'"},
             {R"({"maclint-baseline": 1, "findings": [1]})", ": an entry of 'findings' must be an object"},
             {R"({"maclint-baseline": 1, "findings": [{"file": "a", "rule": 1}]})", "needs 'rule', a text"},
             {R"({"maclint-baseline": 1, "findings": [{"file": "a", "rule": "b", "fingerprint": "c",
                  "count": 0}]})",
              "'count' must be a whole number from 1 on"}}) {
        folder.write("base.json", text);
        const Finished finished = run({"--baseline", "base.json"});
        EXPECT_EQ(finished.status, 2) << text;
        EXPECT_THAT(finished.out, IsEmpty()) << text;
        EXPECT_THAT(finished.err, AllOf(StartsWith("maclint: error: base.json: "), HasSubstr(message),
                                        HasSubstr("--write-baseline")))
            << text;
    }
    EXPECT_THAT(run({"--baseline", "gone.json"}).err, HasSubstr("gone.json: there is no such baseline."));
    EXPECT_EQ(run({"--baseline", "."}).status, 2);
}

TEST_F(BaselineOption, ReadsEntriesInAnyOrderAndMoreThanOnce) {
    folder.write("O1001.nc", "%\nO1001\nGOTO 99\nGOTO 99\nM30\n%\n");
    write_baseline();
    json text = json::parse(baseline());
    json entry = text["findings"][0];
    EXPECT_EQ(entry["count"], 2);
    entry.erase("count");
    text["findings"] = {entry, entry};
    text["further"] = 1;
    folder.write("base.json", text.dump());
    EXPECT_EQ(found({"--baseline", "base.json"}), "0");
    EXPECT_THAT(run({"--baseline", "base.json", "--prune-baseline"}).err,
                HasSubstr("nothing is to be pruned"));
    json gone = entry;
    gone["fingerprint"] = "0";
    text["findings"] = {entry, gone, entry};
    folder.write("base.json", text.dump());
    EXPECT_THAT(run({"--baseline", "base.json", "--prune-baseline"}).err,
                HasSubstr("1 entry removed, 2 left."));
    entry["count"] = 2;
    EXPECT_EQ(json::parse(baseline())["findings"], json::array({entry}));
}

TEST_F(BaselineOption, WritesOverNothingElse) {
    folder.write("report.json", "{}");
    folder.write("other.json", R"({"maclint-baseline": 7, "findings": []})");
    folder.write(".maclint.json", "{}");
    const auto refused = [&](const std::vector<std::string>& arguments, const char* message) {
        const Finished finished = run(arguments);
        EXPECT_EQ(finished.status, 2) << message;
        EXPECT_THAT(finished.out, IsEmpty()) << message;
        EXPECT_THAT(finished.err, HasSubstr(message));
    };
    refused({"--write-baseline", "report.json"},
            "report.json: --write-baseline does not write over this file");
    refused({"--write-baseline", "other.json"}, "a newer maclint wrote this baseline");
    refused({"--write-baseline", "O1001.nc"}, "--write-baseline would write a baseline over 'O1001.nc'");
    refused({"--write-baseline", ".maclint.json"}, "which is a configuration");
    refused({"--write-baseline", "new.nc"}, "which is named like an NC program");
    refused({"--write-baseline", "-"}, "--write-baseline wants the name of a file");
    refused({"--write-baseline", ""}, "--write-baseline has an empty value");
    refused({"--write-baseline", "a.json", "--output", "json:./a.json"},
            "--output and --write-baseline name one file, as './a.json' and as 'a.json'");
    refused({"--write-baseline", "a.json", "--baseline", "a.json"},
            "--baseline and --write-baseline exclude each other");
    refused({"--write-baseline", "a.json", "--prune-baseline"}, "exclude each other");
    refused({"--write-baseline", "a.json", "--since", "HEAD"}, "exclude each other");
    refused({"--baseline", "a.json", "--no-baseline"}, "exclude each other");
    refused({"--prune-baseline"}, "finds no baseline to prune");
    EXPECT_EQ(read_file(folder.path() / "report.json"), "{}");
    write_baseline();
    const std::string before = baseline();
    refused({"--output", "json:base.json"}, "over 'base.json', which is a baseline");
    EXPECT_EQ(baseline(), before);
    EXPECT_FALSE(fs::exists(folder.path() / "a.json"));
}

TEST_F(BaselineOption, WrittenByManyRunsAtOnceHasThePartOfEach) {
    for (int i = 1; i <= 20; ++i) folder.write("part/O" + std::to_string(i) + ".nc", bad);
    const Finished finished =
        shell("for i in $(seq 20); do $maclint --quiet --write-baseline base.json part/O$i.nc "
              "> /dev/null & done; wait");
    EXPECT_THAT(finished.err, IsEmpty());
    EXPECT_EQ(json::parse(baseline())["findings"].size(), 20U);
    EXPECT_FALSE(fs::exists(folder.path() / "base.json.lock"));
    for (int i = 1; i <= 20; ++i) folder.write("part/O" + std::to_string(i) + ".nc", good);
    EXPECT_THAT(
        shell("for i in $(seq 20); do $maclint --quiet --baseline base.json --prune-baseline part/O$i.nc "
              "> /dev/null & done; wait")
            .err,
        IsEmpty());
    EXPECT_TRUE(json::parse(baseline())["findings"].empty());
}

TEST_F(BaselineOption, IsWrittenAloneWhateverAnotherRunLeftBehind) {
    folder.write("base.json.lock", ""); // of a run that was killed: nobody holds it
    EXPECT_EQ(run({"--write-baseline", "base.json"}).status, 0);
    EXPECT_FALSE(fs::exists(folder.path() / "base.json.lock"));
    for (const bool is_link : {false, true}) {
        const std::string mine = folder.write("mine", "mine");
        const fs::path lock = folder.path() / "base.json.lock";
        fs::remove(lock);
        if (is_link)
            fs::create_symlink(mine, lock);
        else
            fs::copy_file(mine, lock);
        const std::string before = baseline();
        const Finished finished = run({"--write-baseline", "base.json"});
        EXPECT_EQ(finished.status, 2);
        EXPECT_THAT(finished.err,
                    HasSubstr("base.json: cannot be written: 'base.json.lock' beside it is no lock"));
        EXPECT_EQ(baseline(), before);
        EXPECT_EQ(read_file(mine), "mine");
        EXPECT_TRUE(fs::exists(lock));
    }
}

TEST_F(BaselineOption, AFullDiskIsAnErrorAndAllIsShown) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
    const Finished finished = run({"--write-baseline", "/dev/full", "--format", "concise"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, HasSubstr("/dev/full: cannot be written"));
    EXPECT_THAT(finished.out, HasSubstr("O1001.nc:4:5: error[MAC301]"));
}

} // namespace
} // namespace maclint::test
