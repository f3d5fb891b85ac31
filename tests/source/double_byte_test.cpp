//! Shift-JIS and GBK: what their bytes mean, and when they are taken for what they are.
#include "analyzer/source/double_byte.hpp"
#include "analyzer/source/source.hpp"

#include <algorithm>
#include <random>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace maclint {
namespace {

std::string from(Encoding encoding, std::string_view bytes) { return to_utf8(bytes, encoding); }

TEST(DoubleByte, CharactersOfTheFirstAndTheLastRowsAreThoseOfTheirStandard) {
    EXPECT_EQ(from(Encoding::shift_jis, "\x81\x40|\x81\x5B|\x83\x5C|\x95\x5C"), "\u3000|ー|ソ|表");
    EXPECT_EQ(from(Encoding::shift_jis, "\x9F\xFC|\xE0\x40|\xEA\xA4"), "滌|漾|熙");
    EXPECT_EQ(from(Encoding::shift_jis, "\xB1\xDF|\xFC\x4B"), "ｱﾟ|黑");
    EXPECT_EQ(from(Encoding::gbk, "\x81\x40|\xB0\xA1|\xB5\xB6|\xD7\xF9|\xFE\x4F|\x80"),
              "丂|啊|刀|座|\uFA29|€");
    EXPECT_EQ(from(Encoding::gbk, "\xA3\xAD|\xA3\xB5"), "－|５");
}

TEST(DoubleByte, ALeadByteWithoutASecondOneEatsNothing) {
    EXPECT_EQ(from(Encoding::shift_jis, "\x81\n\x81"), "\uFFFD\n\uFFFD");
    EXPECT_EQ(from(Encoding::gbk, "(\x81)\xFF"), "(\uFFFD)\uFFFD");
    EXPECT_EQ(from(Encoding::shift_jis, "\xF0\x40"), "\uFFFD@"); // of no standard
}

TEST(DoubleByte, AnyBytesBecomeValidUtf8WithTheSameLines) {
    std::mt19937 random(11);
    for (int round = 0; round < 200; ++round) {
        std::string noise;
        while (noise.size() < 300) noise.push_back(static_cast<char>(random()));
        for (const Encoding encoding : {Encoding::shift_jis, Encoding::gbk}) {
            const std::string text = from(encoding, noise);
            EXPECT_EQ(detect_encoding(text), Encoding::utf8);
            EXPECT_EQ(std::ranges::count(text, '\n'), std::ranges::count(noise, '\n'));
            EXPECT_EQ(std::ranges::count(text, '\r'), std::ranges::count(noise, '\r'));
        }
    }
}

TEST(DetectDoubleByte, JapaneseIsToldByKanaSignsAndWordsOfKanji) {
    for (const std::string_view text : {"(\x83\x68\x83\x8A\x83\x8B)", "(\x8D\x72\x89\xC1\x8D\x48)",
                                        "G1Z\x81\x5B"
                                        "5.",
                                        "(\x8E\x64\x8F\xE3\x82\xB0)"})
        EXPECT_EQ(detect_double_byte(text), Encoding::shift_jis) << text;
}

TEST(DetectDoubleByte, ChineseIsToldByWordsOfTheWorkshop) {
    for (const std::string_view text :
         {"(\xB4\xD6\xBC\xD3\xB9\xA4)", "(\xBB\xBB\xB5\xB6 T1)", "(\xD7\xEA\xBF\xD7\xB3\xCC\xD0\xF2)"})
        EXPECT_EQ(detect_double_byte(text), Encoding::gbk) << text;
}

TEST(DetectDoubleByte, WhatMayBeAnotherEncodingIsNeither) {
    for (const std::string_view text : {"(FR\xC4SEN GR\xD6\xDF"
                                        "ER F\xDCR)",
                                        "(Fr\xE4sen gr\xF6\xDF"
                                        "er f\xFCr)", // Windows-1252
                                        "(\x93quoted\x94, tool\x92s \x96 end\x85)",
                                        "(\x82"
                                        "Bohrer\x91 50\x80)",
                                        "(F\x9AR FR\x8ESER, GR\x99\xE1"
                                        "E, f\x81r Gr\x94\xE1"
                                        "e)",                                              // CP850
                                        "(\x90tape \x85 c\x93t\x82 pr\x82r\x82gl\x82)",    // CP850, French
                                        "(\xD1\xE2\xE5\xF0\xEB\xEE \xD4\xF0\xE5\xE7\xE0)", // Windows-1251
                                        "(\xB5\xE5\xB8\xB1 \xB0\xA1\xB0\xF8)",             // Korean
                                        "(\xB0 10 \xB5m \xB1"
                                        "0.1)"})
        EXPECT_FALSE(detect_double_byte(text)) << text;
}

TEST(SourceEncoding, TextOfTwoBytesACharacterIsUtf8WithColumnsInCharacters) {
    const std::string bytes = "O1(\x83\x5C\x95\x5C)\nGOTO9(\x83\x5C)X5\n"; // second bytes are backslashes
    const Source source = Source::from_bytes("O1.nc", bytes);
    EXPECT_EQ(source.stored_encoding(), Encoding::shift_jis);
    EXPECT_EQ(source.encoding(), Encoding::utf8);
    EXPECT_EQ(source.line_text(1), "O1(ソ表)");
    EXPECT_EQ(source.stored_bytes(), bytes);
    EXPECT_EQ(source.position(static_cast<Offset>(source.bytes().find("X5"))).column, 9U);
}

TEST(SourceEncoding, WhoeverNamesItKnowsBetter) {
    const std::string bytes = "O1(\x83\x5C\x95\x5C)\n";
    const Source japanese = Source::from_bytes("O1.nc", bytes);
    const Source latin = japanese.read_as(Encoding::windows_1252);
    EXPECT_EQ(latin.bytes(), bytes);
    EXPECT_EQ(latin.read_as(Encoding::gbk).stored_bytes(), bytes);
    EXPECT_EQ(latin.read_as(Encoding::gbk).line_text(1), "O1(僜昞)");
}

} // namespace
} // namespace maclint
