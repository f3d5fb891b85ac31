//! --since runs nothing that a repository names, writes nothing, and shows what it should.
#include "tests/cli/hostile_repositories.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/process.hpp"

#include <cctype>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr std::string_view before = "%\nO1001\nGOTO 99\nN1 G0 X1.\nM30\n%\n";              // line 3
constexpr std::string_view now = "%\nO1001\nGOTO 99\nN1 G0 X1.\nG1 X1. F9. F8.\nM30\n%\n"; // line 5 is new

class HostileRepositories : public testing::Test {
  protected:
    void SetUp() override {
        if (run_shell(beside_.path().string(), "git --version").status != 0)
            GTEST_SKIP() << "there is no git";
        // It must not lie in the folder whose files are compared before and after.
        const std::string ran = beside_.write("ran", "#!/bin/sh\necho \"$0 $*\" >> " + mark() + "\n");
        fs::permissions(ran, fs::perms::owner_all);
        beside_.write("all.attributes", "*.nc filter=x diff=x merge=x\n");
        for (const std::string_view hook : hook_names()) {
            fs::create_directories(ran + ".hooks");
            fs::copy_file(ran, ran + ".hooks/" + std::string(hook));
        }
    }

    [[nodiscard]] std::string mark() const { return (beside_.path() / "mark").string(); }

    enum class Written : std::uint8_t { nothing, perhaps };

    /// What came of --since in a repository that a script made hostile. Nothing was run.
    [[nodiscard]] Finished since(std::string_view script, Written written = Written::nothing) const {
        const TemporaryFolder base;
        base.write("outside/here", "");
        base.write("repository/O1001.nc", before);
        const std::string setup = names(base) + R"(
            cd "$repository" && git init -q . && git config user.name a && git config user.email b &&
            git config core.autocrlf false && git add -A && git commit -q -m x || exit 99
            echo '*.nc filter=x diff=x merge=x' > .git/info/attributes
            cat "$now" > O1001.nc
            make_hostile() {
)" + std::string(script) +
                                  R"(
            }
            make_hostile > "$beside/log" 2>&1
            rm -f "$mark"
            look() { find "$base" -printf '%p %s %T@\n' | sort; }
            look > "$beside/looked-before"
            "$maclint" --isolated --format concise --quiet --select MAC301,MAC559 --since HEAD O1001.nc
            status=$?
            look | diff "$beside/looked-before" - > "$beside/changed"
            exit $status)";
        beside_.write("now", now);
        Finished finished = run_shell(base.path().string(), setup);
        EXPECT_FALSE(fs::exists(mark())) << read_file(mark());
        if (written == Written::nothing) {
            EXPECT_EQ(read_file(beside_.path() / "changed"), "");
        }
        return finished;
    }

    [[nodiscard]] std::string all_settings() const {
        std::string script = R"(rm -f "$all"; set_all() { git config --file "$all" --add "$1" "$2"; }; )";
        for (const HostileSetting& setting : hostile_settings())
            script += "set_all " + std::string(setting.key) + " \"" + std::string(setting.value) + "\"; ";
        return script;
    }

  private:
    [[nodiscard]] std::string names(const TemporaryFolder& base) const {
        std::string hooks;
        for (const std::string_view hook : hook_names()) hooks += std::string(hook) + " ";
        return "base='" + base.path().string() + "'; beside='" + beside_.path().string() +
               "'; repository=$base/repository; outside=$base/outside; ran=$beside/ran; all=$beside/all; "
               "mark=$beside/mark; now=$beside/now; hooks='" +
               hooks + "'";
    }

    TemporaryFolder beside_;
};

void expect_the_finding(const Finished& finished) {
    EXPECT_THAT(finished.out, StartsWith("O1001.nc:5:12: warning[MAC559]"));
    EXPECT_THAT(finished.err, IsEmpty());
    EXPECT_EQ(finished.status, 1);
}

TEST_F(HostileRepositories, NoSettingRunsACommand) {
    for (const HostileSetting& setting : hostile_settings()) {
        SCOPED_TRACE(setting.key);
        expect_the_finding(since("git config --add " + std::string(setting.key) + " \"" +
                                 std::string(setting.value) + "\""));
    }
}

