//! DIN PLUS files: sections, programs, comments, and any bytes.
#include "analyzer/program/block_view.hpp"
#include "tests/dialect/reading.hpp"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <set>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

ProgramFile read_din(std::string_view text, std::string path = "part.nc") {
    return test::read_as("dinplus", std::move(path), text);
}

std::vector<std::string> sections_of(const Program& program) {
    std::vector<std::string> sections;
    for (const Section& section : program.sections) {
        static constexpr std::string_view when[] = {"", " at load", " never"};
        sections.push_back(std::string(section.kind) + ' ' + std::to_string(section.items.count) +
                           std::string(when[static_cast<std::size_t>(section.executed)]));
    }
    return sections;
}

std::string bytes_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return std::move(bytes).str();
}

double seconds_to_read(std::string_view text) {
    const auto start = std::chrono::steady_clock::now();
    const ProgramFile file = read_din(text);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

TEST(DinSections, EnglishAndGermanWordsBeginTheSame) {
    const auto english =
        read_din("PROGRAM HEAD\n#UNIT METRIC\nTURRET 1\nT1 ID\"A\"\nVAR\n#_a=#l1\nBLANK\nN1 G20 X5\n"
                 "FACE_C Z-25\nN2 G308\nMACHINING\nN3 M30\nEND\n");
    const auto german =
        read_din("PROGRAMMKOPF\n#EINHEIT METRIC\nREVOLVER 1\nT1 ID\"A\"\nVAR\n#_a=#l1\nROHTEIL\nN1 G20 X5\n"
                 "STIRN Z-25\nN2 G308\nBEARBEITUNG\nN3 M30\nENDE\n");
    const std::vector<std::string> wanted{"PROGRAM HEAD 1 never", "TURRET 1 never",   "VAR 1 at load",
                                          "BLANK 1 at load",      "FACE_C 1 at load", "MACHINING 1",
                                          "END 0 never"};
    EXPECT_EQ(sections_of(english.programs.at(0)), wanted);
    EXPECT_EQ(sections_of(german.programs.at(0)), wanted);
    EXPECT_THAT(english.syntax_errors, IsEmpty());
    EXPECT_THAT(german.syntax_errors, IsEmpty());
}

TEST(DinSections, TwiceAndAfterTheEndAreThereToBeSeen) {
    const auto file = read_din("MACHINING\nN1 M30\nMACHINING\nN2 M30\nEND\nN3 M30\nBLANK\n");
    EXPECT_THAT(sections_of(file.programs.at(0)),
                ElementsAre("MACHINING 1", "MACHINING 1", "END 1 never", "BLANK 0 at load"));
}

TEST(DinSections, WordsThatOnlyManualsPrintAreReportedAndUnderstood) {
    const auto file = read_din("VAIPPA Y X118\nKONEISTUS\nN1 M30\nLOPPU\n");
    EXPECT_THAT(sections_of(file.programs.at(0)),
                ElementsAre("LATERAL_Y 0 at load", "MACHINING 1", "END 0 never"));
    ASSERT_EQ(file.syntax_errors.size(), 3U);
    EXPECT_EQ(file.syntax_errors[0].subject, "VAIPPA Y");
    EXPECT_EQ(file.syntax_errors[0].cure, "LATERAL_Y");
    EXPECT_EQ(file.syntax_errors[1].cure, "MACHINING");
    EXPECT_EQ(file.syntax_errors[2].cure, "END");
}

TEST(DinSyntaxErrors, StandInTheOrderOfTheirPlaces) {
    // The open comment is found before the word in front of it.
    const ProgramFile file = read_din("MACHINING\nG0 X?? [abc\nM30\nEND\n");
    ASSERT_EQ(file.syntax_errors.size(), 2U);
    EXPECT_EQ(file.syntax_errors[0].kind, SyntaxErrorKind::unreadable);
    EXPECT_EQ(file.syntax_errors[1].kind, SyntaxErrorKind::unterminated_comment);
    const Span first = file.syntax_errors[0].span;
    const Span second = file.syntax_errors[1].span;
    EXPECT_EQ(file.syntax_errors_in({first.begin, second.begin}).size(), 1U);
    EXPECT_EQ(file.syntax_errors_in({first.begin, second.begin + 1}).size(), 2U);
    EXPECT_EQ(file.syntax_errors_in({first.begin + 1, second.begin}).size(), 0U);
    EXPECT_EQ(file.syntax_errors_in({first.begin + 1, second.end}).front().kind,
              SyntaxErrorKind::unterminated_comment);
}

TEST(DinSections, LatinOneAndUtf8AreTheSameWord) {
    for (const std::string_view word : {"MUOTORYHM\xC4 Q1\nN1 M8\n", "MUOTORYHM\xC3\x84 Q1\nN1 M8\n"})
        EXPECT_THAT(sections_of(read_din(word).programs.at(0)), ElementsAre("CONTOUR 1 at load")) << word;
}

TEST(DinSections, ANumberBeforeTheWordDoesNotHideIt) {
    const auto file =
        read_din("N1 FACE_C Z0\nN2 G308\nN3 LATERAL Y [side] X118 C0\nN4 TURRET 1\nN5 MACHINING\n"
                 "N6 M30\nN7 END\n");
    EXPECT_THAT(sections_of(file.programs.at(0)),
                ElementsAre("FACE_C 1 at load", "LATERAL_Y 0 at load", "TURRET 0 never", "MACHINING 1",
                            "END 0 never"));
    EXPECT_THAT(file.syntax_errors, IsEmpty());
}

TEST(DinSections, CommandsAfterTheWordAreReported) {
    for (const char* text : {"MACHINING G0 X10 THN\n", "MACHINING N5 X10\n", "N4 MACHINING M3\n",
                             "BLANK\nN1 G20 X5\nMACHINING ENDIF\n", "N5 G0 X10 MACHINING\n"}) {
        const auto file = read_din(text);
        ASSERT_EQ(file.syntax_errors.size(), 1U) << text;
        EXPECT_EQ(file.syntax_errors[0].kind, SyntaxErrorKind::not_alone) << text;
        EXPECT_EQ(file.syntax_errors[0].subject, "MACHINING") << text;
    }
    for (const char* text :
         {"CONTOUR Q1 X0 Z600\n", "SUBPROGRAM \"G1 N5\"\n", "MACHINING [G0 X10]\n",
          "LATERAL_Y X118 C0 B0 I1 K2 H1\n", "TURRET 1\n", "ASSIGNMENT $1 $2\n", "AUXIL_CONTOUR ID\"M1\"\n"})
        EXPECT_THAT(read_din(text).syntax_errors, IsEmpty()) << text;
}

TEST(DinSections, AMisspeltWordIsCuredWithTheSpellingOfTheControl) {
    EXPECT_EQ(read_din("face_c\n").syntax_errors.at(0).cure, "FACE_C");
    EXPECT_EQ(read_din("LATERALC X50\n").syntax_errors.at(0).cure, "LATERAL_C");
    EXPECT_EQ(read_din("AUXIL CONTOUR\n").syntax_errors.size(), 0U);
    EXPECT_EQ(read_din("program head\n").syntax_errors.at(0).cure, "PROGRAM HEAD");
}

TEST(DinSyntaxErrorsOfExamples, WordsThatTheControlRefusesAreToldThoughTheyCanBeParsed) {
    static constexpr std::pair<const char*, const char*> blocks[] = {
        {"N1 G95 F0,25", "a decimal point in the number"},
        {"N1 G1 X1.2.3", "one decimal point in the number"},
        {"N1 G...", "a number"},
        {"N#l1 G1 X5", "the digits of a block number"}};
    for (const auto& [block, cure] : blocks) {
        const auto file = read_din("MACHINING\n" + std::string(block));
        ASSERT_EQ(file.syntax_errors.size(), 1U) << block;
        EXPECT_EQ(file.syntax_errors[0].cure, cure);
    }
}

TEST(DinSections, SmallLettersAreReported) {
    const auto file = read_din("machining\nN1 M30\n");
    EXPECT_THAT(sections_of(file.programs.at(0)), ElementsAre("MACHINING 1"));
    ASSERT_EQ(file.syntax_errors.size(), 1U);
    EXPECT_EQ(file.syntax_errors[0].kind, SyntaxErrorKind::unknown_keyword);
    EXPECT_EQ(file.syntax_errors[0].cure, "MACHINING");
}

TEST(DinPrograms, EverySubprogramSectionIsAProgram) {
    const auto file = read_din("%shaft.nc \"V1\"\nVAR\n#_n=#g201\n#_m=#l1\nMACHINING\nN1 L\"A B\"\nN2 M30\n"
                               "SUBPROGRAM \"A B\"\nN3 #_n=#_m\nRETURN\nEND\n",
                               "folder/part.nc");
    ASSERT_EQ(file.programs.size(), 2U);
    const Program& main = file.programs[0];
    const Program& sub = file.programs[1];
    EXPECT_EQ(main.name, "part");
    EXPECT_THAT(main.also_known_as, ElementsAre("part.nc", "shaft", "shaft.nc"));
    EXPECT_EQ(main.slice(main.name_span), "shaft.nc");
    EXPECT_EQ(main.started, Program::Started::by_hand);
    EXPECT_THAT(sections_of(main), ElementsAre("VAR 2 at load", "MACHINING 2", "END 0 never"));
    EXPECT_EQ(sub.name, "A B");
    EXPECT_TRUE(sub.local);
    EXPECT_EQ(sub.started, Program::Started::by_call);
    // A global variable's name is known there; the local one is the caller's.
    EXPECT_EQ(describe(sub), "N3 #g201 := #_m\nreturn\n");
}

TEST(DinPrograms, ASubprogramFileIsOneProgram) {
    const auto file =
        read_din("%GROOVE.ncs\n[//]\n[la=1; s=Depth]\n[//]\nMACHINING\nN1 X#__la\nRETURN\n", "GROOVE.ncs");
    ASSERT_EQ(file.programs.size(), 1U);
    EXPECT_EQ(file.programs[0].name, "GROOVE");
    EXPECT_EQ(file.programs[0].started, Program::Started::by_call);
    EXPECT_THAT(file.syntax_errors, IsEmpty());
}

TEST(DinPrograms, ASecondProgramLineBeginsASecondProgram) {
    const auto file = read_din("%a.nc\nMACHINING\nN1 M30\nEND\n%b.nc\nMACHINING\nN1 M30\nEND\n");
    ASSERT_EQ(file.programs.size(), 2U);
    EXPECT_EQ(sections_of(file.programs[0]), sections_of(file.programs[1]));
}

TEST(DinComments, ThoseForMaclintKnowTheirBlocks) {
    const auto file = read_din("MACHINING\n[maclint: a]\nN1 [MACLINT b]\nN2 G0 X1 [maclint c]\n");
    ASSERT_EQ(file.comments.size(), 3U);
    const Program& program = file.programs.at(0);
    EXPECT_TRUE(file.comments[0].block.empty());
    EXPECT_EQ(program.slice(file.comments[0].next_block), "N1 [MACLINT b]");
    EXPECT_EQ(program.slice(file.comments[1].block), "N1 [MACLINT b]");
    EXPECT_EQ(program.slice(file.comments[1].next_block), "N2 G0 X1 [maclint c]");
    EXPECT_EQ(program.slice(file.comments[2].block), "N2 G0 X1 [maclint c]");
    EXPECT_TRUE(file.comments[2].next_block.empty());
}

TEST(DinSyntaxErrorsOfExamples, WrongBlocksOfTheGrammarAreToldTheirCause) {
    static constexpr std::pair<std::string_view, SyntaxErrorKind> causes[] = {
        {"MAC102", SyntaxErrorKind::unterminated_comment},
        {"MAC117", SyntaxErrorKind::bracket_mismatch},
        {"MAC118", SyntaxErrorKind::unknown_keyword},
        {"DIN008", SyntaxErrorKind::not_alone},
        {"DIN323", SyntaxErrorKind::hash_in_vacancy_test},
        {"DIN331", SyntaxErrorKind::unknown_transfer_value},
        {"DIN326", SyntaxErrorKind::assignment_in_condition}};
    std::ifstream file(MACLINT_SOURCE_DIR "/grammar/dinplus/test/wrong-blocks.txt");
    ASSERT_TRUE(file);
    std::size_t evaluated = 0;
    for (std::string line; std::getline(file, line);) {
        const std::size_t tab = line.find('\t');
        if (tab == std::string::npos) continue;
        const auto* cause = std::ranges::find(causes, std::string_view(line).substr(tab + 1),
                                              &std::pair<std::string_view, SyntaxErrorKind>::first);
        if (cause == std::end(causes)) continue;
        ++evaluated;
        std::set<SyntaxErrorKind> found;
        for (const SyntaxError& syntax_error : read_din("MACHINING\n" + line.substr(0, tab)).syntax_errors)
            found.insert(syntax_error.kind);
        const bool reported =
            found.contains(cause->second) || (cause->second == SyntaxErrorKind::assignment_in_condition &&
                                              found.contains(SyntaxErrorKind::comparison_as_assignment));
        EXPECT_TRUE(reported) << line;
        EXPECT_FALSE(found.contains(SyntaxErrorKind::unreadable)) << "told twice: " << line;
    }
    EXPECT_GT(evaluated, 80U);
}

TEST(DinManual, ItsExamplesHaveNoIrregularityButTheirPlaceholders) {
    const std::filesystem::path folder = MACLINT_SHARED "/reference/dinplus-examples/repaired";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the reference is not here";
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const ProgramFile file = read_din(bytes_of(entry.path()));
        ++files;
        for (const SyntaxError& syntax_error : file.syntax_errors) {
            const auto line = file.source->line_text(file.source->position(syntax_error.span.begin).line);
            EXPECT_NE(line.find(".."), std::string_view::npos)
                << entry.path() << ": " << name_of(syntax_error.kind) << " in " << line;
        }
    }
    EXPECT_GT(files, 100U);
}

