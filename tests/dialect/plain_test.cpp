//! The plain lane: what it takes, and that it agrees with the grammar on every block that it takes.
#include "analyzer/dialect/dinplus/plain.hpp"
#include "analyzer/dialect/fanuc/codes.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "analyzer/program/block_view.hpp"
#include "analyzer/syntax/plain_scanner.hpp"
#include "tests/dialect/both_lanes.hpp"
#include "tests/dialect/reading.hpp"

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using syntax::Lane;
using ::testing::ElementsAre;

const syntax::PlainTables& of_mills() { return fanuc::codes_of(*find_control("fanuc")).plain; }
const syntax::PlainTables& of_commands() { return dinplus::plain_tables(dinplus::plain_sections::commands); }
const syntax::PlainTables& of_descriptions() {
    return dinplus::plain_tables(dinplus::plain_sections::descriptions);
}

Lane lane_of(std::string_view text, const syntax::PlainTables& tables = of_mills()) {
    syntax::PlainBlock block;
    return scan_block(text, 0, tables, block);
}

TEST(PlainLane, TakesWordsWithLiteralNumbers) {
    for (const char* text :
         {"G1X10.5Y-3.", "N10", "N5G90 G54 X 1 Y - .5", "M3S1200", "T1", "x1.y2.", "(NOTE)G1X1.",
          "G02X1.I-5.J0F200.(ARC)", "G54.1P2", "G81X1.Y1.Z-5.R2.F100", "G50S2000S1"})
        EXPECT_EQ(lane_of(text), Lane::plain) << text;
    for (const char* text : {"", "  \t", "(COMMENT)", "(A)(B)\n", ";"})
        EXPECT_EQ(lane_of(text), Lane::blank) << text;
}

TEST(PlainLane, LeavesEverythingElseToTheGrammar) {
    for (const char* text : {"#1=1",     "G1X#1", "X[1]",  "/G1X1.", "O1",    "%",     "M30",
                             "M99",      "M98P1", "G65P1", "G4P100", "G28Z0", "M6T1",  "G1X",
                             "G1X1.5.2", "X--1",  "G0N10", "GOTO5",  "N10.5", "(OPEN", "X1,C2.",
                             "G54.12",   "G-1",   "\"A\"", "N#1",    "N",     "M3.5",  "(MACLINT ALLOW)"})
        EXPECT_EQ(lane_of(text), Lane::grammar) << text;
}

TEST(PlainLane, TakesPlainBlocksOfDinPlus) {
    for (const char* text :
         {"N10 G1 X10.5 Z-3", "N10", "X10 Zi-5 [BACK]", "G810 P2", "N5 G0 XK30 YK-2.5", "G97 M8"})
        EXPECT_EQ(lane_of(text, of_descriptions()), Lane::plain) << text;
    EXPECT_EQ(lane_of("N10 G1 X10.5 Z-3 M8", of_commands()), Lane::plain);
    EXPECT_EQ(lane_of("[ONLY]", of_commands()), Lane::blank);
    // Words that need an effect of their own, and what is no word.
    for (const char* text :
         {"T1",   "G95 F0.2",  "G810 NS2 NE3", "M30",       "G14 Q0",  "G16 Q1",  "G4 F1",  "$1 G1 X1",
          "/ X1", "GO X1",     "G1O X1",       "x10",       "IF 1",    "X#l1",    "X1.2.3", "X1,5",
          "X5+1", "MACHINING", "NE 5",         "[maclint]", "X 5 (A)", "N5 G1 N6"})
        EXPECT_EQ(lane_of(text, of_commands()), Lane::grammar) << text;
}

TEST(PlainLane, JoinsBlocksToRunsWithWhatTheyLeaveAfter) {
    const ProgramFile file = test::read("G90G0X1.\n\n(NOTE)\nN5G1Y2.F100\nF200");
    const Program& program = file.programs.front();
    ASSERT_EQ(program.items.size(), 1U);
    const Stretch all{0, program.span};
    EXPECT_TRUE(moves(program, all));
    std::string left;
    for_each_last_setting(program, all, [&](const ModalSetting& setting) {
        left += std::string(program.control->groups[setting.group].name) + '=' +
                std::to_string(static_cast<int>(setting.value)) + ' ';
    });
    EXPECT_EQ(left, "distance mode=90 motion mode=1 feed=200 ");
    EXPECT_EQ(count_blocks(program), 3U);
    EXPECT_EQ(test::read("G17\n#1=1\nG18").programs.front().items.size(), 3U);
}

TEST(PlainLane, KnowsOfARunWhatItsBlocksRepeat) {
    const auto summary = [](std::string_view text) {
        const ProgramFile file = test::read(text);
        return std::get<PlainRun>(file.programs.front().items.front()).words;
    };
    EXPECT_TRUE(summary("G0 G90 X1. Y2. M3 M8\nX1. Y2.").repeated.empty());
    EXPECT_FALSE(summary("G0 G90 X1. Y2.").conflicts);
    EXPECT_EQ(summary("X1.\nX1. Y2. X3.").repeated, summary("X1.").addresses);
    EXPECT_TRUE(summary("X1.\nG0 G1 X2.").conflicts);
}

