//! A search of folders stays in them: where links lead, what is said of those that lead out, and ignore
//! files.
#include "tests/support/in_repository.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// A folder with a program without defects, and another one that holds a defect.
class Links : public InRepository {
  protected:
    void SetUp() override {
        InRepository::SetUp();
        folder.write("shop/O1000.nc", without_defect);
        folder.write("out/O1001.nc", with_defect);
    }
    void link(const std::string& name, const fs::path& target) const {
        fs::create_symlink(target, folder.path() / name);
    }
    [[nodiscard]] Finished check(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"--format", "concise"});
        return run(arguments);
    }
};

constexpr std::string_view one_is_left_out = "maclint: note: shop: 1 link in this folder leads out of it and "
                                             "is not followed. Say --follow-links to have "
                                             "checked what is there.\n";

TEST_F(Links, OutOfTheFolderAreNotFollowedButCountedAndNoted) {
    link("shop/folder", "../out");
    link("shop/O2.nc", "../out/O1001.nc");
    link("shop/absolute", folder.path() / "out");
    link("shop/gone.nc", "/nowhere/gone.nc");
    link("shop/readme.md", "../out/readme.md"); // as a file of that name
    link("shop/.hidden", "../out");
    link("shop/build", "../out");
    const Finished finished = check({"shop"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.out, "no findings (1 checked, 4 links to elsewhere not followed)\n");
    EXPECT_EQ(finished.err,
              "maclint: note: shop: 4 links in this folder lead out of it and are not followed. Say "
              "--follow-links to have checked what is there.\n");
    EXPECT_EQ(
        nlohmann::json::parse(run({"--format", "json", "shop"}).out)["summary"]["passed_over"]["links_out"],
        4);
}

TEST_F(Links, OutOfTheFolderAreFollowedWhenThatIsAskedFor) {
    link("shop/folder", "../out");
    const Finished finished = check({"--follow-links", "shop"});
    EXPECT_EQ(finished.status, 1);
    EXPECT_THAT(finished.out,
                AllOf(StartsWith("shop/folder/O1001.nc:4:1: error[MAC301]"), HasSubstr("(2 checked)")));
    EXPECT_THAT(finished.err, IsEmpty());
}

TEST_F(Links, OutByALinkInsideLeadOut) {
    link("shop/first", "second/O1001.nc");
    link("shop/second", "../out");
    link("shop/O3.nc", "first");
    const Finished finished = check({"shop"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_THAT(finished.out, HasSubstr("(1 checked, 3 links to elsewhere not followed)"));
}

TEST_F(Links, InsideTheFolderAreFollowedWhateverWayTheyTake) {
    folder.write("shop/.store/data", with_defect); // found by links only
    link("shop/O2.nc", ".store/data");
    EXPECT_THAT(check({"shop"}).out, StartsWith("shop/O2.nc:4:1: error[MAC301]"));
    for (const fs::path& target : {fs::path("../shop/.store"), folder.path() / "shop/.store"}) {
        fs::remove(folder.path() / "shop/O2.nc");
        fs::remove(folder.path() / "shop/way");
        link("shop/way", target);
        link("shop/O2.nc", "way/data");
        const Finished finished = check({"shop"});
        EXPECT_THAT(finished.out,
                    AllOf(StartsWith("shop/O2.nc:4:1: error[MAC301]"), HasSubstr("(2 checked)")))
            << target;
        EXPECT_THAT(finished.err, IsEmpty()) << target;
    }
}

TEST_F(Links, ToNothingInsideTheFolderAreErrors) {
    link("shop/O2.nc", "gone.nc");
    const Finished finished = check({"shop"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err,
                StartsWith("maclint: error: shop/O2.nc: cannot be read: there is no such file."));
}

TEST_F(Links, WithNamesThatBeginLikeTheFolderLeadOut) {
    folder.write("shop2/O1001.nc", with_defect);
    link("shop/more", "../shop2");
    EXPECT_EQ(check({"shop"}).err, one_is_left_out);
}

TEST_F(Links, ThatAreNamedAreFollowed) {
    link("entry", "out");
    link("O5.nc", "out/O1001.nc");
    EXPECT_THAT(check({"entry"}).out, StartsWith("entry/O1001.nc:4:1: error[MAC301]"));
    EXPECT_THAT(check({"O5.nc"}).out, StartsWith("O5.nc:4:1: error[MAC301]"));
    link("out/O6.nc", "O1001.nc");
    EXPECT_THAT(check({"entry"}).err, IsEmpty()) << "it leads to what was named";
}

TEST_F(Links, FromOneNamedFolderIntoAnotherAreInside) {
    link("shop/O2.nc", "../out/O1001.nc");
    for (const auto& paths : {std::vector<std::string>{"shop", "out"},
                              {"out", "shop"},
                              {"shop", "."},
                              {"shop", "out/O1001.nc"}}) {
        const Finished finished = check(paths);
        EXPECT_THAT(finished.out, AllOf(HasSubstr("1 error in 1 file"), HasSubstr("(2 checked)")));
        EXPECT_THAT(finished.err, IsEmpty());
    }
}

TEST_F(Links, AFolderInsideAnotherOneIsSearchedOnceAndNotToldOf) {
    folder.write("shop/sub/O1001.nc", with_defect);
    for (const auto& paths : {std::vector<std::string>{"shop", "shop/sub"}, {"shop/sub", "shop"}}) {
        const Finished finished = check(paths);
        EXPECT_THAT(finished.out, HasSubstr("1 error in 1 file (2 checked)"));
        EXPECT_THAT(finished.err, IsEmpty());
    }
}

TEST_F(Links, AreOneNoteAFolder) {
    folder.write("other/O1002.nc", without_defect);
    link("shop/a", "../out");
    link("other/a", "../out");
    EXPECT_THAT(check({"shop", "other"}).err,
                AllOf(HasSubstr("note: other: 1 link"), HasSubstr("note: shop: 1 link")));
}

TEST_F(Links, OutOfTheFolderOfOneControlLeadToNoCallees) {
    folder.write("shop/.maclint.json", R"({"complete": true})");
    folder.write("shop/O1.nc", "%\nO1\nM98P9\nM30\n%\n");
    folder.write("out/O9.nc", "%\nO9\nM99\n%\n");
    link("shop/lib", "../out");
    EXPECT_THAT(check({"shop/O1.nc"}).out, StartsWith("shop/O1.nc:3:1: error[MAC402]"));
    EXPECT_EQ(check({"--follow-links", "shop/O1.nc"}).status, 0);
}

TEST_F(Links, ThatGitIgnoresAreNotToldOf) {
    folder.write(".gitignore", "lib\nO7.nc\n");
    link("shop/lib", "../out");
    link("shop/O7.nc", "../out/O1001.nc");
    const Finished finished = check({"shop"});
    EXPECT_EQ(finished.out, "no findings (1 checked, 1 program ignored by git)\n");
    EXPECT_THAT(finished.err, IsEmpty());
}

TEST_F(Links, InThePlaceOfIgnoreFilesAreNotFollowed) {
    folder.write("rules", "*.nc\n");
    link("shop/.gitignore", "../rules");
    fs::create_directories(folder.path() / ".git/info");
    link(".git/info/exclude", "../../rules");
    EXPECT_THAT(check({"shop"}).out, HasSubstr("(1 checked)"));
    folder.write(".git/../.gitignore", "*.nc\n");
    EXPECT_THAT(check({"shop"}).out, HasSubstr("1 program ignored by git"));
}

TEST_F(Links, ToFilesOfTheSystemThatNeverEndDoNotHang) {
    link("shop/O2.nc", "/proc/kmsg");
    link("shop/.gitignore", "/proc/kmsg");
    const Finished finished = shell("timeout 8 $maclint --format concise shop");
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.err, one_is_left_out);
}

TEST_F(Links, AnIgnoreFileTooLargeIsNotedAndDoesNotHold) {
    folder.write("shop/.gitignore", "*.nc\n" + std::string(std::size_t{1} << 16U, '#'));
    const Finished finished = check({"shop"});
    EXPECT_THAT(finished.out, HasSubstr("(1 checked)"));
    EXPECT_THAT(finished.err,
                AllOf(StartsWith("maclint: note: "), HasSubstr("shop/.gitignore: cannot be read: it is "
                                                               "larger than 64 KiB.")));
}

TEST_F(Links, OutOfAFolderWithoutProgramsAreOneNote) {
    fs::create_directory(folder.path() / "bare");
    link("bare/O2.nc", "../out/O1001.nc");
    EXPECT_EQ(check({"bare"}).err,
              "maclint: note: bare: no NC program is in this folder (1 link to elsewhere not followed). Say "
              "--follow-links to have checked what is behind links, or name files themselves.\n");
}

} // namespace
} // namespace maclint::test
