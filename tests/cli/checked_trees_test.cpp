//! Nothing in a checked folder says where maclint writes.
#include "tests/support/in_repository.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr std::string_view empty_baseline = R"({"maclint-baseline": 1, "findings": []})";

/// "repository" is what a stranger sent, the folder around it is the user's.
class CheckedFolder : public InRepository {
  protected:
    void SetUp() override {
        folder.write("repository/.git/HEAD", "ref: refs/heads/main\n");
        folder.write("repository/sub/O1001.nc", with_defect);
        folder.write("mine/precious.txt", "mine");
        folder.write("mine/base.json", empty_baseline);
        fs::create_directory_symlink("../mine", folder.path() / "repository/out");
        fs::create_symlink("../mine/precious.txt", folder.path() / "repository/report.json");
        fs::create_symlink("../mine/new.txt", folder.path() / "repository/dangling.json");
        fs::create_symlink("sub/inner.json", folder.path() / "repository/inside.json");
        fs::create_symlink("../mine/base.json", folder.path() / "repository/base.json");
    }
    [[nodiscard]] Finished run_in(const std::string& in, const std::vector<std::string>& arguments) const {
        return run_maclint((folder.path() / in).string(), arguments, "");
    }
    void expect_refused(const Finished& finished, const std::string& message) const {
        EXPECT_EQ(finished.status, 2) << message;
        EXPECT_THAT(finished.out, IsEmpty()) << message;
        EXPECT_THAT(finished.err, AllOf(StartsWith("maclint: error: --"), HasSubstr(message)));
        EXPECT_EQ(read_file(folder.path() / "mine/precious.txt"), "mine") << message;
        EXPECT_EQ(read_file(folder.path() / "mine/base.json"), empty_baseline) << message;
        EXPECT_FALSE(fs::exists(folder.path() / "mine/new.txt")) << message;
        EXPECT_FALSE(fs::exists(folder.path() / "repository/sub/inner.json")) << message;
    }
    [[nodiscard]] std::string at(const std::string& name) const { return (folder.path() / name).string(); }
};

TEST_F(CheckedFolder, LeadsNoReportThroughItsLinks) {
    for (const auto& [path, link] : {std::pair<std::string, std::string>{"report.json", "report.json"},
                                     {"out/new.txt", "out"},
                                     {"out/../mine/new.txt", "out"},
                                     {"sub/../report.json", "report.json"},
                                     {"dangling.json", "dangling.json"},
                                     {"inside.json", "inside.json"}}) {
        const std::string message =
            " through '" + link + "', a link in the folder that is checked. Name another file for the ";
        expect_refused(run_in("repository", {"--output", "json:" + path}),
                       "--output would write a report" + message + "report.");
        expect_refused(run_in("repository", {"--write-baseline", path}),
                       "--write-baseline would write a baseline" + message + "baseline.");
        expect_refused(run_in("repository", {"--output", "json:" + at("repository/" + path)}), message);
    }
}

TEST_F(CheckedFolder, IsTheRepositoryAroundWhatIsNamed) {
    for (const std::vector<std::string>& paths :
         {std::vector<std::string>{"sub"}, {"sub/O1001.nc"}, {"sub/gone.nc"}}) {
        std::vector<std::string> arguments = paths;
        arguments.insert(arguments.end(), {"--output", "json:report.json"});
        expect_refused(run_in("repository", arguments), "through 'report.json'");
    }
    expect_refused(
        run_maclint(at("repository"), {"-", "--output", "json:out/new.txt"}, std::string(with_defect)),
        "through 'out'");
    expect_refused(run_in("", {"repository", "mine", "--output", "json:repository/out/new.txt"}),
                   "through 'repository/out'");
}

TEST_F(CheckedFolder, WithoutARepositoryIsTheFolderThatIsNamed) {
    fs::remove_all(folder.path() / "repository/.git");
    expect_refused(run_in("repository", {"--output", "json:report.json"}), "through 'report.json'");
    expect_refused(run_in("", {"repository", "--output", "json:repository/report.json"}),
                   "through 'repository/report.json'");
    fs::create_symlink("../../mine/precious.txt", folder.path() / "repository/sub/link");
    expect_refused(run_in("repository", {"sub/O1001.nc", "--output", "json:sub/link"}), "through 'sub/link'");
}