TEST(PlainLane, DecodesItsBlocksAgain) {
    const std::string text = "N5G90G1X1.\n(NOTE)\n;G92X0Y0\nF10.5S-3\n";
    const ProgramFile file = test::read(text);
    const Program& program = file.programs.front();
    std::vector<std::string> seen;
    for_each_block(program, [&](const BlockView& block) {
        std::string one(program.slice(block.span));
        one += block.moves ? " moves" : "";
        if (block.number) one += " at " + std::to_string(*block.number);
        for (const BlockSetting& setting : block.settings)
            one += ' ' + std::to_string(setting.group) + '=' + std::to_string(*setting.value).substr(0, 4);
        seen.push_back(std::move(one));
    });
    EXPECT_THAT(seen,
                ElementsAre("N5G90G1X1. moves at 5 2=90.0 0=1.00", "G92X0Y0", "F10.5S-3 22=10.5 23=-3.0"));
    int first = 0;
    for_each_block(program, [&](const BlockView&) { return ++first < 1; });
    EXPECT_EQ(first, 1);
}

/// The block numbers of the program.
std::vector<std::int64_t> numbers_of(const Program& program) {
    std::vector<std::int64_t> numbers;
    for_each_block(program, [&](const BlockView& block) {
        if (block.number) numbers.push_back(*block.number);
    });
    return numbers;
}

TEST(PlainLane, BlocksAfterWhatItCannotReadAreDecodedToo) {
    for (const char* between : {"(MACLINT ALLOW MAC301)", "(NEVER CLOSED", "%\n%"}) {
        const ProgramFile file =
            test::read("%\nO1\nN1 G1 X1.\n" + std::string(between) + "\nN2 G1 X2.\nN3 X3.\n");
        ASSERT_EQ(file.programs.size(), 1U) << between;
        EXPECT_THAT(numbers_of(file.programs[0]), ElementsAre(1, 2, 3)) << between;
    }
    EXPECT_EQ(count_blocks(test::read("G1X1.\n(NOTE)\n\nX2.\n%\n").programs.front()), 2U);
}

/// The numbers that a loop over stretches or numbered blocks looks for.
struct Only {
    std::int64_t wanted;
    bool operator()(std::int64_t number) const { return number == wanted; }
    [[nodiscard]] bool between(std::int64_t lowest, std::int64_t highest) const {
        return lowest <= wanted && wanted <= highest;
    }
};

