//! Wrong blocks, and the cause that is told for each.
#include "analyzer/dialect/fanuc/diagnose.hpp"
#include "analyzer/dialect/fanuc/split.hpp"
#include "tests/dialect/reading.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::lower;

std::optional<Irregular> cause_of_rule(std::string_view rule) {
    static constexpr std::pair<std::string_view, Irregular> causes[] = {
        {"MAC102", Irregular::unterminated_comment}, {"MAC116", Irregular::parenthesis_as_bracket},
        {"MAC117", Irregular::bracket_mismatch},     {"MAC118", Irregular::unknown_keyword},
        {"MAC119", Irregular::symbolic_comparison},  {"MAC401", Irregular::call_without_program},
        {"MAC701", Irregular::bracket_depth},        {"MAC311", Irregular::loop_without_do},
    };
    for (const auto& [code, cause] : causes)
        if (code == rule) return cause;
    return std::nullopt;
}

TEST(Irregularities, WrongBlocksOfTheGrammarAreToldTheirCause) {
    std::ifstream file(MACLINT_SOURCE_DIR "/grammar/fanuc/test/wrong-blocks.txt");
    ASSERT_TRUE(file);
    for (std::string line; std::getline(file, line);) {
        const std::size_t tab = line.find('\t');
        if (tab == std::string::npos) continue;
        const std::optional<Irregular> wanted = cause_of_rule(line.substr(tab + 1));
        if (!wanted) continue;
        std::set<Irregular> found;
        for (const Irregularity& irregularity : testing::read(line.substr(0, tab)).irregularities)
            found.insert(irregularity.kind);
        EXPECT_TRUE(found.contains(*wanted)) << line << '\n' << lower(line.substr(0, tab));
        EXPECT_FALSE(found.contains(Irregular::unreadable) && found.size() > 1) << "told twice: " << line;
    }
}

/// Every block of the files below the folder that is read without complaint has no cause of an error in it:
/// inside noise the cause is looked for first.
void expect_no_cause_in_good_blocks(const std::filesystem::path& folder) {
    std::set<std::string> seen;
    fanuc::RawBlock block;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string text((std::istreambuf_iterator<char>(file)), {});
        for (Offset at = 0; at < text.size(); at = std::max(block.next, at + 1)) {
            fanuc::cut_block(text, at, block);
            const std::string code = text.substr(block.span.begin, block.span.length());
            if (code.empty() || !seen.insert(code).second) continue;
            if (!testing::read(code).irregularities.empty()) continue;
            const auto cause = fanuc::find_cause(code, {0, static_cast<Offset>(code.size())});
            EXPECT_FALSE(cause) << entry.path() << ": " << code << "\n"
                                << cause->subject << ": " << cause->cure;
        }
    }
}

TEST(Irregularities, NoCauseIsToldOfAGoodBlock) {
    expect_no_cause_in_good_blocks(MACLINT_SOURCE_DIR "/corpus/fanuc");
    const auto outer = std::filesystem::path(MACLINT_SHARED) / "corpus" / "fanuc-macro";
    if (std::filesystem::is_directory(outer)) expect_no_cause_in_good_blocks(outer);
}

} // namespace
} // namespace maclint
