//! Small programs that bring an alarm: each is found, with the number that its control shows.
#include "tests/support/folder.hpp"
#include "tests/support/linted.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::IsEmpty;

/// "== fanuc-16i 125 114: why", then the files of the folder, each below its "-- NAME".
struct Provocation {
    std::string name;                 ///< the line at its head, without "== "
    std::string control;              ///< "fanuc-16i"
    std::vector<std::string> numbers; ///< any of them will do
    std::vector<LintedText> files;
};

std::string fixture(const std::string& name) {
    return read_file(std::string(MACLINT_SOURCE_DIR) + "/tests/fixtures/alarms/" + name);
}

std::string without_zeros(std::string number) {
    number.erase(0, std::min(number.find_first_not_of('0'), number.size() - 1));
    return number;
}

Provocation headed_by(const std::string& head) {
    Provocation made{.name = head, .control = {}, .numbers = {}, .files = {}};
    std::istringstream words(head.substr(0, head.find(": ")));
    words >> made.control;
    for (std::string number; words >> number;) made.numbers.push_back(without_zeros(number));
    return made;
}

/// The line as the program has it: " <<" shows a reader where the fault is, " <?" where it may be told as
/// well.
std::string without_mark(std::string line) {
    if (line.ends_with(" <<") || line.ends_with(" <?")) line.resize(line.size() - 3);
    return line + "\n";
}

std::vector<Provocation> provocations_in(const std::string& file) {
    std::vector<Provocation> all;
    std::istringstream lines(fixture(file));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("== "))
            all.push_back(headed_by(line.substr(3)));
        else if (line.starts_with("-- "))
            all.back().files.push_back({line.substr(3), ""});
        else
            all.back().files.back().text += without_mark(line);
    }
    return all;
}

/// Numbers behind "alarm " in the messages.
std::set<std::string> numbers_told(const Provocation& provocation) {
    cli::Overrides overrides;
    overrides.control = provocation.control;
    std::set<std::string> numbers;
    for (const auto& [finding, suppressed] : lint_texts(provocation.files, overrides).findings) {
        const std::string message = finding.message();
        constexpr std::string_view word = "alarm ";
        for (auto at = message.find(word); at != std::string::npos; at = message.find(word, at + 1)) {
            const auto begin = at + word.size();
            const auto end = std::min(message.find_first_not_of("0123456789", begin), message.size());
            if (end != begin) numbers.insert(without_zeros(message.substr(begin, end - begin)));
        }
    }
    return numbers;
}

bool is_raised(const Provocation& provocation) {
    const auto told = numbers_told(provocation);
    return std::ranges::any_of(provocation.numbers, [&](const std::string& n) { return told.contains(n); });
}

/// Heads of those that nothing raises yet, each with a reason behind " | ".
std::set<std::string> not_raised() {
    std::set<std::string> heads;
    std::istringstream lines(fixture("not-raised.md"));
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("- ")) continue;
        const auto reason = line.find(" | ");
        EXPECT_NE(reason, std::string::npos) << "a reason is missing: " << line;
        EXPECT_TRUE(heads.insert(line.substr(2, reason - 2)).second) << "it stands there twice: " << line;
    }
    return heads;
}

std::vector<std::string> fixture_files() {
    std::vector<std::string> files;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(MACLINT_SOURCE_DIR) + "/tests/fixtures/alarms"))
        if (entry.path().extension() == ".txt") files.push_back(entry.path().filename().string());
    std::ranges::sort(files);
    return files;
}

class AlarmPrograms : public testing::TestWithParam<std::string> {};

TEST_P(AlarmPrograms, AreFoundWithTheNumberOfTheirControl) {
    const std::set<std::string> excused = not_raised();
    std::string missed, found; // lines that not-raised.md wants, and those that it has too many
    for (const Provocation& provocation : provocations_in(GetParam())) {
        const bool is_excused = excused.contains(provocation.name);
        if (is_raised(provocation)) {
            if (is_excused) found += "- " + provocation.name + "\n";
        } else if (!is_excused) {
            missed += "- " + provocation.name + "\n";
        }
    }
    EXPECT_THAT(missed, IsEmpty()) << "mend the rule, or say in not-raised.md why";
    EXPECT_THAT(found, IsEmpty()) << "take these out of not-raised.md";
}

INSTANTIATE_TEST_SUITE_P(Fixtures, AlarmPrograms, testing::ValuesIn(fixture_files()),
                         [](const auto& instance) {
                             std::string name = instance.param.substr(0, instance.param.find('.'));
                             std::erase(name, '-');
                             return name;
                         });

TEST(AlarmPrograms, HaveHeadsThatTellThemApart) {
    std::set<std::string> heads;
    for (const std::string& file : fixture_files())
        for (const Provocation& provocation : provocations_in(file)) {
            EXPECT_TRUE(heads.insert(provocation.name).second) << provocation.name;
            EXPECT_FALSE(provocation.files.empty()) << provocation.name;
        }
    for (const std::string& head : not_raised())
        EXPECT_TRUE(heads.contains(head)) << "no program is headed '" << head << "'";
}

} // namespace
} // namespace maclint::test
