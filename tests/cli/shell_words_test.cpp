//! The manual page and the completion scripts hold what the command line takes, and shells can read them.
#include "cli/command_line.hpp"
#include "cli/shell/command_list.hpp"
#include "cli/shell/completions.hpp"
#include "cli/shell/manual_page.hpp"
#include "tests/support/folder.hpp"
#include "tests/support/lines.hpp"
#include "tests/support/process.hpp"

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using test::Finished;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

std::string printed(std::vector<std::string> arguments) {
    const Request request = read_command_line(std::move(arguments));
    const auto* print = std::get_if<PrintRequest>(&request);
    return print == nullptr ? "not printed" : print->text;
}

bool accepts(const std::string& command, const OptionText& option, const std::string& word) {
    std::vector<std::string> arguments = {command};
    if (!option.names.empty()) arguments.push_back(option.names.front());
    arguments.push_back(word);
    if (command == "explain" && !option.names.empty()) arguments.emplace_back("MAC301"); // it needs one
    if (command == "renumber" && !option.names.empty()) arguments.emplace_back("O1.nc");
    return !std::holds_alternative<UsageError>(read_command_line(std::move(arguments)));
}

/// "--format" of every command's help, taken from the text that a person reads.
std::vector<std::string> options_in(std::string help) {
    std::vector<std::string> names;
    std::ranges::replace(help, ',', ' ');
    std::istringstream words(help);
    for (std::string word; words >> word;) {
        word = word.substr(0, word.find_first_of(";."));
        if (word.starts_with("--") && word.size() > 2) names.push_back(word);
    }
    return names;
}

TEST(CommandList, HoldsEveryOptionOfTheHelp) {
    for (const CommandText& command : command_list()) {
        std::vector<std::string> known;
        for (const OptionText& option : command.options)
            known.insert(known.end(), option.names.begin(), option.names.end());
        const std::string help = printed({command.name, "--help"});
        EXPECT_THAT(options_in(help), Contains("--help")) << command.name;
        for (const std::string& name : options_in(help))
            EXPECT_TRUE(name == "--version" || std::ranges::count(known, name) == 1)
                << command.name << ' ' << name;
    }
}

TEST(CommandList, KnowsTheCommandsThatTheHelpNames) {
    const std::string help = printed({"--help"});
    for (const CommandText& command : command_list())
        EXPECT_THAT(help, HasSubstr(command.name == "check" ? "maclint [check]" : "maclint " + command.name));
    EXPECT_THAT(command_list(), SizeIs(11U));
}

TEST(CommandList, NamesTheWordsThatAnOptionTakesAndNoOther) {
    std::size_t checked = 0;
    for (const CommandText& command : command_list())
        for (const OptionText& option : command.options)
            for (const std::string& word : option.words) {
                EXPECT_TRUE(accepts(command.name, option, word)) << command.name << ' ' << word;
                ++checked;
            }
    EXPECT_GT(checked, 200U); // codes and names of rules among them
}

/// An option that refuses a word that nobody knows has its words in the list, or is a number, of two parts,
/// or takes codes of programs or what a machine has, of which there is no end.
TEST(CommandList, LeavesNoOptionWithoutItsWords) {
    for (const CommandText& command : command_list())
        for (const OptionText& option : command.options) {
            if (option.kind != ValueKind::free || option.value == "N" || option.value == "SIZE" ||
                option.value == "FORMAT:FILE" || option.value == "RULE=LEVEL" || option.value == "CODES" ||
                option.value == "CODE=PROGRAM" || option.value == "OPTIONS" || option.value == "LETTERS" ||
                option.value == "TEXT")
                continue;
            EXPECT_TRUE(accepts(command.name, option, "no-such-word")) << option.names.front();
        }
}

TEST(ManualPage, HasAnEntryForEveryOption) {
    const std::string page = printed({"man"});
    for (const CommandText& command : command_list()) {
        EXPECT_THAT(page, HasSubstr(".SS maclint " + command.name + "\n"));
        for (const OptionText& option : command.options)
            for (std::string name : option.names) {
                for (auto at = name.find('-'); at != std::string::npos; at = name.find('-', at + 2))
                    name.insert(at, "\\");
                EXPECT_THAT(page, HasSubstr("\\fB" + name + "\\fR"));
            }
    }
    EXPECT_THAT(page, HasSubstr("maclint " MACLINT_VERSION));
}

TEST(ManualPage, IsNotTakenForRequestsWhereATextBeginsLikeOne) {
    const CommandText command{
        "check", "", {{{"--x"}, "", ".maclint.json \\ it's", ValueKind::none, {}, false}}};
    EXPECT_THAT(manual_page({command}, "1"), HasSubstr("\n\\&.maclint.json \\e it\\(aqs.\n"));
}

TEST(ManualPage, IsPrintedWithoutAComplaintOfGroff) {
    const test::TemporaryFolder folder;
    const Finished finished = test::run_shell(
        folder.path().string(),
        R"(command -v groff >/dev/null || exit 77; "$maclint" man | groff -man -Tutf8 -ww -z 2>&1)");
    if (finished.status == 77) GTEST_SKIP() << "groff is not installed";
    EXPECT_THAT(finished.out + finished.err, IsEmpty());
}

