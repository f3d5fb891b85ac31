//! What the run says where the analysis has met a bound.
#include "tests/support/linted.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::vector<std::string> notices_on(const std::vector<test::LintedText>& texts) {
    std::vector<std::string> said;
    for (const cli::Notice& notice : test::lint_texts(texts, {}).notices)
        said.push_back(notice.path + ": " + notice.message);
    return said;
}

/// So many blocks of which each may jump to any.
std::string computed_jumps(int count) {
    std::string text = "O1\n";
    for (int i = 1; i <= count; ++i) text += "N" + std::to_string(i) + "GOTO#500\n";
    return text + "M30\n";
}

/// One of the two tests of #501 sets #5 on every path, which only a search past all blocks in between shows.
std::string contradiction_around(const std::string& blocks) {
    return "O1\nIF[#501EQ1]GOTO20\n#5=1\nN20\n" + blocks + "IF[#501NE1]GOTO21\n#5=2\nN21 G0Z#5\nN30M30\n";
}

std::string contradiction_over(int blocks) {
    std::string text;
    for (int i = 0; i < blocks; ++i) text += "#100=#100+1\n";
    return contradiction_around(text);
}

/// So many blocks that each compare #502 with a hundred other numbers.
std::string ors(int blocks) {
    std::string text;
    for (int i = 0; i < blocks; ++i) {
        text += "IF[[#502EQ" + std::to_string(100 * i);
        for (int k = 1; k < 100; ++k) text += "]OR[#502EQ" + std::to_string(100 * i + k);
        text += "]]GOTO30\n";
    }
    return text;
}

TEST(Bounds, AreSaidOnceForAllFiles) {
    EXPECT_THAT(notices_on({{"a.nc", computed_jumps(100)}}), IsEmpty());
    EXPECT_THAT(notices_on({{"b.nc", computed_jumps(200)}, {"a.nc", computed_jumps(150)}}),
                ElementsAre("a.nc: computed jumps or returns are too many to follow one by one in this file "
                            "and 1 other file: each may lead to any label, in the eyes of all rules."));
}

TEST(Bounds, OfSearchesNameTheRulesThatTheyTouch) {
    EXPECT_THAT(notices_on({{"a.nc", contradiction_over(2)}}), IsEmpty());
    EXPECT_THAT(notices_on({{"a.nc", contradiction_over(3000)}}),
                ElementsAre("a.nc: a search was given up in this file: findings of MAC209 count "
                            "for less there, or are missing."));
}

TEST(Bounds, OfSearchesAreMetByComparisonsAsWell) {
    EXPECT_THAT(notices_on({{"a.nc", contradiction_around(ors(5))}}), IsEmpty());
    EXPECT_THAT(notices_on({{"a.nc", contradiction_around(ors(50))}}),
                ElementsAre("a.nc: a search was given up in this file: findings of MAC209 count "
                            "for less there, or are missing."));
}

TEST(Bounds, OfSearchesSayNothingWhereTheDefectStandsInTheText) {
    std::string text = "O1\n";
    for (int i = 0; i < 3000; ++i) text += "#100=#100+1\n"; // farther than a search goes
    EXPECT_THAT(notices_on({{"a.nc", text + "GOTO77\nM30\n"}}), IsEmpty());
}

} // namespace
} // namespace maclint
