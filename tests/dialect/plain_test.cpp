//! The plain lane: what it takes, and that it agrees with the grammar on every block that it takes.
#include "analyzer/dialect/fanuc/lowering.hpp"
#include "analyzer/dialect/fanuc/plain.hpp"
#include "analyzer/dialect/fanuc/split.hpp"
#include "analyzer/dialect/fanuc/tables.hpp"
#include "tests/dialect/reading.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::fanuc {
namespace {

using ::testing::ElementsAre;

Lane lane_of(std::string_view text) {
    ScannedBlock block;
    return scan_block(text, 0, codes_of(fanuc_control("fanuc")), block);
}

TEST(PlainLane, TakesWordsWithLiteralNumbers) {
    for (const char* text : {"G1X10.5Y-3.", "N10", "N5G90 G54 X 1 Y - .5", "M3S1200", "T1", "x1.y2.",
                             "(NOTE)G1X1.", "G02X1.I-5.J0F200.(ARC)", "G54.1P2", "G81X1.Y1.Z-5.R2.F100"})
        EXPECT_EQ(lane_of(text), Lane::plain) << text;
    for (const char* text : {"", "  \t", "(COMMENT)", "(A)(B)\n", ";"})
        EXPECT_EQ(lane_of(text), Lane::blank) << text;
}

TEST(PlainLane, LeavesEverythingElseToTheGrammar) {
    for (const char* text :
         {"#1=1",  "G1X#1",          "X[1]",       "/G1X1.", "O1",     "%",        "M30",   "M99",   "M98P1",
          "G65P1", "G4P100",         "G28Z0",      "M6T1",   "G1X",    "G1X1.5.2", "X--1",  "G0N10", "GOTO5",
          "N10.5", "(OPEN",          "G50S2000S1", "X1,C2.", "G54.12", "G-1",      "\"A\"", "N#1",   "N",
          "M3.5",  "(MACLINT ALLOW)"})
        EXPECT_EQ(lane_of(text), std::string_view(text) == "G50S2000S1" ? Lane::plain : Lane::grammar)
            << text;
}

TEST(PlainLane, JoinsBlocksToRunsWithWhatTheyLeaveBehind) {
    EXPECT_EQ(maclint::testing::lower("G90G0X1.\n\n(NOTE)\nN5G1Y2.F100\nF200"),
              "run of 3 numbered moving, motion mode=1, distance mode=90, feed=200");
    EXPECT_EQ(maclint::testing::lower("G17\n#1=1\nG18"), "run of 1, plane=17\n#1 := 1\nrun of 1, plane=18");
}

TEST(PlainLane, DecodesItsBlocksAgain) {
    const std::string text = "N5G90G1X1.\n(NOTE)\n;G92X0Y0\nF10.5S-3\n";
    const ProgramFile file = maclint::testing::read(text);
    const Program& program = file.programs.front();
    std::vector<std::string> seen;
    program.for_each_block(program.span_of(0), [&](const PlainBlock& block) {
        std::string one(program.slice(block.span));
        one += block.moves ? " moves" : "";
        if (block.sequence_number) one += " at " + std::to_string(*block.sequence_number);
        for (const ModalSetting& setting : block.settings)
            one += ' ' + std::to_string(setting.group) + '=' + std::to_string(setting.value).substr(0, 4);
        seen.push_back(std::move(one));
        return true;
    });
    EXPECT_THAT(seen,
                ElementsAre("N5G90G1X1. moves at 5 2=90.0 0=1.00", "G92X0Y0", "F10.5S-3 22=10.5 23=-3.0"));
    int first = 0;
    program.for_each_block(program.span_of(0), [&](const PlainBlock&) { return ++first < 1; });
    EXPECT_EQ(first, 1);
}

/// The sequence numbers of the program's runs, decoded again.
std::vector<std::int64_t> numbers_in_runs(const Program& program) {
    std::vector<std::int64_t> numbers;
    for (const Item& item : program.items) {
        const auto* run = std::get_if<PlainRun>(&item);
        if (run == nullptr) continue;
        program.for_each_block(run->span, [&](const PlainBlock& block) {
            if (block.sequence_number) numbers.push_back(*block.sequence_number);
            return true;
        });
    }
    return numbers;
}

TEST(PlainLane, BlocksBehindWhatItCannotReadAreDecodedToo) {
    for (const char* between : {"(MACLINT ALLOW MAC301)", "(NEVER CLOSED", "%\n%"}) {
        const ProgramFile file =
            maclint::testing::read("%\nO1\nN1 G1 X1.\n" + std::string(between) + "\nN2 G1 X2.\nN3 X3.\n");
        ASSERT_EQ(file.programs.size(), 1U) << between;
        EXPECT_THAT(numbers_in_runs(file.programs[0]), ElementsAre(1, 2, 3)) << between;
    }
    EXPECT_EQ(maclint::testing::lower("G1X1.\n(NOTE)\n\nX2.\n%\n"), "run of 2 moving, motion mode=1");
}

/// What a block does, from whichever lane.
struct Meaning {
    bool has_block = false, error = false, moves = false, other = false;
    std::optional<std::int64_t> sequence_number;
    std::vector<std::pair<GroupId, double>> settings;
    friend bool operator==(const Meaning&, const Meaning&) = default;
};

Meaning by_scanner(const ScannedBlock& block, Lane lane) {
    Meaning meaning;
    meaning.has_block = lane == Lane::plain;
    if (!meaning.has_block) return meaning;
    meaning.moves = block.moves;
    if (!block.sequence_span.empty()) meaning.sequence_number = block.sequence_number;
    for (std::size_t i = 0; i < block.settings_count; ++i)
        meaning.settings.emplace_back(block.settings[i].group, block.settings[i].value);
    return meaning;
}

Meaning by_grammar(std::string_view text, const ControlModel& control) {
    Meaning meaning;
    syntax::Tree tree;
    syntax::parse(grammar, std::string(text) + "\n", tree);
    meaning.error = tree.has_error;
    if (meaning.error) return meaning;
    ProgramBuilder builder("O1", text, control);
    std::vector<SyntaxError> syntax_errors;
    BlockLowering(codes_of(control), syntax_errors)
        .lower(tree, {0, static_cast<Offset>(text.size())}, builder);
    meaning.other = !syntax_errors.empty();
    const Program& program = builder.program();
    if (program.items.empty()) return meaning;
    const auto& block = std::get<Block>(program.items.front());
    meaning.has_block = true;
    meaning.sequence_number = block.sequence_number;
    for (const Effect& effect : program.effects_in(block.effects)) {
        if (const auto* set = std::get_if<SetModal>(&effect.what)) {
            const auto* value = std::get_if<Literal>(&program.expressions[set->value].node);
            if (set->group && value != nullptr)
                meaning.settings.emplace_back(*set->group, value->value);
            else
                meaning.other = true;
        } else if (std::holds_alternative<Motion>(effect.what)) {
            meaning.moves = true;
        } else {
            meaning.other = true;
        }
    }
    return meaning;
}

/// Compares the lanes on every block of a text; tells how many blocks were plain.
std::size_t compare_lanes(std::string_view text, const ControlModel& control, std::string_view where) {
    std::size_t plain = 0;
    ScannedBlock scanned;
    RawBlock raw;
    for (Offset at = 0; at < text.size();) {
        cut_block(text, at, raw);
        const Lane lane = scan_block(text, at, codes_of(control), scanned);
        if (lane == Lane::grammar) {
            at = raw.next > at ? raw.next : at + 1;
            continue;
        }
        EXPECT_EQ(raw.next, scanned.next) << where << " at " << at;
        const std::string_view block = text.substr(at, scanned.next - at);
        const Meaning expected = by_grammar(block.substr(0, block.find_last_not_of("\r\n;") + 1), control);
        EXPECT_EQ(by_scanner(scanned, lane), expected)
            << where << ": " << block << (expected.error ? " (error)" : "");
        plain += lane == Lane::plain ? 1 : 0;
        at = scanned.next;
        if (::testing::Test::HasFailure()) return plain;
    }
    return plain;
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
    for (int round = 0; round < 4000 && !HasFailure(); ++round) {
        std::string text;
        const std::size_t count = random() % 14;
        for (std::size_t i = 0; i < count; ++i) text += pieces[random() % std::size(pieces)];
        plain += compare_lanes(text, fanuc_control("fanuc"), "generated");
        plain += compare_lanes(text, fanuc_control("fanuc-lathe"), "generated");
    }
    EXPECT_GT(plain, 2000U);
}

TEST(PlainLane, AgreesWithTheGrammarOnTheOuterCorpus) {
    const std::filesystem::path corpus = std::filesystem::path(MACLINT_SHARED) / "corpus";
    if (!std::filesystem::exists(corpus)) GTEST_SKIP() << "the outer corpus is not at " << corpus;
    std::size_t plain = 0;
    for (const char* group : {"fanuc-macro", "fanuc-plain"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus / group)) {
            if (!entry.is_regular_file()) continue;
            std::ifstream file(entry.path(), std::ios::binary);
            const std::string text((std::istreambuf_iterator<char>(file)), {});
            const ControlModel& control = *maclint::testing::read_as("fanuc", "x.nc", text).control;
            plain += compare_lanes(text, control, entry.path().string());
            if (HasFailure()) return;
        }
    }
    EXPECT_GT(plain, 100'000U);
}

} // namespace
} // namespace maclint::fanuc