TEST(Completions, AskForAShellThatIsKnown) {
    const auto refusal = [](std::vector<std::string> arguments) {
        return std::get<UsageError>(read_command_line(std::move(arguments))).message;
    };
    EXPECT_THAT(refusal({"completions"}), HasSubstr("Write 'maclint completions bash'"));
    EXPECT_THAT(refusal({"completions", "fich"}), HasSubstr("Did you mean 'fish'?"));
}

class CompletionsOfBash : public testing::Test {
  protected:
    void SetUp() override {
        if (test::run_shell(folder.path().string(), "command -v bash").status != 0)
            GTEST_SKIP() << "bash is not installed";
    }

    /// What bash offers for the last of the words.
    [[nodiscard]] std::vector<std::string> offered(const std::string& words) const;

    test::TemporaryFolder folder;
};

std::vector<std::string> CompletionsOfBash::offered(const std::string& words) const {
    const Finished finished = test::run_shell(folder.path().string(), R"sh(
cat >ask.bash <<'ASK'
eval "$("$1" completions bash)" || exit 9
shift
COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
_maclint
printf '%s\n' "${COMPREPLY[@]}"
ASK
bash ask.bash "$maclint" )sh" + words);
    EXPECT_EQ(finished.status, 0) << words;
    EXPECT_THAT(finished.err, IsEmpty()) << words;
    std::vector<std::string> lines = test::lines_of(finished.out);
    std::erase(lines, "");
    return lines;
}

TEST_F(CompletionsOfBash, OfferCommandsOptionsAndValues) {
    EXPECT_THAT(offered("maclint ex"), ElementsAre("explain"));
    EXPECT_THAT(offered("maclint --stdin"), ElementsAre("--stdin-filename"));
    EXPECT_THAT(offered("maclint rules --w"), ElementsAre("--write-docs", "--write-codes", "--write-alarms"));
    EXPECT_THAT(offered("maclint rules --form"), ElementsAre("--format"));
    EXPECT_THAT(offered("maclint rules --sel"), IsEmpty());
    EXPECT_THAT(offered("maclint --format sa"), ElementsAre("sarif"));
    EXPECT_THAT(offered("maclint check --format = con"), ElementsAre("concise"));
    EXPECT_THAT(offered("maclint rules --format ''"), ElementsAre("text", "json", "markdown"));
    EXPECT_THAT(offered("maclint --fail-on ="), ElementsAre("error", "warning", "note", "never"));
    EXPECT_THAT(offered("maclint --select MAC301,MAC303,jump-into-l"),
                ElementsAre("MAC301,MAC303,jump-into-loop"));
    EXPECT_THAT(offered("maclint explain jump-into-l"), ElementsAre("jump-into-loop"));
    EXPECT_THAT(offered("maclint completions z"), ElementsAre("zsh"));
    EXPECT_THAT(offered("maclint controls fanuc-30i-lathe-"),
                ElementsAre("fanuc-30i-lathe-b", "fanuc-30i-lathe-c"));
    EXPECT_THAT(offered("maclint controls --format ''"), ElementsAre("text", "json"));
    EXPECT_THAT(offered("maclint explain --control nc"), ElementsAre("nct"));
}

TEST_F(CompletionsOfBash, LeaveFilesToBash) {
    EXPECT_THAT(offered("maclint --config ."), IsEmpty());
    EXPECT_THAT(offered("maclint check O1"), IsEmpty());
}

TEST(Completions, OfZshAreReadByZshWhereItIsInstalled) {
    const std::string script = printed({"completions", "zsh"});
    EXPECT_THAT(script, AllOf(HasSubstr("'--format=[What goes to standard output\\: text"),
                              HasSubstr(":FORMAT:(text "), HasSubstr("'(--help -h)-h[This text]'"),
                              HasSubstr("'*--select=[")));
    const test::TemporaryFolder folder;
    const Finished finished = test::run_shell(folder.path().string(), R"(command -v zsh >/dev/null || exit 77
"$maclint" completions zsh >_maclint && zsh -n _maclint)");
    if (finished.status == 77) GTEST_SKIP() << "zsh is not installed";
    EXPECT_EQ(finished.status, 0) << finished.err;
}

TEST(Completions, OfFishOfferWhereItIsInstalled) {
    const std::string script = printed({"completions", "fish"});
    EXPECT_THAT(script, HasSubstr("-l format -x -a 'text concise json sarif"));
    EXPECT_THAT(script, HasSubstr("-l help -s h -d 'This text'"));
    const test::TemporaryFolder folder;
    const Finished finished = test::run_shell(folder.path().string(), R"(command -v fish >/dev/null || exit 77
export HOME="$PWD"
"$maclint" completions fish >maclint.fish
fish -N -c 'source maclint.fish; complete -C "maclint rules --format ma"; complete -C "maclint --select MAC301,MAC303,jump-into-l"')");
    if (finished.status == 77) GTEST_SKIP() << "fish is not installed";
    EXPECT_THAT(finished.out, AllOf(HasSubstr("markdown"), HasSubstr("MAC301,MAC303,jump-into-loop")));
    EXPECT_THAT(finished.out, Not(HasSubstr("sarif")));
}

} // namespace
} // namespace maclint::cli
