//! What a configuration that came with a folder may name, and what is said of the rest.
#include "cli/config/reach.hpp"
#include "cli/input/other_server.hpp"
#include "tests/support/in_repository.hpp"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace maclint::cli {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

TEST(OtherServer, IsKnownByTheTextOfAPath) {
    for (const char* written :
         {R"(\\server\share\shop.json)", "//server/share/shop.json", R"(\/server\share)", "//server",
          R"(\\?\UNC\server\share\shop.json)", R"(\\?\C:\shop.json)", R"(\\.\pipe\shop)", "//./COM1",
          R"(\??\UNC\server\share\x)", "//?/unc/server/share"}) {
        EXPECT_TRUE(names_other_server(written, "C:/shop")) << written;
        EXPECT_TRUE(names_other_server(written, "//server/other/lathe")) << written;
    }
    EXPECT_FALSE(names_other_server(R"(\\Server\SHARE\shop.json)", "//server/share/lathe"));
    EXPECT_TRUE(names_other_server(R"(\\server\shared\shop.json)", "//server/share/lathe"));
    EXPECT_TRUE(names_other_server(R"(\\server)", "//server/share/lathe"));
    for (const char* written :
         {"shop.json", "../shop.json", "/shop.json", R"(\shop.json)", "C:/shop.json", "?/a", ""})
        EXPECT_FALSE(names_other_server(written, "C:/shop")) << written;
}

TEST(OtherServer, IsNotTheOnlyOtherPlaceADriveMayBe) {
    for (const char* written : {"D:/shop.json", R"(d:\shop.json)", "C:shop.json", "c:", "D:shop.json"})
        EXPECT_TRUE(names_other_drive(written, "C:/shop")) << written;
    EXPECT_TRUE(names_other_drive("C:/shop.json", "//server/share"));
    for (const char* written : {"C:/shop.json", R"(c:\shop.json)", "shop.json", "/C:/shop.json", "1:/x", ""})
        EXPECT_FALSE(names_other_drive(written, "c:/shop")) << written;
}

TEST(OtherServer, IsSeenBehindLinksThatNobodyFollows) {
    const test::TemporaryFolder folder;
    fs::create_symlink("//server/share", folder.path() / "far");
    fs::create_directory(folder.path() / "a");
    fs::create_directory_symlink("../far/x", folder.path() / "a/near");
    fs::create_directory_symlink("a", folder.path() / "b");
    fs::create_symlink("circle", folder.path() / "circle");
    for (const char* path : {"far", "far/shop.json", "a/near/y", "b/near", "b/../far"})
        EXPECT_TRUE(leads_to_other_server(folder.path() / path, "/shop")) << path;
    for (const char* path : {"a", "b/x", "circle/x", "gone/far", "far/../../../x"})
        EXPECT_EQ(leads_to_other_server(folder.path() / path, "/shop"),
                  std::string_view(path).starts_with("far"))
            << path;
}

TEST(Stranger, IsNeitherTheUserNorRoot) {
    EXPECT_TRUE(is_of_stranger({.owner = 1001, .runner = 1000}));
    EXPECT_TRUE(is_of_stranger({.owner = 1001, .runner = 0}));
    EXPECT_FALSE(is_of_stranger({.owner = 1000, .runner = 1000}));
    EXPECT_FALSE(is_of_stranger({.owner = 0, .runner = 1000}));
    EXPECT_FALSE(is_of_stranger({.owner = 0, .runner = 0}));
}

/// Two folders, of which the second is what a stranger sent.
class Configurations : public test::InRepository {
  protected:
    void SetUp() override {
        folder.write("secret.json", R"({"the secret": "word"})");
        folder.write("shop.json", R"({"ignore": ["MAC301"]})");
        folder.write("base.json", R"({"maclint-baseline": 1, "findings": []})");
        folder.write("repository/.git/HEAD", "");
        folder.write("repository/sub/O1001.nc", test::with_defect);
        folder.write("plain/sub/O1001.nc", test::with_defect);
    }
    [[nodiscard]] test::Finished check(const std::string& in, std::vector<std::string> arguments = {}) const {
        arguments.insert(arguments.begin(), {"--format", "concise"});
        return test::run_maclint((folder.path() / in).string(), arguments, "");
    }
    void refuses(const std::string& in, const std::string& text, const std::string& message) const {
        folder.write(in + "/.maclint.json", text);
        const test::Finished finished = check(in, {"--quiet"});
        EXPECT_EQ(finished.status, 2) << text;
        EXPECT_THAT(finished.err,
                    AllOf(StartsWith("maclint: error: .maclint.json: line 1, column "), HasSubstr(message),
                          HasSubstr("If you trust this configuration, name it with --config."),
                          Not(HasSubstr("secret\"")), Not(HasSubstr("the secret")), Not(HasSubstr("root:"))))
            << text;
    }
    void accepts(const std::string& in, const std::string& text) const {
        folder.write(in + "/.maclint.json", text);
        const test::Finished finished = check(in);
        EXPECT_NE(finished.status, 2) << text << finished.err;
    }
    [[nodiscard]] std::string at(const std::string& name) const { return (folder.path() / name).string(); }
};

