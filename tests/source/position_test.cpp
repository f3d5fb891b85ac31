//! Lines and columns: every kind of line end, UTF-16 columns, the sparse index against a plain count.
#include "analyzer/source/source.hpp"

#include <algorithm>
#include <ostream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace maclint {

void PrintTo(const Position& position, std::ostream* out) {
    *out << "line " << position.line << ", column " << position.column << ", byte " << position.byte_column;
}

namespace {

Source source_of(std::string bytes) { return Source::from_bytes("O1.nc", std::move(bytes)); }

std::vector<std::string> lines_of(const Source& source) {
    std::vector<std::string> lines;
    for (std::uint32_t line = 1; line <= source.line_count(); ++line)
        lines.emplace_back(source.line_text(line));
    return lines;
}

using Lines = std::vector<std::string>;

TEST(Lines, AnEmptyFileHasOneEmptyLine) {
    const Source source = source_of("");
    EXPECT_EQ(lines_of(source), Lines{""});
    EXPECT_EQ(source.position(0), (Position{1, 1, 1}));
}

TEST(Lines, TextWithoutAFinalLineEndIsALine) {
    EXPECT_EQ(lines_of(source_of("G0X0\nM30")), (Lines{"G0X0", "M30"}));
}

TEST(Lines, AFinalLineEndOpensAnEmptyLine) {
    const Source source = source_of("M30\n");
    EXPECT_EQ(lines_of(source), (Lines{"M30", ""}));
    EXPECT_EQ(source.position(4), (Position{2, 1, 1}));
}

TEST(Lines, LineFeedEndsALine) {
    EXPECT_EQ(lines_of(source_of("%\nO1\n\nM30")), (Lines{"%", "O1", "", "M30"}));
}

TEST(Lines, CarriageReturnAndLineFeedAreOneEnd) {
    EXPECT_EQ(lines_of(source_of("%\r\nO1\r\n\r\nM30")), (Lines{"%", "O1", "", "M30"}));
}

TEST(Lines, ALoneCarriageReturnEndsALine) {
    EXPECT_EQ(lines_of(source_of("%\rO1\r\rM30")), (Lines{"%", "O1", "", "M30"}));
}

TEST(Lines, TapeEndsOfLineFeedAndTwoCarriageReturnsAreOneEnd) {
    EXPECT_EQ(lines_of(source_of("%\n\r\rO1\n\r\r\n\r\rM30")), (Lines{"%", "O1", "", "M30"}));
}

TEST(Lines, LineFeedAndOneCarriageReturnAreOneEnd) {
    EXPECT_EQ(lines_of(source_of("%\n\rO1\n\rM30")), (Lines{"%", "O1", "M30"}));
}

TEST(Lines, MixedEndsInOneFileEachCountOnce) {
    EXPECT_EQ(lines_of(source_of("a\nb\r\nc\rd\n\r\re")), (Lines{"a", "b", "c", "d", "e"}));
}

TEST(Lines, ALineEndBelongsToTheLineThatItEnds) {
    const Source source = source_of("G0\r\nM30");
    EXPECT_EQ(source.position(2), (Position{1, 3, 3}));
    EXPECT_EQ(source.position(3), (Position{1, 4, 4}));
    EXPECT_EQ(source.position(4), (Position{2, 1, 1}));
    EXPECT_EQ(source.line_span(1), (Span{0, 2}));
}

TEST(Lines, LineNumbersOutsideTheFileMeanItsFirstAndLastLine) {
    const Source source = source_of("G0\nM30");
    EXPECT_EQ(source.line_text(0), "G0");
    EXPECT_EQ(source.line_text(99), "M30");
}

TEST(Columns, OffsetsAfterTheEndMeanTheEnd) {
    EXPECT_EQ(source_of("G0\nM30").position(4'000'000'000U), (Position{2, 4, 4}));
}

TEST(Columns, ACharacterOfTheBasicPlaneIsOneColumn) {
    const Source source = source_of("(Bohrung Ø8)X1"); // Ø is two bytes
    EXPECT_EQ(source.position(static_cast<Offset>(source.bytes().find('X'))), (Position{1, 13, 14}));
}

TEST(Columns, ACharacterOutsideTheBasicPlaneIsTwoColumns) {
    const Source source = source_of("(\U0001F527)X1"); // a spanner: four bytes, a surrogate pair in UTF-16
    EXPECT_EQ(source.position(1), (Position{1, 2, 2}));
    EXPECT_EQ(source.position(5), (Position{1, 4, 6}));
}

TEST(Columns, EveryByteOfACharacterHasItsColumn) {
    const Source source = source_of("(\U0001F527)");
    EXPECT_EQ(source.position(3), (Position{1, 2, 4}));
}

TEST(Columns, ALatin1ByteIsOneColumn) {
    const Source source = source_of("(Bohrung \xD8"
                                    "8)X1");
    EXPECT_EQ(source.encoding(), Encoding::windows_1252);
    EXPECT_EQ(source.position(12), (Position{1, 13, 13}));
}

TEST(Columns, TheByteOrderMarkTakesNone) {
    const Source source = source_of("\xEF\xBB\xBFO1\nM30");
    EXPECT_TRUE(source.has_byte_order_mark());
    EXPECT_EQ(source.position(0), (Position{1, 1, 1}));
    EXPECT_EQ(source.position(3), (Position{1, 1, 1}));
    EXPECT_EQ(source.position(4), (Position{1, 2, 2}));
    EXPECT_EQ(source.line_text(1), "O1");
    EXPECT_EQ(source.offset_at(1, 1), 3U);
}

TEST(Columns, TapeLeaderTakesOneAByte) {
    EXPECT_EQ(source_of(std::string(5, '\0') + "%\nO1").position(5), (Position{1, 6, 6}));
}

TEST(Columns, ColumnsAfterTheLineMeanItsEnd) {
    const Source source = source_of("G0\nM30");
    EXPECT_EQ(source.offset_at(1, 50), 2U);
    EXPECT_EQ(source.offset_at(2, 0), 3U);
}

TEST(Columns, AColumnInsideASurrogatePairMeansTheCharacter) {
    EXPECT_EQ(source_of("(\U0001F527)").offset_at(1, 3), 1U);
}

TEST(SparseIndex, CountsALineOfManyMegabytesFromANearbyCheckpoint) {
    const Source source = source_of(std::string(8'000'000, 'X') + "\nM30");
    EXPECT_EQ(source.position(7'999'999), (Position{1, 8'000'000, 8'000'000}));
    EXPECT_EQ(source.position(8'000'001), (Position{2, 1, 1}));
    EXPECT_EQ(source.line_span(1), (Span{0, 8'000'000}));
}

/// Positions of all bytes by plain counting, character by character.
std::vector<Position> count_positions(const Source& source) {
    const std::string_view bytes = source.bytes();
    std::vector<Position> positions;
    Position here;
    for (Offset at = 0; at < bytes.size();) {
        Offset next = at + 1;
        const bool ends_line = is_line_end(bytes[at]);
        if (ends_line) next = after_line_end(bytes, at);
        while (!ends_line && next < bytes.size() && character_begin(bytes, next, source.encoding()) != next)
            ++next;
        for (Offset inside = 0; inside < next - at; ++inside) {
            const std::uint32_t column = here.column + (ends_line ? inside : 0);
            positions.push_back({here.line, column, here.byte_column + inside});
        }
        const auto width =
            static_cast<std::uint32_t>(utf16_length(bytes.substr(at, next - at), source.encoding()));
        here = ends_line ? Position{here.line + 1, 1, 1}
                         : Position{here.line, here.column + width, here.byte_column + (next - at)};
        at = next;
    }
    positions.push_back(here);
    return positions;
}

class RandomText : public testing::TestWithParam<unsigned> {};

TEST_P(RandomText, HasThePositionsThatPlainCountingGives) {
    std::mt19937 random(GetParam());
    const std::vector<std::string> pieces = {"\n",     "\r\n", "\r",         "\n\r\r",
                                             "G1X1.5", "Ø",    "\U0001F527", std::string(700, 'A')};
    // SmallVector line ends in some texts, many in others: checkpoints fall inside lines, characters and line
    // ends.
    const std::size_t first = GetParam() % 2 == 0 ? 0 : 3;
    std::string text;
    while (text.size() < 12'000) text += pieces[first + random() % (pieces.size() - first)];

    const Source source = source_of(text);
    const std::vector<Position> expected = count_positions(source);
    ASSERT_EQ(expected.size(), text.size() + 1);
    for (Offset offset = 0; offset <= text.size(); ++offset) {
        const Position position = source.position(offset);
        ASSERT_EQ(position, expected[offset]) << "at byte " << offset;
        const Span line = source.line_span(position.line);
        ASSERT_EQ(line.begin + position.byte_column - 1, offset);
        if (offset < line.end) {
            ASSERT_EQ(source.offset_at(position.line, position.column),
                      character_begin(source.bytes(), offset, source.encoding()));
        }
    }
    EXPECT_EQ(source.line_count(), expected.back().line);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomText, testing::Range(0U, 8U));

TEST(SparseIndex, HoldsWhereLineEndsAndCharactersStraddleCheckpoints) {
    const std::vector<std::string> straddlers = {"\r\n", "\n\r\r", "Ø", "\U0001F527"};
    for (const std::string& straddler : straddlers) {
        for (std::size_t before = 4090; before <= 4100; ++before) {
            const Source source =
                source_of(std::string(before, 'X') + straddler + "Y\n" + std::string(5000, 'Z'));
            const std::vector<Position> expected = count_positions(source);
            for (const Offset offset : {4095U, 4096U, 4097U, 4098U, 4101U, 4105U, 8192U, 8193U}) {
                ASSERT_EQ(source.position(offset), expected[offset])
                    << before << " bytes before, at " << offset;
            }
        }
    }
}

} // namespace
} // namespace maclint
