//! The help of a command, as our own formatter writes it, whatever version of CLI11 declares the options.
#include "cli/options/help.hpp"

#include <string>

#include <CLI/CLI.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

std::string help_with_own_group(const std::string& group) {
    CLI::App app("Looks at files.");
    bool all = false;
    std::string file;
    app.get_help_ptr()->group(group);
    app.add_flag("--all", all, "All of them.")->group("What is looked at");
    app.add_flag("--brief", all, "In a line.")->group(group);
    app.add_option("FILE", file, "The file.");
    return help_of(app, "maclint look FILE", {}, 80);
}

TEST(HelpText, PutsTheOptionsOfNoGroupLastUnderOneName) {
    const std::string help = help_with_own_group("Options");
    EXPECT_THAT(help, testing::ContainsRegex("--all[^:]*Options:\n.*--help"));
    EXPECT_THAT(help, testing::Not(testing::ContainsRegex("Options:(.|\n)*Options:")));
}

TEST(HelpText, IsTheSameWhateverTheLibraryCallsThatGroup) {
    EXPECT_EQ(help_with_own_group("options"), help_with_own_group("Options")); // 2.5, 2.1
}

} // namespace
} // namespace maclint::cli