TEST(DinBadInput, EveryFileIsReadAndNoSpanLeavesIt) {
    std::size_t files = 0;
    const std::filesystem::path folder = MACLINT_SOURCE_DIR "/tests/fixtures/dinplus/bad-input";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        ++files;
        const std::string bytes = bytes_of(entry.path());
        const ProgramFile file = read_din(bytes, entry.path().string());
        for (const Program& program : file.programs)
            for (ItemId item = 0; item < program.items.size(); ++item) {
                EXPECT_LE(program.span_of(item).end, file.source->size()) << entry.path();
                EXPECT_FALSE(program.span_of(item).empty()) << entry.path();
            }
        for (const SyntaxError& syntax_error : file.syntax_errors)
            EXPECT_LE(syntax_error.span.end, file.source->size()) << entry.path();
    }
    EXPECT_GT(files, 50U);
}

TEST(DinBlocks, ManyNegativeWordsAreNoNoise) {
    std::string block = "N1 L\"UP\" V1";
    for (const char letter : std::string_view("ABCDEFHIJKOPRSUWXYZ"))
        block += std::string(" L") + letter + "-1";
    for (const char* word : {"BS-1", "BE-2", "WS-3", "AC-4", "WC-5", "RC-6", "ICi-7", "KC+8"})
        block += ' ' + std::string(word);
    const auto file = read_din("MACHINING\n" + block + "\n");
    EXPECT_THAT(file.syntax_errors, IsEmpty());
}

