//! Wrong blocks, and the cause that is told for each.
#include "tests/dialect/reading.hpp"

#include <fstream>
#include <optional>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using ::testing::HasSubstr;
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

} // namespace
} // namespace maclint
