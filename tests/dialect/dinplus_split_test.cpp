//! Where DIN PLUS blocks begin and end, and what a comment takes with it.
#include "analyzer/dialect/dinplus/lexer.hpp"
#include "analyzer/dialect/dinplus/split.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::dinplus {
namespace {

using ::testing::ElementsAre;

/// The blocks of a text, empty lines left out.
std::vector<std::string> blocks_of(std::string_view text) {
    std::vector<std::string> blocks;
    RawBlock block{};
    for (Offset at = 0; at < text.size(); at = block.next) {
        cut_block(text, at, block);
        if (!block.span.empty()) blocks.emplace_back(text.substr(block.span.begin, block.span.length()));
    }
    return blocks;
}

std::string cache_key(std::string_view block) {
    std::string key;
    make_cache_key(block, key);
    return key;
}

TEST(DinSplitter, EveryLineEndEndsABlock) {
    EXPECT_THAT(blocks_of("N1 G0\nN2 G1\r\n\r\n\tN3 G2 \rN4"), ElementsAre("N1 G0", "N2 G1", "N3 G2", "N4"));
    EXPECT_THAT(blocks_of("\xEF\xBB\xBF%a.nc\nEND\x1A"), ElementsAre("%a.nc", "END"));
}

TEST(DinSplitter, ACommentMaySpanLines) {
    EXPECT_THAT(blocks_of("N1 G0 [over\ntwo lines] X5\nN2 G1"),
                ElementsAre("N1 G0 [over\ntwo lines] X5", "N2 G1"));
}

TEST(DinSplitter, BlocksInAClosedCommentAreComment) {
    EXPECT_THAT(blocks_of("[old:\nN1 G0\nN2 G1]\nN3 G2"), ElementsAre("[old:\nN1 G0\nN2 G1]", "N3 G2"));
}

TEST(DinSplitter, TextsBindTighterThanComments) {
    EXPECT_THAT(blocks_of("PRINT(\"a [ b\")\nN2 G1\nPRINT(\"]\")"),
                ElementsAre("PRINT(\"a [ b\")", "N2 G1", "PRINT(\"]\")"));
    EXPECT_THAT(blocks_of("PRINT(\"a [ b\nN2 G1"), ElementsAre("PRINT(\"a [ b", "N2 G1"));
}

TEST(DinSplitter, AQuoteInAHeaderEntryOrForeignCommentIsNoText) {
    EXPECT_THAT(blocks_of("#DRAWING 5\" [inches\nwide]\nN1"),
                ElementsAre("#DRAWING 5\" [inches\nwide]", "N1"));
    EXPECT_THAT(blocks_of("N1 ; 5\" [a\nb]\nN2"), ElementsAre("N1 ; 5\" [a\nb]", "N2"));
}

TEST(DinSplitter, AnUnclosedCommentEndsWhereBlocksBeginAgain) {
    EXPECT_THAT(blocks_of("N1 M8 [coolant\nand air\nN2 G1\nN3"),
                ElementsAre("N1 M8 [coolant\nand air", "N2 G1", "N3"));
    EXPECT_THAT(blocks_of("[tools\nBLANK\nN1 G20"), ElementsAre("[tools", "BLANK", "N1 G20"));
    EXPECT_THAT(blocks_of("N1 [to the end\nof the file\n\n"), ElementsAre("N1 [to the end\nof the file"));
}

TEST(DinSplitter, TheCloseOfALaterCommentDoesNotCloseItEither) {
    EXPECT_THAT(blocks_of("N1 M8 [coolant\nN2 G1\nN3 M9 [off]"),
                ElementsAre("N1 M8 [coolant", "N2 G1", "N3 M9 [off]"));
}

TEST(DinSplitter, CommentsAndCodeAreCounted) {
    RawBlock block{};
    cut_block("[a] G0 X \"b c\" [d", 0, block);
    EXPECT_THAT(block.comments, ElementsAre(Span{0, 3}, Span{15, 17}));
    EXPECT_TRUE(block.open_comment);
    EXPECT_EQ(block.code, 8U); // G0 X "b c"
    cut_block("[only]", 0, block);
    EXPECT_FALSE(block.open_comment);
    EXPECT_EQ(block.code, 0U);
}

TEST(DinSplitter, BlocksAreKnownByNumberOrSectionWord) {
    EXPECT_TRUE(begins_block("N 10 G1", 0));
    EXPECT_TRUE(begins_block("$1 /2 N10 G1", 0));
    EXPECT_TRUE(begins_block("BEARBEITUNG", 0));
    EXPECT_FALSE(begins_block("N10", 0)); // a number alone may be prose
    EXPECT_FALSE(begins_block("Now the coolant", 0));
    EXPECT_FALSE(begins_block("End of the roughing", 0));
    EXPECT_FALSE(begins_block("KONEISTUS", 0)); // no word of a control: prose of a Finnish author
}

TEST(DinLexer, DigitsTextsAndCommentsAreEqualInTheCacheKey) {
    EXPECT_EQ(cache_key("N15 G1 X-2.5 ID\"a1\" [note 7]"), "N00 G0 X-0.0 ID\"--\" [------]");
    EXPECT_EQ(cache_key("[//]"), "[//]"); // a token of its own
    EXPECT_EQ(cache_key("PRINT(\"open"), "PRINT(\"----");
    EXPECT_EQ(cache_key("#l12=#_a1"), "#l00=#_a0");
}

} // namespace
} // namespace maclint::dinplus
