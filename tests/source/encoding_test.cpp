//! Encodings: what counts as UTF-8, what other bytes become, and what never reaches a terminal raw.
#include "analyzer/source/encoding.hpp"

#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace maclint {
namespace {

TEST(DetectEncoding, TakesAsciiForUtf8) { EXPECT_EQ(detect_encoding("G0 X0 Y0"), Encoding::utf8); }

TEST(DetectEncoding, AcceptsWellFormedSequencesOfEveryLength) {
    EXPECT_EQ(detect_encoding("12345678 Ø € \U0001F527 12345678"), Encoding::utf8);
}

TEST(DetectEncoding, RefusesOverlongFormsSurrogatesAndCutSequences) {
    const std::vector<std::string_view> broken = {
        "\xC0\x80",
        "\xE0\x80\x80",
        "\xED\xA0\x80",
        "\xF0\x80\x80\x80",
        "\xF4\x90\x80\x80",
        "\xF5\x80\x80\x80",
        "\x80",
        "\xE2\x82",
        "\xC3",
        "\xC3(",
        "\xFF",
    };
    for (const std::string_view bytes : broken) EXPECT_EQ(detect_encoding(bytes), Encoding::windows_1252);
}

TEST(DetectEncoding, FindsABrokenByteAfterLongAscii) {
    EXPECT_EQ(detect_encoding(std::string(1001, 'X') + '\xD8'), Encoding::windows_1252);
}

TEST(ToUtf8, ReadsLatin1Umlauts) { EXPECT_EQ(to_utf8("(K\xFChlung)", Encoding::windows_1252), "(Kühlung)"); }

TEST(ToUtf8, ReadsTheBytesThatWindowsAdds) {
    EXPECT_EQ(to_utf8("\x80 \x84 \x96", Encoding::windows_1252), "€ „ –");
}

TEST(ToUtf8, TurnsShiftJisIntoSomethingValid) {
    const std::string_view drilling = "(\x8C\x8A\x96\xBE\x82\xAF)"; // 穴明け
    EXPECT_EQ(detect_encoding(drilling), Encoding::windows_1252);
    EXPECT_EQ(to_utf8(drilling, Encoding::windows_1252), "(ŒŠ–¾‚¯)");
}

TEST(ToUtf8, ReplacesASequenceThatASliceCut) {
    const std::string_view text = "Ø8";
    EXPECT_EQ(to_utf8(text.substr(1), Encoding::utf8), "\uFFFD8");
    EXPECT_EQ(to_utf8(text.substr(0, 1), Encoding::utf8), "\uFFFD");
}

TEST(ToUtf8, NeverGivesInvalidUtf8WhateverTheBytes) {
    std::mt19937 random(1);
    for (int round = 0; round < 2000; ++round) {
        std::string bytes;
        for (std::size_t length = random() % 24; length > 0; --length)
            bytes.push_back(static_cast<char>(random()));
        for (const Encoding encoding : {Encoding::utf8, Encoding::windows_1252}) {
            EXPECT_EQ(detect_encoding(to_utf8(bytes, encoding)), Encoding::utf8);
        }
        EXPECT_EQ(detect_encoding(printable(bytes)), Encoding::utf8);
    }
}

TEST(Utf16Length, CountsCodeUnits) {
    EXPECT_EQ(utf16_length("aØ€", Encoding::utf8), 3U);
    EXPECT_EQ(utf16_length("\U0001F527", Encoding::utf8), 2U);
    EXPECT_EQ(utf16_length("\xD8", Encoding::windows_1252), 1U);
}

TEST(Printable, LeavesTextAndTabsAlone) {
    EXPECT_EQ(printable("G0\tX1 (Ø8 穴 \U0001F527)"), "G0\tX1 (Ø8 穴 \U0001F527)");
}

TEST(Printable, EscapesTerminalControlSequences) {
    EXPECT_EQ(printable("(\x1B[2J\x07)"), "(\\x1B[2J\\x07)");
    EXPECT_EQ(printable("\x7F"), "\\x7F");
}

TEST(Printable, EscapesC1Controls) { EXPECT_EQ(printable("\u009B2J"), "\\x9B2J"); }

TEST(Printable, EscapesLineEndsSoThatNoLineCanBeForged) { EXPECT_EQ(printable("a\r\nb"), "a\\r\\nb"); }

TEST(Printable, EscapesBidirectionalControls) {
    EXPECT_EQ(printable("\u202EM30\u2069"), "\\u{202E}M30\\u{2069}");
}

TEST(Printable, EscapesNoncharacters) {
    EXPECT_EQ(printable("\uFFFD \uFFFE \uFFFF \uFDD0 \uFDEF \uFDF0"),
              "\uFFFD \\u{FFFE} \\u{FFFF} \\u{FDD0} \\u{FDEF} \uFDF0");
    EXPECT_EQ(printable("\U0001FFFD \U0001FFFE \U0010FFFF"), "\U0001FFFD \\u{1FFFE} \\u{10FFFF}");
}

TEST(Printable, EscapesInvisibleTags) { EXPECT_EQ(printable("\U000E0041"), "\\u{E0041}"); }

TEST(Printable, EscapesNul) { EXPECT_EQ(printable(std::string_view("\0", 1)), "\\x00"); }

TEST(Printable, ReplacesInvalidUtf8) { EXPECT_EQ(printable("a\xD8z"), "a\uFFFDz"); }

/// A byte that is no UTF-8 is shown as one character, and so it is one in columns, too.
TEST(Columns, CountBrokenBytesAsTheyAreShown) {
    for (const std::string_view text : {"\xF0 X", "\x9F\x9F X", "\xE2\x82 X", "\xF0\x9F\x98\x80 X",
                                        "\xC3\xBC X", "\xC3\xBC\xBC\xBC\xBC\xBC X"}) {
        EXPECT_EQ(utf16_length(text, Encoding::utf8),
                  utf16_length(to_utf8(text, Encoding::utf8), Encoding::utf8));
        for (std::size_t at = 0; at < text.size(); ++at) {
            const std::size_t begin = character_begin(text, at, Encoding::utf8);
            EXPECT_LE(begin, at);
            EXPECT_EQ(to_utf8(text.substr(0, begin), Encoding::utf8) +
                          to_utf8(text.substr(begin), Encoding::utf8),
                      to_utf8(text, Encoding::utf8))
                << "no character is cut in two";
        }
    }
    EXPECT_EQ(utf16_length("\xF0 X", Encoding::utf8), 3U);
    EXPECT_EQ(utf16_length("\x9F\x9F X", Encoding::utf8), 4U);
    EXPECT_EQ(character_begin("\xC3\xBC\xBC", 2, Encoding::utf8), 2U) << "the letter ends before it";
}

} // namespace
} // namespace maclint