TEST_F(CheckedFolder, NamedThroughALinkIsWhereItLeads) {
    fs::create_directory_symlink("repository", folder.path() / "link");
    expect_refused(run_in("", {"link", "--output", "json:link/report.json"}), "through 'link/report.json'");
    expect_refused(run_in("", {"link", "--output", "json:repository/report.json"}),
                   "through 'repository/report.json'");
    expect_refused(run_in("", {"repository", "--output", "json:link/report.json"}),
                   "through 'link/report.json'");
}

TEST_F(CheckedFolder, LeadsNoPruningThroughItsLinks) {
    expect_refused(run_in("repository", {"--baseline", "base.json", "--prune-baseline"}),
                   "--prune-baseline would write a baseline through 'base.json'");
    fs::remove(folder.path() / "repository/base.json");
    folder.write("repository/sub/known.json", empty_baseline);
    fs::create_symlink("sub/known.json", folder.path() / "repository/base.json");
    folder.write("repository/.maclint.json", R"({"baseline": "base.json"})");
    expect_refused(run_in("repository", {"--prune-baseline"}),
                   "--prune-baseline would write a baseline through 'base.json'");
    EXPECT_EQ(run_in("repository", {"--quiet"}).status, 1); // it may be read
}

TEST_F(CheckedFolder, KeepsWhatIsGitsOwn) {
    for (const char* path : {".git/config", ".git/HEAD", ".git/hooks/post-checkout", "sub/../.git/x",
                             ".GIT/config", "sub/.git"}) {
        expect_refused(run_in("repository", {"--output", std::string("json:") + path}),
                       "which is git's own. Name");
        expect_refused(run_in("repository", {"--write-baseline", path}), "which is git's own. Name");
    }
    EXPECT_EQ(read_file(folder.path() / "repository/.git/HEAD"), "ref: refs/heads/main\n");
}

TEST_F(CheckedFolder, GetsNoReportInPlaceOfAConfiguration) {
    const std::string other = folder.write("mine/other.json", "{}");
    for (const bool is_there : {false, true}) {
        if (is_there) folder.write("repository/.maclint.json", R"({"ignore": ["MAC301"]})");
        for (const std::vector<std::string>& words :
             {std::vector<std::string>{"--isolated", "--output", "json:.maclint.json"},
              std::vector<std::string>{"--config", other, "--output", "json:sub/../.maclint.json"},
              std::vector<std::string>{"--isolated", "--write-baseline", "sub/.maclint.json"}})
            expect_refused(run_in("repository", words), "which is named like a configuration. Name another");
    }
    EXPECT_EQ(read_file(folder.path() / "repository/.maclint.json"), R"({"ignore": ["MAC301"]})");
    EXPECT_FALSE(fs::exists(folder.path() / "repository/sub/.maclint.json"));
    fs::create_symlink("repository/.maclint.json", folder.path() / "to_it.json");
    expect_refused(run_in("repository", {"--isolated", "--output", "json:../to_it.json"}),
                   "like a configuration");
}

TEST_F(CheckedFolder, LeavesTheUsersOwnLinksAlone) {
    fs::create_symlink("mine/precious.txt", folder.path() / "mine.txt");
    EXPECT_EQ(run_in("repository", {"--output", "json:../mine.txt"}).status, 1);
    EXPECT_TRUE(fs::is_symlink(folder.path() / "mine.txt"));
    EXPECT_THAT(read_file(folder.path() / "mine/precious.txt"), StartsWith("{"));
    fs::create_directory_symlink("repository", folder.path() / "link");
    EXPECT_EQ(run_in("", {"repository", "--output", "json:link/sub/report.json"}).status, 1);
    EXPECT_TRUE(fs::is_regular_file(folder.path() / "repository/sub/report.json"));
}

} // namespace
} // namespace maclint::test