/// Either the run ends, or what cannot be compared is shown whole.
void expect_refusal(const Finished& finished, std::string_view refusal) {
    EXPECT_EQ(finished.status, 2);
    EXPECT_THAT(finished.err, AllOf(StartsWith("maclint: error: "), HasSubstr(refusal)));
    EXPECT_THAT(finished.out,
                AnyOf(IsEmpty(), AllOf(HasSubstr("O1001.nc:3:1:"), HasSubstr("O1001.nc:5:12:"))));
}

TEST_F(HostileRepositories, NoRepositoryRunsACommandOrLosesAFinding) {
    for (const HostileRepository& repository : hostile_repositories()) {
        SCOPED_TRACE(repository.name);
        const Finished finished = since(all_settings() + std::string(repository.script));
        if (repository.refusal.empty()) {
            expect_the_finding(finished);
        } else {
            expect_refusal(finished, repository.refusal);
        }
    }
}

TEST_F(HostileRepositories, NothingIsFetched) {
    for (const HostileRepository& repository : hostile_promisors()) {
        SCOPED_TRACE(repository.name);
        expect_refusal(since(repository.script), repository.refusal);
    }
}

/// Before 2.39.4 git tries to fetch what is missing, whatever it is told, and first notes in the repository's
/// settings how it will.
TEST_F(HostileRepositories, NothingIsFetchedByAnOlderGit) {
    constexpr std::string_view older = R"(
        git=$(command -v git); mkdir -p "$beside/older"
        printf '#!/bin/sh\nunset GIT_NO_LAZY_FETCH\nexec %s "$@"\n' "$git" > "$beside/older/git"
        chmod +x "$beside/older/git"; PATH=$beside/older:$PATH; export PATH)";
    for (const HostileRepository& repository : hostile_promisors()) {
        SCOPED_TRACE(repository.name);
        expect_refusal(since(std::string(repository.script) + std::string(older), Written::perhaps),
                       "--since ");
    }
}

std::string in_small_letters(std::string_view text) {
    std::string small(text);
    std::ranges::transform(small, small.begin(), [](unsigned char c) { return std::tolower(c); });
    return small;
}

/// Whether a setting's name sounds as if its value were run.
bool sounds_like_a_command(std::string_view key) {
    for (const std::string_view harmless :
         {"advice.", "color.", "column.", "diff.<driver>.cachetextconv", "gitcvs.dbdriver"})
        if (key.starts_with(harmless)) return false;
    for (const std::string_view name :
         {"cmd",        "command",     "program",   "helper", "hook",     "hookspath", "driver",   "textconv",
          ".clean",     ".smudge",     ".process",  "editor", "pager",    "askpass",   "gitproxy", "tunnel",
          "uploadpack", "receivepack", "fsmonitor", "httpd",  "external", "target",    "worktree"})
        if (key.ends_with(name)) return true;
    return false;
}

/// In the list "x" stands for what the documentation writes as <driver>, <name>.
bool is_listed(std::string_view key) {
    return std::ranges::any_of(hostile_settings(), [&](const HostileSetting& setting) {
        const std::string listed = in_small_letters(setting.key);
        const auto open = key.find('<');
        if (open == std::string_view::npos) return listed == key;
        return listed.starts_with(key.substr(0, open)) && listed.ends_with(key.substr(key.find('>') + 1));
    });
}

/// The documentation of the git that is here names no command that the list lacks.
TEST_F(HostileRepositories, TheListIsComplete) {
    const Finished listed = run_shell("/", "git help --config");
    if (listed.status != 0) GTEST_SKIP() << "this git does not list its settings";
    std::size_t commands = 0;
    for (std::string_view rest = listed.out; !rest.empty();) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(rest.size(), line.size() + 1));
        const std::string key = in_small_letters(line);
        if (!sounds_like_a_command(key)) continue;
        ++commands;
        EXPECT_TRUE(is_listed(key)) << key;
    }
    EXPECT_GT(commands, 20U);
}

} // namespace
} // namespace maclint::test