TEST(PlainLane, CutsALongRowOfBlocksWhereANumberIsWanted) {
    std::string text;
    for (int i = 1; i <= 10'000; ++i) text += "N" + std::to_string(i) + " X1.\n";
    const ProgramFile file = test::read(text);
    const Program& program = file.programs.front();
    std::vector<std::string> heads;
    Offset end = 0;
    for_each_stretch(program, program.sections.front(), Only{6000}, [&](const StretchView& view) {
        EXPECT_GE(view.stretch.span.begin, end) << "stretches do not overlap";
        end = view.stretch.span.end;
        EXPECT_TRUE(view.plain);
        if (view.first != nullptr) heads.emplace_back(program.slice(view.first->number_span));
    });
    EXPECT_THAT(heads, ElementsAre("N6000"));
    EXPECT_EQ(end, program.span.end);
    std::vector<std::string> found;
    for_each_numbered_block(program, program.sections.front(), Only{6000},
                            [&](const BlockView& block) { found.emplace_back(program.slice(block.span)); });
    EXPECT_THAT(found, ElementsAre("N6000 X1."));
    EXPECT_EQ(count_blocks(program), 10'000U);
    EXPECT_EQ(program.slice(last_block(program)->span), "N10000 X1.");
}

// ---- both lanes

/// Compares what both lanes make of a text; tells how many of its blocks are plain.
std::size_t compare_lanes(std::string_view text, std::string_view control, std::string_view name) {
    const test::BothLanes lanes = test::forbid_plain_lane(text, control);
    if (const auto difference = test::difference_of_lanes(text, control, name))
        ADD_FAILURE() << name << ", " << *difference << "\n" << (text.size() < 500 ? text : "");
    return lanes.plain;
}

std::string from_pieces(std::mt19937& random, std::span<const char* const> pieces) {
    std::string text;
    const std::size_t count = random() % 14;
    for (std::size_t i = 0; i < count; ++i) text += pieces[random() % pieces.size()];
    return text;
}

TEST(PlainLane, AgreesWithTheGrammarOnGeneratedBlocks) {
    static constexpr const char* pieces[] = {"G0",
                                             "G1",
                                             "G90",
                                             "G54.1",
                                             "G81",
                                             "G92",
                                             "G28",
                                             "G4",
                                             "G01.",
                                             "G5.1",
                                             "g2",
                                             "G 3",
                                             "X1.",
                                             "Y-2.5",
                                             "Z .5",
                                             "I0",
                                             "R-1",
                                             "F100.",
                                             "S1200",
                                             "F-.5",
                                             "S",
                                             "M3",
                                             "M08",
                                             "M30",
                                             "T1",
                                             "N10",
                                             "N5",
                                             "H1",
                                             "D2",
                                             "P1",
                                             "Q3",
                                             "K0",
                                             "(A)",
                                             "(B;C)",
                                             "(OPEN",
                                             ";",
                                             " ",
                                             "\t",
                                             "\n",
                                             "\r\n",
                                             "\n",
                                             "\n",
                                             "#1",
                                             "[",
                                             "X",
                                             "1",
                                             ".",
                                             "-",
                                             "L2",
                                             "E5",
                                             "O1",
                                             "/",
                                             "U1",
                                             "W-1",
                                             "C90.",
                                             "&F1",
                                             "@1",
                                             ",C1",
                                             "*",
                                             "+",
                                             "G100",
                                             "G999.9",
                                             "G1000",
                                             "M9999",
                                             "M10000",
                                             "X 1 ",
                                             "S12345678901234567"};
    std::mt19937 random(20240501);
    std::size_t plain = 0;
    for (int round = 0; round < 1000 && !HasFailure(); ++round) {
        const std::string text = from_pieces(random, pieces);
        plain += compare_lanes(text, "fanuc", "generated.nc");
        plain += compare_lanes(text, "fanuc-lathe", "generated.nc");
    }
    EXPECT_GT(plain, 500U);
}

TEST(PlainLane, AgreesWithTheGrammarWhereAProgramGoesOnBehindAnother) {
    EXPECT_EQ(
        compare_lanes("MACHINING\nN1 G0 X1\nSUBPROGRAM \"U\"\nN2 G0 X2\nTURRET\nT1\n", "dinplus", "part.nc"),
        3U);
}

TEST(PlainLane, AgreesWithTheGrammarOnGeneratedBlocksOfDinPlus) {
    static constexpr const char* pieces[] = {
        "N10 ",   "N5",         "n7 ",      "G0",          " G1 ",   "G2",         "G40",
        "G95",    "G96",        "G97",      "G810",        "G14",    "G16",        "G4",
        "G59",    "G999",       "G1000",    "G1.",         "GO",     "M3",         "M8",
        "M30",    "M99",        "T1",       "X10",         " X10.5", " Z-.5",      " Zi-3",
        "Xi",     "XK5",        " YK-2",    " NS2",        " NE3",   " NE 3",      "LE5",
        "LE 5",   "IF1",        "OR1",      "EQ2",         "L1",     "F0.2",       " S200",
        "Q1",     " Q0",        "HID3",     "ABC1",        "X 1",    "X- 1",       "X+1",
        "X1.2.3", "X1,5",       "+1",       "O",           "[A]",    " [B;C] ",    "[//]",

        "\"A\"",  " ",          "\t",       "\n",          "\n",     "\r\n",       "\n",
        ";",      "//",         "/",        "$1 ",         "#l1",    "=",          "12345678901234567",
        ".",      "IF #l1>5\n", "THEN\n",   "ENDIF\n",     "END\n",  "FINISHED\n", "MACHINING\n",
        "VAR\n",  "T1 ID\"X\"", "TURRET\n", "SUBPROGRAM\n"};
    std::mt19937 random(20240502);
    std::size_t plain = 0;
    for (int round = 0; round < 1000 && !HasFailure(); ++round) {
        const std::string blocks = from_pieces(random, pieces);
        for (const char* section : {"MACHINING\n", "FINISHED\n", "TURRET\n"})
            plain += compare_lanes(section + blocks, "dinplus", "generated.nc");
    }
    EXPECT_GT(plain, 500U);
}

std::size_t compare_folder(const std::filesystem::path& folder, std::string_view control) {
    std::size_t plain = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file() || ::testing::Test::HasFailure()) continue;
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string text((std::istreambuf_iterator<char>(file)), {});
        plain += compare_lanes(text, control, entry.path().string());
    }
    return plain;
}

TEST(PlainLane, AgreesWithTheGrammarOnTheOuterCorpus) {
    const std::filesystem::path shared(MACLINT_SHARED);
    if (!std::filesystem::exists(shared / "corpus")) GTEST_SKIP() << "there is no outer corpus at " << shared;
    EXPECT_GT(compare_folder(shared / "corpus/fanuc-macro", "fanuc") +
                  compare_folder(shared / "corpus/fanuc-plain", "fanuc"),
              100'000U);
    EXPECT_GT(compare_folder(shared / "reference/dinplus-examples", "dinplus"), 500U);
}

} // namespace
} // namespace maclint
