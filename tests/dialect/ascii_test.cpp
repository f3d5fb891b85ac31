//! Words that are near to each other.
#include "analyzer/dialect/ascii.hpp"

#include <algorithm>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace maclint {
namespace {

TEST(EditDistance, CountsEdits) {
    EXPECT_EQ(edit_distance("RETURN", "RETURN", 2), 0U);
    EXPECT_EQ(edit_distance("RETRUN", "RETURN", 2), 1U) << "a swap";
    EXPECT_EQ(edit_distance("RETUN", "RETURN", 2), 1U) << "an insertion";
    EXPECT_EQ(edit_distance("RETYRN", "RETURN", 2), 1U) << "a change";
    EXPECT_EQ(edit_distance("WHLIEE", "WHILE", 2), 2U);
}

TEST(BlockText, IsInCapitalsAndWithoutBlanksButForTexts) {
    EXPECT_EQ(without_blanks("g0 X 1.\t\r\nY2."), "G0X1.Y2.");
    EXPECT_EQ(without_blanks("N1 L\"a b\" v1"), "N1L\"a b\"V1");
}

TEST(EditDistance, EndsAtTheMostThatIsAskedFor) {
    EXPECT_EQ(edit_distance("ABC", "XYZ", 1), 2U);
    EXPECT_EQ(edit_distance("ABC", "ABCDEF", 2), 3U);
    EXPECT_EQ(edit_distance(std::string(17, 'A'), std::string(17, 'A'), 1), 2U) << "too long";
    std::mt19937 random(20261123);
    const auto word = [&] {
        std::string letters;
        for (std::size_t left = random() % 7; left > 0; --left)
            letters += static_cast<char>('A' + random() % 5);
        return letters;
    };
    for (int round = 0; round < 3000; ++round) {
        const std::string a = word();
        const std::string b = word();
        const std::size_t all = edit_distance(a, b, 16);
        ASSERT_LE(all, 6U);
        ASSERT_EQ(all, edit_distance(b, a, 16)) << a << ' ' << b;
        for (const std::size_t most : {0U, 1U, 2U, 3U})
            ASSERT_EQ(edit_distance(a, b, most), std::min(all, most + 1)) << a << ' ' << b;
    }
}

} // namespace
} // namespace maclint