TEST_F(Configurations, NameNoFileOutsideOfTheirRepository) {
    fs::create_symlink("../../secret.json", folder.path() / "repository/sub/link.json");
    fs::create_directory_symlink(folder.path(), folder.path() / "repository/out");
    for (const std::string key : {"extends", "baseline"})
        for (const std::string& name :
             std::vector<std::string>{"../secret.json", "../gone.json", "sub/../../secret.json",
                                      at("secret.json"), "/etc/passwd", "sub/link.json", "out/secret.json",
                                      "sub/../out/shop.json", "/proc/self/environ", "../repositoryB/x"}) {
            const std::string text =
                std::string("{\"").append(key).append("\": \"").append(name).append("\"}");
            refuses("repository", text,
                    std::string("'")
                        .append(key)
                        .append("' names '")
                        .append(name)
                        .append("', which lies outside of this repository."));
        }
    refuses("repository", R"({"extends": "\\\\server\\share\\shop.json"})", "which is on another server.");
    refuses("repository", R"({"baseline": "//server/share/base.json"})", "which is on another server.");
    refuses("repository", R"({"baseline": "D:base.json"})", "which is on another drive.");
}

TEST_F(Configurations, NameWhatTheyLikeWithinTheirRepository) {
    folder.write("repository/common/shop.json", R"({"ignore": ["MAC301"]})");
    folder.write("repository/base.json", R"({"maclint-baseline": 1, "findings": []})");
    fs::create_symlink("../common/shop.json", folder.path() / "repository/sub/shop.json");
    accepts("repository/sub", R"({"extends": "../common/shop.json", "baseline": "../base.json"})");
    accepts("repository/sub", R"({"extends": "shop.json"})");
    accepts("repository/sub", "{\"extends\": \"" + at("repository/common/shop.json") + "\"}");
}

TEST_F(Configurations, ThatAreExtendedHaveTheSameBounds) {
    folder.write("repository/sub/near.json", R"({"extends": "../../secret.json"})");
    folder.write("repository/.maclint.json", R"({"extends": "sub/near.json"})");
    EXPECT_THAT(
        check("repository").err,
        HasSubstr(
            "sub/near.json: line 1, column 13: 'extends' names '../../secret.json', which lies outside"));
}

TEST_F(Configurations, WithoutARepositoryNameFilesAboveAndBelowThemselves) {
    fs::remove_all(folder.path() / "repository/.git");
    folder.write("plain/sub/shop.json", "{}");
    accepts("plain", R"({"extends": "../shop.json"})");
    accepts("plain", R"({"extends": "sub/shop.json", "baseline": "../base.json"})");
    accepts("plain/sub", R"({"extends": "../../shop.json"})");
    fs::remove(folder.path() / "plain/sub/.maclint.json");
    folder.write("beside/shop.json", "{}");
    refuses("plain", R"({"extends": "../beside/shop.json"})",
            "which lies outside of this folder and those above it.");
    fs::create_symlink("../../beside/shop.json", folder.path() / "plain/sub/link.json");
    refuses("plain", R"({"baseline": "sub/link.json"})",
            "which lies outside of this folder and those above it.");
}

TEST_F(Configurations, WithoutARepositoryNameFilesOfTheFolderThatWasNamedOrIsTheWorkingOne) {
    folder.write("plain/common/shop.json", R"({"ignore": ["MAC301"]})");
    folder.write("plain/bl/base.json", R"({"maclint-baseline": 1, "findings": []})");
    folder.write("plain/sub/.maclint.json",
                 R"({"extends": "../common/shop.json", "baseline": "../bl/base.json"})");
    for (const auto& [in, path] : std::vector<std::pair<std::string, std::string>>{{"plain", "."},
                                                                                   {"", "plain"},
                                                                                   {"plain/sub", ".."},
                                                                                   {"plain", "sub/O1001.nc"},
                                                                                   {"/", at("plain")}}) {
        const auto from = in == "/" ? fs::path(in) : folder.path() / in;
        const test::Finished finished = test::run_maclint(from.string(), {path}, "");
        EXPECT_EQ(finished.status, 0) << in << path << finished.err;
    }
    for (const auto& [in, path] :
         std::vector<std::pair<std::string, std::string>>{{"plain/sub", "."}, {"/", at("plain/sub")}}) {
        const auto from = in == "/" ? fs::path(in) : folder.path() / in;
        const test::Finished finished = test::run_maclint(from.string(), {path}, "");
        EXPECT_EQ(finished.status, 2) << in << path;
        EXPECT_THAT(finished.err, HasSubstr("lies outside of this folder and those above it."));
    }
    // A folder that was named holds nothing for what is beside it.
    EXPECT_EQ(test::run_maclint("/", {at("plain/sub"), at("plain/common")}, "").status, 2);
}

TEST_F(Configurations, OfAHomeFolderNameNoFilesBesideThemselves) {
    folder.write("home/common/shop.json", "{}");
    folder.write("home/zip/.maclint.json", R"({"extends": "../common/shop.json"})");
    folder.write("home/zip/O1001.nc", test::without_defect);
    fs::remove_all(folder.path() / ".git");
    const std::string home = at("home");
    EXPECT_EQ(test::run_shell(home, "HOME='" + home + "' $maclint zip").status, 2);
    EXPECT_EQ(test::run_shell(home, "HOME=/nowhere $maclint zip").status, 0);
    EXPECT_EQ(test::run_shell(at(""), "HOME='" + home + "' $maclint home/zip").status, 2);
    EXPECT_EQ(test::run_shell(home, "HOME='" + home + "' $maclint .").status, 0);
}

TEST_F(Configurations, DoNotMakeAnybodyQuoteFilesOfFoldersAbove) {
    folder.write("cred.json", R"({"s3cret-key": 1})");
    folder.write("rules.json", R"({"ignore": ["s3cret-word"]})");
    for (const std::string name : {"cred.json", "rules.json"}) {
        folder.write("plain/.maclint.json", "{\"extends\": \"../" + name + "\"}");
        EXPECT_THAT(check("plain").err,
                    AllOf(StartsWith("maclint: error: ../" + name + ": line 1, column "),
                          HasSubstr("text of a folder above is not shown"), Not(HasSubstr("s3cret"))));
        EXPECT_THAT(check("plain", {"--config", "../" + name}).err, HasSubstr("s3cret"));
        EXPECT_THAT(check("", {"plain"}).err, HasSubstr("s3cret")) << "the working folder is the user's own";
    }
    fs::remove(folder.path() / "plain/.maclint.json");
    fs::create_symlink("../cred.json", folder.path() / "plain/.maclint.json");
    EXPECT_THAT(check("plain").err, AllOf(HasSubstr("is not shown"), Not(HasSubstr("s3cret"))));
}

TEST_F(Configurations, WaitForNoPipes) {
    EXPECT_EQ(test::run_shell(at("plain"), "mkfifo p").status, 0);
    for (const std::string key : {"extends", "baseline"}) {
        folder.write("plain/.maclint.json", "{\"" + key + "\": \"p\"}");
        for (const std::vector<std::string>& words :
             {std::vector<std::string>{}, std::vector<std::string>{"--config", ".maclint.json"}}) {
            const test::Finished finished = check("plain", words);
            EXPECT_EQ(finished.status, 2);
            EXPECT_EQ(finished.err,
                      "maclint: error: p: cannot be read: it is a pipe. Name a file instead.\n");
        }
    }
    const std::string base = "{\"maclint-baseline\": 1, \"findings\": []}";
    EXPECT_EQ(test::run_shell(at("plain"), "cat ../shop.json > p & $maclint --config p").status, 0);
    EXPECT_EQ(
        test::run_shell(at("plain"), "echo '" + base + "' > p & $maclint --isolated --baseline p").status, 1);
}

TEST_F(Configurations, ThatAreWrongAreToldOfOnce) {
    fs::create_directory(folder.path() / "plain/.maclint.json");
    for (const std::string path : {".", "./", "sub/..", "sub/../."}) {
        const std::string err = check("plain", {path, "sub/O1001.nc"}).err;
        EXPECT_EQ(err.find("is a folder, a pipe"), err.rfind("is a folder, a pipe")) << path << err;
        EXPECT_THAT(err, HasSubstr("is a folder, a pipe")) << path;
    }
}

TEST_F(Configurations, ThatTheCommandLineNamesMayNameAnything) {
    folder.write("repository/shop.json", R"({"extends": "../shop.json"})");
    folder.write("repository/.maclint.json", R"({"extends": "shop.json", "baseline": "../base.json"})");
    EXPECT_EQ(check("repository").status, 2);
    const test::Finished named = check("repository", {"--config", ".maclint.json"});
    EXPECT_EQ(named.status, 0) << named.err;
    EXPECT_THAT(named.err, IsEmpty());
}

TEST_F(Configurations, ThatAreLinksLeadToNothingOutside) {
    fs::create_symlink("../secret.json", folder.path() / "repository/.maclint.json");
    const test::Finished finished = check("repository");
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(finished.err.substr(0, finished.err.find('\n')),
              "maclint: error: .maclint.json: is a link to a file that lies outside of this repository. If "
              "you trust "
              "it, name that file with --config.");
    fs::remove(folder.path() / "repository/.maclint.json");
    fs::create_symlink("//server/share/x.json", folder.path() / "repository/.maclint.json");
    EXPECT_THAT(check("repository").err, HasSubstr("is a link to a file that is on another server."));
    fs::remove(folder.path() / "repository/.maclint.json");
    folder.write("repository/sub/shop.json", R"({"ignore": ["MAC301"]})");
    fs::create_symlink("sub/shop.json", folder.path() / "repository/.maclint.json");
    EXPECT_EQ(check("repository").status, 0);
}

TEST_F(Configurations, AreNotQuotedWhereTheyAreNone) {
    for (const char* text :
         {"root:x:0:0:the secret\n", "\"the secret\n\"", "{\"a\": the secret}", "{\"a\" 1e999}"}) {
        folder.write("plain/.maclint.json", text);
        EXPECT_THAT(check("plain").err,
                    AllOf(StartsWith("maclint: error: .maclint.json: line 1, column "),
                          AnyOf(HasSubstr("this is no JSON: "), HasSubstr("a word has no quotes")),
                          Not(HasSubstr("secret")), Not(HasSubstr("root:")), Not(HasSubstr("999"))))
            << text;
    }
}

TEST_F(Configurations, AboveTheRepositoryAreNamedOnce) {
    folder.write(".maclint.json", R"({"ignore": ["MAC303"]})");
    folder.write("repository/other/O1002.nc", test::without_defect);
    const std::string note =
        "maclint: note: ../.maclint.json: this configuration lies above the repository of the "
        "programs that it holds for. Put one into the repository, or leave it out with "
        "--isolated.\n";
    EXPECT_EQ(check("repository").err, note);
    EXPECT_THAT(check("repository", {"--quiet"}).err, IsEmpty());
    EXPECT_THAT(check("repository", {"--config", "../.maclint.json"}).err, IsEmpty());
    EXPECT_THAT(check("plain").err, IsEmpty());
    EXPECT_THAT(test::run_maclint(at("repository"), {"--format", "json"}, "").out,
                HasSubstr("lies above the repository"));
    EXPECT_THAT(test::run_maclint(at("repository"), {"--format", "sarif"}, "").out, HasSubstr("\"NOTE007\""));
    folder.write(".git/HEAD", ""); // a repository within another, such as a submodule
    EXPECT_THAT(check("repository").err, IsEmpty());
}

TEST_F(Configurations, OfAnotherUserAreNamedOnce) {
    if (::geteuid() != 0) GTEST_SKIP() << "only the superuser can give files away";
    folder.write("plain/.maclint.json", R"({"extends": "sub/shop.json"})");
    const std::string extended = folder.write("plain/sub/shop.json", "{}");
    EXPECT_THAT(check("plain").err, IsEmpty());
    constexpr uid_t stranger = 12345;
    ASSERT_EQ(::chown(extended.c_str(), stranger, 0), 0);
    EXPECT_EQ(check("plain").err,
              "maclint: note: sub/shop.json: this configuration belongs to another user. Look at "
              "what it says, or leave it out with --isolated.\n");
    EXPECT_THAT(check("plain", {"--config", ".maclint.json"}).err, IsEmpty());
}

TEST_F(Configurations, GlobsLeadNoSearchOutOfAFolder) {
    folder.write("plain/.maclint.json", R"({"include": ["../**", "**", "../*", "/etc/*"]})");
    folder.write("beside.txt", "%\nO1\nM30\n%\n");
    EXPECT_THAT(check("plain").out, HasSubstr("(1 checked)"));
}

} // namespace
} // namespace maclint::cli
