//! Names and calls are the same whether a file was read whole or only for them.
#include "analyzer/dialect/dialect.hpp"
#include "analyzer/workspace/outline.hpp"

#include <filesystem>
#include <memory>
#include <ostream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
void PrintTo(const FileOutline& file, std::ostream* out) {
    for (const ProgramOutline& program : file.programs) {
        *out << "\n";
        for (const std::string& name : program.names) *out << name << " ";
        *out << "calls";
        for (const CallOutline& call : program.calls) {
            *out << (call.is_computed() ? " computed" : "");
            if (const auto* number = std::get_if<std::int64_t>(&call.program)) *out << " " << *number;
            if (const auto* name = std::get_if<std::string>(&call.program)) *out << " " << *name;
        }
    }
}

namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

struct Read {
    FileOutline outline;
    std::size_t effects = 0;
};

Read read(const Source& source, const Dialect& dialect, Extent extent) {
    const ProgramFile file =
        dialect.read(std::make_shared<const Source>(source), *find_control(dialect.default_control), extent);
    const FileOutline outline = outline_of(file);
    std::vector<ProgramOutline> programs(outline.programs.begin(), outline.programs.end());
    for (ProgramOutline& program : programs) // a call without a program connects nothing
        std::erase_if(program.calls, [](const CallOutline& call) {
            return std::holds_alternative<std::monostate>(call.program);
        });
    Read read{{outline.path, ProgramOutlines(std::move(programs))}};
    for (const Program& program : file.programs) read.effects += program.effects.size();
    return read;
}

Read read(std::string path, std::string_view text, std::string_view dialect, Extent extent) {
    return read(Source::from_bytes(std::move(path), std::string(text)), *find_dialect(dialect), extent);
}

struct Compared {
    std::size_t files = 0, effects_of_all = 0, effects_for_names = 0;
};

/// Compares both outlines of every NC file below the folder.
Compared compare_below(const fs::path& folder) {
    Compared compared;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file() || !has_nc_extension(entry.path().string())) continue;
        const auto opened = Source::read_file(entry.path().string());
        const Source& source = std::get<Source>(opened);
        const Dialect* dialect = detect_dialect(source).dialect;
        if (dialect == nullptr) continue;
        const Read whole = read(source, *dialect, Extent::whole);
        const Read names = read(source, *dialect, Extent::names_and_calls);
        EXPECT_EQ(names.outline, whole.outline) << entry.path();
        ++compared.files;
        compared.effects_of_all += whole.effects;
        compared.effects_for_names += names.effects;
    }
    return compared;
}

TEST(Outline, HoldsNumbersNamesAndCalls) {
    const std::string_view text =
        "O0010(MAIN)\nG65P9000A1.\nM98P[#1]\nIF[#1EQ1]GOTO5\nM98<SUB>\nN5M30\n<SUB>\nM99\n";
    const FileOutline outline = read("shop/main.nc", text, "fanuc", Extent::names_and_calls).outline;
    ASSERT_EQ(outline.programs.size(), 2U);
    const ProgramOutline& main = outline.programs[0];
    EXPECT_EQ(main.number, 10);
    EXPECT_THAT(main.names, ElementsAre("MAIN", "O0010", "O10"));
    ASSERT_EQ(main.calls.size(), 3U);
    EXPECT_EQ(std::get<std::int64_t>(main.calls[0].program), 9000);
    EXPECT_TRUE(main.calls[1].is_computed());
    EXPECT_EQ(std::get<std::string>(main.calls[2].program), "<SUB>");
    EXPECT_THAT(outline.programs[1].names, ElementsAre("<SUB>", "SUB"));
}

TEST(Outline, AFileWithoutANumberHasAProgramThatIsNamedAfterIt) {
    for (const Extent extent : {Extent::whole, Extent::names_and_calls}) {
        const Read file = read("shop/O9010.nc", "#1=#2+1\nIF[#1GT5]GOTO3\nN3M99\n", "fanuc", extent);
        ASSERT_EQ(file.outline.programs.size(), 1U);
        EXPECT_EQ(file.outline.programs[0].number, 9010);
        EXPECT_THAT(file.outline.programs[0].names, ElementsAre("O9010"));
    }
    const Read din = read("shop/bore.ncs", "N1 #l1=5\nN2 IF #l1>4\n", "dinplus", Extent::names_and_calls);
    ASSERT_EQ(din.outline.programs.size(), 1U);
    EXPECT_THAT(din.outline.programs[0].names, ElementsAre("BORE", "BORE.NCS"));
}

TEST(Outline, SectionsAfterBlockNumbersBeginPrograms) {
    const std::string_view text =
        "MACHINING\nN1 #l1=5\nN2 L\"A\" V1\nN3 M30\nN4 SUBPROGRAM \"A\"\nN5 #l2=1\nN6 L\"B\"\nRETURN\n";
    EXPECT_EQ(read("a.nc", text, "dinplus", Extent::names_and_calls).outline,
              read("a.nc", text, "dinplus", Extent::whole).outline);
}

TEST(Outline, IsTheSameForOwnPrograms) {
    EXPECT_GT(compare_below(MACLINT_SOURCE_DIR "/tests/fixtures").files, 80U);
    const Compared compared = compare_below(MACLINT_SOURCE_DIR "/corpus");
    EXPECT_GT(compared.files, 50U);
    EXPECT_LT(compared.effects_for_names * 2, compared.effects_of_all); // most of a macro is passed over
}

TEST(Outline, IsTheSameForProgramsOfOthers) {
    if (!fs::exists(fs::path(MACLINT_SHARED))) GTEST_SKIP() << "there is nothing at " << MACLINT_SHARED;
    EXPECT_GT(compare_below(MACLINT_SHARED).files, 500U);
}

/// Texts that nobody wrote: pieces of blocks in any order.
TEST(Outline, IsTheSameForNoise) {
    const std::vector<std::string_view> pieces = {"O12",   "\n",
                                                  "\n",    "M98",
                                                  "P34",   "<A>",
                                                  "(P5)",  "#1=",
                                                  "[",     "]",
                                                  "G65",   "%\n",
                                                  "N5",    " ",
                                                  "IF",    ";",
                                                  "M99",   "L\"A\"",
                                                  "M30\n", "P#1",
                                                  "+",     "L",
                                                  "X1.",   "MACHINING\n",
                                                  "END\n", "SUBPROGRAM \"A\"\n",
                                                  "$1",    "/",
                                                  "(",     ")",
                                                  "V1",    "GOTO",
                                                  "#l1",   "L#l1"};
    std::mt19937 random(7);
    for (int text = 0; text < 3000; ++text) {
        std::string noise;
        for (int i = 0; i < 40; ++i) noise += pieces[random() % pieces.size()];
        for (const std::string_view dialect : {"fanuc", "dinplus"})
            ASSERT_EQ(read("a/O7.nc", noise, dialect, Extent::names_and_calls).outline,
                      read("a/O7.nc", noise, dialect, Extent::whole).outline)
                << dialect << ":\n"
                << noise;
    }
}

} // namespace
} // namespace maclint
