//! Every program in corpus/ raises exactly the findings that its (EXPECT …) comments name on their lines.
#include "analyzer/program/model.hpp"
#include "cli/engine/engine.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;

/// "O9303.nc:12 MAC303".
using Lines = std::vector<std::string>;

fs::path corpus() { return fs::path(MACLINT_SOURCE_DIR) / "corpus"; }

std::vector<std::string> top_folders() {
    std::vector<std::string> folders;
    if (!fs::exists(corpus())) return folders;
    for (const auto& entry : fs::directory_iterator(corpus()))
        if (entry.is_directory()) folders.push_back(entry.path().filename().string());
    std::ranges::sort(folders);
    return folders;
}

std::string place(const Source& source, std::uint32_t line, std::string_view code) {
    const std::string name = fs::path(source.path()).lexically_relative(corpus()).generic_string();
    return name + ":" + std::to_string(line) + " " + std::string(code);
}

/// Adds what the comments of one kind on a line expect for the line `target`.
void add_expected(const Source& source, std::string_view line, std::string_view word, std::uint32_t target,
                  Lines& expected) {
    for (auto at = line.find(word); at != std::string_view::npos; at = line.find(word, at + 1)) {
        auto rest = line.substr(at + word.size());
        rest = rest.substr(0, rest.find_first_of(")]"));
        while (!rest.empty()) {
            const auto code = rest.substr(0, rest.find(' '));
            if (!code.empty()) expected.push_back(place(source, target, code));
            rest.remove_prefix(std::min(code.size() + 1, rest.size()));
        }
    }
}

Lines expected_in(const Source& source) {
    Lines expected;
    for (std::uint32_t line = 1; line <= source.line_count(); ++line) {
        add_expected(source, source.line_text(line), "EXPECT ", line, expected);
        add_expected(source, source.line_text(line), "EXPECT-NEXT ", line + 1, expected);
    }
    return expected;
}

class Corpus : public testing::TestWithParam<std::string> {};

TEST_P(Corpus, RaisesWhatItsCommentsExpectAndNothingElse) {
    cli::Settings settings({});
    cli::Progress progress(cli::Progress::Shown::never);
    auto found = cli::discover({(corpus() / GetParam()).string()}, "stdin.nc", settings);
    const auto snapshot = cli::snapshot_of(std::move(found.files), settings);
    const auto result = cli::Engine({.jobs = 2}, progress).analyse(snapshot);
    ASSERT_THAT(result.notices, testing::IsEmpty()) << result.notices.front().message;
    ASSERT_EQ(result.sources.size(), snapshot.files.size());
    Lines expected;
    for (const auto& source : result.sources) {
        const Lines own = expected_in(*source);
        expected.insert(expected.end(), own.begin(), own.end());
    }
    Lines raised;
    std::map<std::string, std::string> messages;
    for (const auto& [finding, suppressed] : result.findings) {
        if (suppressed) continue;
        const Source& source = *finding.source;
        raised.push_back(place(source, source.position(finding.span.begin).line, finding.rule->code));
        messages[raised.back()] = finding.message();
    }
    std::ranges::sort(expected);
    std::ranges::sort(raised);
    Lines missing;
    Lines unexpected;
    std::ranges::set_difference(expected, raised, std::back_inserter(missing));
    std::ranges::set_difference(raised, expected, std::back_inserter(unexpected));
    for (std::string& line : unexpected) line += ": " + messages[line];
    EXPECT_THAT(missing, testing::IsEmpty());
    EXPECT_THAT(unexpected, testing::IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(All, Corpus, testing::ValuesIn(top_folders()),
                         [](const auto& info) { return info.param; });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Corpus);

} // namespace
} // namespace maclint::test
