//! What the words of a command line mean, and what is said of words that mean nothing.
#include "cli/command_line.hpp"
#include "cli/shell/command_list.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

CheckRequest check(std::vector<std::string> arguments) {
    Request request = read_command_line(std::move(arguments));
    if (const auto* error = std::get_if<UsageError>(&request)) ADD_FAILURE() << error->message;
    return std::get<CheckRequest>(std::move(request));
}

std::string refusal(std::vector<std::string> arguments) {
    const Request request = read_command_line(std::move(arguments));
    const auto* error = std::get_if<UsageError>(&request);
    return error == nullptr ? "accepted" : error->message;
}

TEST(CommandLine, ChecksWhenTheFirstWordIsNoCommand) {
    EXPECT_THAT(check({}).paths, ElementsAre("."));
    EXPECT_THAT(check({"--quiet", "-", "/"}).paths, ElementsAre("-", "/"));
    EXPECT_THAT(check({"check", "/"}).paths, ElementsAre("/"));
    EXPECT_TRUE(std::holds_alternative<RulesRequest>(read_command_line({"rules"})));
    EXPECT_TRUE(std::holds_alternative<ExplainRequest>(read_command_line({"explain", "MAC303"})));
}

TEST(CommandLine, PrintsTextUnlessAReportGoesToStandardOutput) {
    ASSERT_EQ(check({}).sinks.size(), 1U);
    EXPECT_EQ(check({}).sinks[0].format, Format::text);
    const auto two = check({"--output", "sarif:a:b.sarif", "--output=json:x"}).sinks;
    ASSERT_EQ(two.size(), 3U);
    EXPECT_EQ(two[0].path, "a:b.sarif");
    EXPECT_EQ(two[2].path, "-");
    EXPECT_EQ(check({"--output", "sarif:-"}).sinks.size(), 1U);
}

TEST(CommandLine, EndsOptionsBehindTwoDashes) {
    EXPECT_THAT(check({"-q", "--", "/", "-x", "--", "-"}).paths, ElementsAre("/", "-x", "--", "-"));
    EXPECT_TRUE(check({"-q"}).quiet);
    EXPECT_FALSE(check({"--", "-q"}).quiet);
}

TEST(CommandLine, TakesRulesAsListsAndRepeated) {
    const auto overrides =
        check({"--select", "MAC3,jump-into-loop", "--select", "ALL", "--ignore", "MAC301", "/"}).overrides;
    EXPECT_THAT(overrides.select, ElementsAre("MAC3", "jump-into-loop", "ALL"));
    EXPECT_THAT(overrides.ignore, ElementsAre("MAC301"));
}

TEST(CommandLine, KnowsSeverities) {
    EXPECT_EQ(check({}).fail_on, Severity::warning);
    EXPECT_EQ(check({"--fail-on", "never"}).fail_on, std::nullopt);
    EXPECT_EQ(check({"--severity", "MAC501=error"}).overrides.severity.at(0).second, Severity::error);
}

TEST(CommandLine, TakesSizesInBytesOrWithAUnit) {
    const auto size = [](const std::string& word) {
        return check({"--max-file-size", word}).overrides.max_file_size;
    };
    EXPECT_EQ(check({}).overrides.max_file_size, 1U << 30U);
    EXPECT_EQ(size("1"), 1U);
    EXPECT_EQ(size("4096b"), 4096U);
    EXPECT_EQ(size("3KiB"), 3U * 1024);
    EXPECT_EQ(size("500M"), 500U * 1024 * 1024);
    EXPECT_EQ(size("2 GB"), 2U * 1024 * 1024 * 1024);
    EXPECT_EQ(size("4294967294"), 4294967294U);
}

TEST(CommandLine, TellsWhatWasProbablyMeant) {
    EXPECT_THAT(refusal({"--selct", "MAC301"}), HasSubstr("Did you mean '--select'?"));
    EXPECT_THAT(refusal({"--select", "MAC30l"}), HasSubstr("Did you mean 'MAC301'?"));
    EXPECT_THAT(refusal({"--format", "sarf"}), HasSubstr("Did you mean 'sarif'?"));
    EXPECT_THAT(refusal({"--dialect", "fanic"}), HasSubstr("Did you mean 'fanuc'?"));
    EXPECT_THAT(refusal({"--isolated", "--control", "fanuc-16"}), HasSubstr("Did you mean 'fanuc-16i'?"));
    EXPECT_THAT(refusal({"chek"}), HasSubstr("Did you mean 'maclint check'?"));
    EXPECT_THAT(refusal({"--fail-on", "eror"}), HasSubstr("Did you mean 'error'?"));
    EXPECT_THAT(refusal({"--color", "alway"}), HasSubstr("Did you mean 'always'?"));
}

