//! SINUMERIK files: archives, names of programs, texts, remarks, and any bytes.
#include "tests/dialect/reading.hpp"

#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using ::testing::IsSupersetOf;

ProgramFile read(std::string_view text, std::string path) {
    return test::read_as("sinumerik", std::move(path), text);
}

TEST(SinumerikFiles, AFileIsAProgramOfItsName) {
    const ProgramFile file = read("G0 X1\nM17\n", "shop/SHAFT.SPF");
    ASSERT_EQ(file.programs.size(), 1U);
    EXPECT_EQ(file.programs[0].name, "SHAFT");
    EXPECT_THAT(file.programs[0].also_known_as, IsSupersetOf({"_N_SHAFT", "SHAFT_SPF", "_N_SHAFT_SPF"}));
    EXPECT_EQ(file.programs[0].started, Program::Started::by_call);
    EXPECT_EQ(read("M30\n", "A.MPF").programs.at(0).started, Program::Started::by_hand);
}

TEST(SinumerikFiles, AnArchiveHoldsSeveralPrograms) {
    const ProgramFile file =
        read("%_N_SHAFT_MPF\n;$PATH=/_N_WKS_DIR/_N_A_WPD\nM30\n%_N_POCKET_SPF\nM17\n", "A.ARC");
    ASSERT_EQ(file.programs.size(), 2U);
    EXPECT_EQ(file.programs[0].name, "SHAFT");
    EXPECT_EQ(file.programs[1].name, "POCKET");
    EXPECT_EQ(file.programs[1].started, Program::Started::by_call);
}

TEST(SinumerikFiles, DefinitionsAreNotRun) {
    EXPECT_EQ(read("DEF NCK REAL A_\nM17\n", "UGUD.DEF").programs.at(0).sections.at(0).executed,
              Section::Executed::never);
}

TEST(SinumerikFiles, ARemarkEndsWithItsLineUnlessATextHoldsItsSign) {
    const std::string lowered = test::lower(read("MSG(\"A;B\") ; C \"D\nR1=1\n", "A.SPF"));
    EXPECT_EQ(lowered, "exchange out \"A;B\"\nR1 := 1");
}

TEST(SinumerikFiles, AnyBytesAreRead) {
    std::minstd_rand random(7);
    constexpr std::string_view pieces[] = {
        "IF ",          "ENDIF",  "\n",     "R1",  "=",         "(",     ")",    "[",         "]",
        "\"",           ";",      "GOTOF ", "A_:", "%_N_A_MPF", "CASE ", " OF ", "DEF REAL ", ",",
        "\xEF\xBC\x9A", "G291\n", "'"};
    for (int round = 0; round < 300; ++round) {
        std::string text;
        for (int i = 0; i < 60; ++i) text += pieces[random() % std::size(pieces)];
        EXPECT_NO_THROW(static_cast<void>(read(text, "NOISE.SPF")));
    }
}

} // namespace
} // namespace maclint
