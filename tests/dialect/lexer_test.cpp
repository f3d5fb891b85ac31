//! Which bytes are comments, texts and names in each language, and what the parse cache looks at.
#include "analyzer/dialect/dinplus/lexer.hpp"
#include "analyzer/dialect/fanuc/lexer.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using ::testing::ElementsAre;

template<class Token>
std::vector<std::string> texts(std::string_view block, const std::vector<Token>& tokens) {
    std::vector<std::string> out;
    for (const Token& token : tokens) out.emplace_back(block.substr(token.span.begin, token.span.length()));
    return out;
}

std::vector<std::string> fanuc_tokens(std::string_view block) {
    return texts(block, fanuc::tokens_of(block, {0, static_cast<Offset>(block.size())}));
}

std::vector<std::string> din_tokens(std::string_view block) {
    return texts(block, dinplus::tokens_of(block, {0, static_cast<Offset>(block.size())}));
}

fanuc::Token::Kind first_fanuc_kind(std::string_view block) {
    return fanuc::tokens_of(block, {0, static_cast<Offset>(block.size())}).at(0).kind;
}

dinplus::Token::Kind first_din_kind(std::string_view block) {
    dinplus::Lexer lexer(block, {0, static_cast<Offset>(block.size())});
    return lexer.next().value().kind;
}

std::string fanuc_key(std::string_view block) {
    std::string key;
    fanuc::make_cache_key(block, key);
    return key;
}

TEST(FanucLexer, TokensAreWhatABlockIsMadeOf) {
    EXPECT_THAT(fanuc_tokens("IF[#1GE # 20.5]GOTO3(A [B)X"),
                ElementsAre("IF", "[", "#1", "GE", "# 20", ".5", "]", "GOTO", "3", "(A [B)", "X"));
    EXPECT_THAT(fanuc_tokens("#1<=#2,R!=<>"), ElementsAre("#1", "<=", "#2", ",", "R", "!=", "<>"));
}

TEST(FanucLexer, ABracketInANameOfOtherControlsOpensNoComment) {
    EXPECT_THAT(fanuc_tokens("#<_a(b>=1(c)"), ElementsAre("#<_a(b>", "=", "1", "(c)"));
    EXPECT_EQ(first_fanuc_kind("#<_a(b>=1"), fanuc::Token::Kind::foreign_name);
    EXPECT_THAT(fanuc_tokens("#<a(b"), ElementsAre("#", "<", "a", "(b")); // nothing closes it
}

TEST(FanucLexer, AProgramNameStandsOnlyAtTheHeadOfABlock) {
    EXPECT_THAT(fanuc_tokens("(TITLE)<PART 1>"), ElementsAre("(TITLE)", "<PART 1>"));
    EXPECT_THAT(fanuc_tokens("G1;<PART 1>"), ElementsAre("G", "1", ";", "<PART 1>"));
    EXPECT_THAT(fanuc_tokens("X<A>"), ElementsAre("X", "<", "A", ">"));
    EXPECT_THAT(fanuc_tokens("<A(B>"), ElementsAre("<", "A", "(B>")); // no letter of a name
}

TEST(FanucLexer, ACommentIsClosedOrEndsWithItsLine) {
    EXPECT_EQ(fanuc::after_comment("(A)B", 0), 3U);
    EXPECT_EQ(fanuc::after_comment("(A\rB)", 0), 2U);
    EXPECT_EQ(fanuc::after_comment("(A\nB)", 0), 2U);
    EXPECT_EQ(fanuc::after_comment("(", 0), 1U);
    EXPECT_TRUE(fanuc::is_closed("()"));
    EXPECT_FALSE(fanuc::is_closed("(A"));
    EXPECT_FALSE(fanuc::is_closed(")"));
}

TEST(FanucLexer, DigitsAndCommentsAreEqualInTheCacheKey) {
    EXPECT_EQ(fanuc_key("N15 G1 X-2.5 #12=3 (note 7)"), "N00 G0 X-0.0 #00=0 (------)");
    EXPECT_EQ(fanuc_key("(open 7"), "(------");
    EXPECT_EQ(fanuc_key("/2 N10"), "/2 N00"); // a skip level is one of 1 to 9
    EXPECT_EQ(fanuc_key("#<a(b>=5"), "#<a(b>=0");
}

TEST(DinLexer, TokensAreWhatALineIsMadeOf) {
    EXPECT_THAT(din_tokens("N5 G1 X-2.5 ID\"a 1\" [a \" b] L\"c"),
                ElementsAre("N", "5", "G", "1", "X", "-", "2.5", "ID", "\"a 1\"", "[a \" b]", "L", "\"c"));
    EXPECT_THAT(din_tokens("#l1=(_a+#_b)"), ElementsAre("#l1", "=", "(", "_a", "+", "#_b", ")"));
}

TEST(DinLexer, CurlyQuotesHoldATextWhenTheyAreClosed) {
    EXPECT_THAT(din_tokens("L\xE2\x80\x9E"
                           "a [b\xE2\x80\x9C V1"),
                ElementsAre("L",
                            "\xE2\x80\x9E"
                            "a [b\xE2\x80\x9C",
                            "V", "1"));
    EXPECT_THAT(din_tokens("\xE2\x80\x9E"
                           "a [b]"),
                ElementsAre("\xE2\x80\x9E", "a", "[b]"));
}

TEST(DinLexer, QuotesMeanNothingInAnEntryOfTheProgramHead) {
    EXPECT_THAT(din_tokens("#DRAWING 5\" [inches]"), ElementsAre("#DRAWING 5\"", "[inches]"));
    EXPECT_EQ(first_din_kind("#DRAWING 5\""), dinplus::Token::Kind::header);
    EXPECT_EQ(first_din_kind("#G20=1"), dinplus::Token::Kind::variable);
    EXPECT_THAT(din_tokens("[a] #DRAWING \"[b]\""), ElementsAre("[a]", "#DRAWING \"", "[b]", "\""));
}

TEST(DinLexer, CommentsOfOtherLanguagesHoldNoCode) {
    EXPECT_THAT(din_tokens("N1 G0 ; X5\" [a] M3"), ElementsAre("N", "1", "G", "0", "[a]", "M", "3"));
    EXPECT_THAT(din_tokens("N1 // X5\""), ElementsAre("N", "1"));
    EXPECT_EQ(first_din_kind("// a"), dinplus::Token::Kind::foreign_comment);
    EXPECT_EQ(first_din_kind("/1 G0"), dinplus::Token::Kind::sign);
}

} // namespace
} // namespace maclint