TEST(DinBadInput, NoiseIsReadInLinearTime) {
    constexpr std::size_t megabyte = 1'000'000;
    constexpr double patience = 10; // seconds, on a busy machine with checks switched on
    std::mt19937 random(7);
    std::string bytes(megabyte, '\0');
    for (char& c : bytes) c = static_cast<char>(random() % 256);
    EXPECT_LT(seconds_to_read(bytes), patience);
    constexpr std::string_view alphabet = "=-+*/()#<>,.0123456789lgXNGi\"[]_ ";
    for (char& c : bytes) c = alphabet[random() % alphabet.size()];
    EXPECT_LT(seconds_to_read(bytes), patience);
    for (const std::string_view unit : {"=-", "X#l1*", "(1,", "DEF(", "IF ", "ABC(", "#", "1+"}) {
        std::string lines;
        while (lines.size() < megabyte) {
            const std::size_t begin = lines.size();
            while (lines.size() - begin + unit.size() < 4000) lines += unit;
            lines += '\n';
        }
        EXPECT_LT(seconds_to_read(lines), patience) << unit;
    }
}

TEST(DinNames, ManyOfThemAreReadInLinearTime) {
    std::string text = "VAR\n";
    for (int i = 0; i < 50'000; ++i) text += "#_a" + std::to_string(i) + "=#g" + std::to_string(i + 1) + '\n';
    text += "MACHINING\n";
    for (int i = 0; i < 50'000; ++i) text += "#_b" + std::to_string(i) + "=#_a" + std::to_string(i) + '\n';
    EXPECT_LT(seconds_to_read(text), 3);
}

TEST(DinBadInput, AnUnclosedCommentOfTenMegabytes) {
    constexpr std::size_t size = 10'000'000;
    constexpr double patience = 10;
    const auto filled = [](std::string text, std::string_view with) {
        while (text.size() < size) text += with;
        return text;
    };
    EXPECT_LT(seconds_to_read(filled("MACHINING\n[never closed ", "text and more\n")), patience);
    EXPECT_LT(seconds_to_read(filled("MACHINING\n", "[")), patience);
    const std::string blocks = filled("MACHINING\n[never closed\n", "N1 G1 X5\n");
    const ProgramFile file = read_din(blocks);
    ASSERT_EQ(file.syntax_errors.size(), 1U);
    EXPECT_EQ(file.syntax_errors[0].kind, SyntaxErrorKind::unterminated_comment);
    EXPECT_EQ(count_blocks(file.programs.at(0)), (blocks.size() - 24) / 9);
}

} // namespace
} // namespace maclint
