//! On Linux '\' is a letter of names as any other: in searches, patterns, baselines and every report.
#include "tests/support/in_repository.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace maclint::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class Backslash : public InRepository {
  protected:
    [[nodiscard]] std::string report(const std::string& format) const {
        return run({"--no-timestamps", "--format", format, "."}).out;
    }
    void configure(const std::string& text) const { folder.write(".maclint.json", text); }
};

TEST_F(Backslash, BelongsToTheNameInEveryReport) {
    folder.write("mill\\5/a\\b.nc", with_defect);
    EXPECT_THAT(report("text"), HasSubstr("--> mill\\5/a\\b.nc:4:1\n"));
    EXPECT_THAT(report("concise"), StartsWith("mill\\5/a\\b.nc:4:1: error[MAC301]"));
    EXPECT_EQ(nlohmann::json::parse(report("json"))["findings"][0]["file"], "mill\\5/a\\b.nc");
    EXPECT_THAT(report("sarif"), HasSubstr("\"uri\": \"mill%5C5/a%5Cb.nc\""));
    EXPECT_THAT(report("github"), StartsWith("::error file=mill\\5/a\\b.nc,line=4,"));
    EXPECT_EQ(nlohmann::json::parse(report("gitlab"))[0]["location"]["path"], "mill\\5/a\\b.nc");
    EXPECT_THAT(report("junit"), HasSubstr("<testsuite name=\"mill\\5/a\\b.nc\""));
    EXPECT_THAT(report("checkstyle"), HasSubstr("<file name=\"mill\\5/a\\b.nc\">"));
}

TEST_F(Backslash, BelongsToTheNameOfStandardInput) {
    const auto named = [&](const std::string& name, const std::string& format) {
        return run({"--format", format, "--stdin-filename", name, "-"}, std::string(with_defect)).out;
    };
    EXPECT_THAT(named("C:\\nc\\O1.nc", "concise"), StartsWith("C:\\nc\\O1.nc:4:1: error[MAC301]"));
    EXPECT_THAT(named("C:\\nc\\O1.nc", "sarif"), HasSubstr("\"uri\": \"C%3A%5Cnc%5CO1.nc\""));
    EXPECT_THAT(named("\\\\server\\O1.nc", "sarif"), HasSubstr("\"uri\": \"%5C%5Cserver%5CO1.nc\""));
}

TEST_F(Backslash, DoesNotEndAFolder) {
    folder.write("a\\.nc", with_defect);     // ends in .nc, as O1.nc does
    folder.write("part\\O77", "Oil it.\n");  // is not named O77
    folder.write("x\\y.z\\O1", with_defect); // has the extension .z\O1
    EXPECT_THAT(run({"--format", "concise"}).out,
                AllOf(StartsWith("a\\.nc:4:1: error[MAC301]"),
                      HasSubstr("(1 checked, 2 files with other names passed over)")));
}

TEST_F(Backslash, IsRefusedInGlobs) {
    folder.write("a\\b.nc", with_defect);
    folder.write("c\\d/O1.nc", with_defect);
    EXPECT_EQ(run({}).status, 1);
    configure(R"({"exclude": ["a\\b.nc"]})");
    EXPECT_THAT(run({"--format", "concise"}).err,
                HasSubstr("has a backslash, which separates nothing in one. Write \"a/b.nc\""))
        << "most who write it mean a folder";
    configure(R"({"exclude": ["a?b.nc"], "per-file-ignores": {"c?d/*": ["MAC301"]}})");
    EXPECT_EQ(run({"--format", "concise"}).out, "no findings (1 checked)\n");
    configure(R"({"exclude": ["a/b.nc", "c/d"]})");
    EXPECT_THAT(run({"--format", "concise"}).out, HasSubstr("2 errors in 2 files"));
}

TEST_F(Backslash, IsTwoInIgnoreFiles) {
    folder.write("a\\b.nc", with_defect);
    folder.write("c\\d/O1.nc", with_defect);
    folder.write(".gitignore", "a\\b.nc\n");
    EXPECT_THAT(run({"--format", "concise"}).out, HasSubstr("2 errors in 2 files")) << "one is ab.nc";
    folder.write(".gitignore", "a\\\\b.nc\nc[\\\\]d/\n");
    EXPECT_EQ(run({"--format", "concise"}).out, "no findings (0 checked, 1 program ignored by git)\n");
}

TEST_F(Backslash, IsKnownToBaselines) {
    folder.write("a\\b.nc", with_defect);
    folder.write("a/b.nc", with_defect);
    EXPECT_EQ(run({"--write-baseline", "base.json", "a\\b.nc"}).status, 0);
    EXPECT_THAT(read_file(folder.path() / "base.json"), HasSubstr(R"("file":"a\\b.nc")"));
    EXPECT_THAT(run({"--format", "concise", "--baseline", "base.json"}).out,
                AllOf(StartsWith("a/b.nc:4:1"), HasSubstr("1 error in 1 file (2 checked)")));
}

TEST_F(Backslash, AndTheEscapeOfALineFeedAreTwoFilesForAServiceThatDropsOneOfTwo) {
    folder.write("a\\nb.nc", with_defect);
    folder.write("a\nb.nc", with_defect);
    std::set<std::string> fingerprints;
    for (const auto& issue : nlohmann::json::parse(report("gitlab")))
        fingerprints.insert(issue["fingerprint"]);
    EXPECT_EQ(fingerprints.size(), 2U);
}

TEST_F(InRepository, ANameThatBeginsWithPointsIsBelowTheRepository) {
    folder.write("..old/O1.nc", with_defect);
    EXPECT_THAT(run({"--format", "sarif", "..old/O1.nc"}).out, HasSubstr("\"uri\": \"..old/O1.nc\""));
}

} // namespace
} // namespace maclint::test