TEST(CommandLine, RefusesWhatItCannotUse) {
    for (const char* size : {"0", "M", "1T", "1.5G", "-1", "4G", "4294967295", "1 MBB",
                             "99999999999999999999", "18014398509481984K", "1 0"})
        EXPECT_THAT(refusal({"--max-file-size", size}),
                    HasSubstr("--max-file-size does not take '" + std::string(size) + "'. Give a size"))
            << size;
    EXPECT_THAT(refusal({"--jobs", "0"}), HasSubstr("whole number from 1"));
    EXPECT_THAT(refusal({"--jobs", "two"}), HasSubstr("whole number"));
    EXPECT_THAT(refusal({"--max-findings", "-1"}), HasSubstr("whole number"));
    EXPECT_THAT(refusal({"--output", "sarif"}), HasSubstr("FORMAT:FILE"));
    EXPECT_THAT(refusal({"--output", "sarif:a", "--output", "json:a"}), HasSubstr("'a' twice"));
    EXPECT_THAT(refusal({"--severity", "MAC501"}), HasSubstr("RULE=LEVEL"));
    EXPECT_THAT(refusal({"--isolated", "--config", "x"}), HasSubstr("exclude each other"));
    EXPECT_THAT(refusal({"--format", "text", "--output", "json:-"}), HasSubstr("standard output"));
    EXPECT_THAT(refusal({"explain"}), HasSubstr("needs a rule"));
    EXPECT_THAT(refusal({"explain", "MAC301", "MAC303"}), HasSubstr("one word too many"));
    EXPECT_THAT(refusal({"help", "MAC301"}), HasSubstr("maclint explain MAC301"));
    EXPECT_THAT(refusal({"help", "rulse"}), HasSubstr("Did you mean 'rules'?"));
    EXPECT_THAT(refusal({"help", "rules", "check"}), HasSubstr("one word too many"));
}

/// Options with a value, by command; the command's own description knows them all.
std::vector<std::pair<std::string, std::string>> options_with_values() {
    std::vector<std::pair<std::string, std::string>> all;
    for (const CommandText& command : command_list())
        for (const OptionText& option : command.options)
            if (!option.value.empty() && !option.names.empty())
                all.emplace_back(command.name, option.names.front());
    return all;
}

TEST(CommandLine, RefusesEmptyValuesOfAllOptions) {
    const auto all = options_with_values();
    EXPECT_GE(all.size(), 18U);
    for (const auto& [command, option] : all)
        for (const std::vector<std::string>& words : {std::vector<std::string>{command, option + "="},
                                                      {command, option + "=", "/"},
                                                      {command, option, ""}})
            EXPECT_EQ(refusal(words),
                      option + " has an empty value, as from a variable that nobody has set. Write "
                               "one, or leave the option out.")
                << command;
    EXPECT_THAT(refusal({"--quiet="}), HasSubstr("--quiet takes no value"));
    EXPECT_THAT(refusal({"--sinse=", "/"}), HasSubstr("Did you mean '--since'?"));
    for (const char* option : {"--select", "--ignore", "--severity"})
        EXPECT_THAT(refusal({option, ",,"}),
                    HasSubstr(std::string(option) + " has no word between its commas"));
    EXPECT_THAT(check({"--", "--since=", ""}).paths, ElementsAre("--since=", ""));
}

TEST(CommandLine, ShowsHelpAndVersion) {
    const auto text = [](std::vector<std::string> arguments) {
        return std::get<PrintRequest>(read_command_line(std::move(arguments))).text;
    };
    EXPECT_THAT(text({"--version"}), HasSubstr("maclint " MACLINT_VERSION));
    EXPECT_THAT(text({"--help"}), HasSubstr("--stdin-filename"));
    EXPECT_THAT(text({"check", "--help"}), HasSubstr("--max-findings"));
    EXPECT_THAT(text({"rules", "--help"}), HasSubstr("--write-docs"));
    EXPECT_EQ(text({"help", "rules"}), text({"rules", "--help"}));
    EXPECT_EQ(text({"help", "explain"}), text({"explain", "-h"}));
    EXPECT_EQ(text({"help"}), text({"--help"}));
    for (const auto& words : std::vector<std::vector<std::string>>{
             {"version"}, {"-V"}, {"-q", "--version"}, {"rules", "-V"}, {"explain", "--version"}})
        EXPECT_EQ(text(words), "maclint " MACLINT_VERSION "\n") << words.front();
}

} // namespace
} // namespace maclint::cli
