//! Blanks by choice: what changes, what stays, and that no program says anything else with them.
#include "analyzer/program/dump.hpp"
#include "analyzer/source/source.hpp"
#include "cli/format/spacing.hpp"
#include "cli/input/discover.hpp"
#include "tests/support/linted.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;
using cli::Blanks;
using cli::SpacingChoice;

constexpr SpacingChoice apart{Blanks::one, Blanks::one, Blanks::none};
constexpr SpacingChoice close{Blanks::none, Blanks::none, Blanks::none};

ProgramFile read(const Dialect& dialect, std::string text) {
    auto source = std::make_shared<const Source>(Source::from_bytes("O1.nc", std::move(text)));
    return dialect.read(source, *find_control(dialect.default_control), Extent::whole);
}

std::string formatted(const Dialect& dialect, const std::string& text, const SpacingChoice& choice,
                      Span part) {
    const ProgramFile file = read(dialect, text);
    std::string out;
    Offset copied = 0;
    for (const Edit& edit : cli::spacing_edits(file, dialect, choice, part)) {
        out.append(file.source->bytes().substr(copied, edit.span.begin - copied)).append(edit.text);
        copied = edit.span.end;
    }
    return out.append(file.source->bytes().substr(copied));
}

std::string formatted(std::string_view dialect, const std::string& text, const SpacingChoice& choice) {
    return formatted(*find_dialect(dialect), text, choice, {0, static_cast<Offset>(text.size())});
}

TEST(Spacing, StandsBetweenWordsAndOperatorsOfAMacro) {
    const std::string close_one = "N10G65P9100X#1(A  B)\n#1=[#2+3]*[ #4 ]\nIF[#1EQ2]GOTO20\n";
    const std::string apart_one = "N10 G65 P9100 X#1(A  B)\n#1 = [#2 + 3] * [#4]\nIF [#1 EQ 2] GOTO20\n";
    EXPECT_EQ(formatted("fanuc", close_one, apart), apart_one);
    EXPECT_EQ(formatted("fanuc", apart_one, close),
              "N10G65P9100X#1(A  B)\n#1=[#2+3]*[#4]\nIF[#1EQ2]GOTO20\n");
}

TEST(Spacing, IsLeftAsItIsWhereNobodyHasChosen) {
    const std::string text = "N10  G1X5.\n#1 = [ 2+3 ]\n";
    EXPECT_EQ(formatted("fanuc", text, {}), text);
    EXPECT_EQ(formatted("fanuc", text, {.operators = Blanks::none}), "N10  G1X5.\n#1=[ 2+3 ]\n");
    EXPECT_EQ(formatted("fanuc", text, {.brackets = Blanks::none}), "N10  G1X5.\n#1 = [2+3]\n");
}

TEST(Spacing, ChangesOnlyBlocksOfThePart) {
    const std::string text = "N10G1X5.\nN20G1X6.\nN30G1X7.\n";
    EXPECT_EQ(formatted(*find_dialect("fanuc"), text, apart, {10, 12}), "N10G1X5.\nN20 G1 X6.\nN30G1X7.\n");
}

TEST(Spacing, LeavesTextsRemarksMarksAndMistakes) {
    for (const std::string text :
         {"DPRNT[ X#1[53]  Y ]\n", "/1N10G1X5.,R2.\n", "G1 X Y10.\n", "G1 XO. Y--5.\n"}) {
        const std::string rest = formatted("fanuc", text, apart);
        EXPECT_EQ(formatted("fanuc", rest, apart), rest);
    }
    EXPECT_EQ(formatted("fanuc", "DPRNT[ X#1[53]  Y ]\n", close), "DPRNT[ X#1[53]  Y ]\n");
    EXPECT_EQ(formatted("fanuc", "/1N10G1X5.,R2.\n", apart), "/1N10 G1 X5.,R2.\n");
    EXPECT_EQ(formatted("sinumerik", "MSG(\"A  B\")   ; X   Y\n", close), "MSG(\"A  B\")   ; X   Y\n");
}

TEST(Spacing, LeavesABlockThatWouldBeReadInAnotherWay) {
    EXPECT_EQ(formatted("fanuc", "G1 X5.\nG1 X#_A B1.\n", close), "G1X5.\nG1 X#_A B1.\n");
    EXPECT_EQ(formatted("fanuc", "#1 = 2 - -#2\n", close), "#1=2- -#2\n");
}

TEST(Spacing, GluesNoNamesOfSinumerik) {
    EXPECT_EQ(formatted("sinumerik", "R1=R2 + R3 DIV R4\n", close), "R1=R2+R3 DIV R4\n");
    EXPECT_EQ(formatted("sinumerik", "N10 G1 X10 Y20 F100\n", close), "N10G1X10Y20F100\n");
    for (const std::string text :
         {"G1 X=R1\n", "G1 X=R1 Y=R2\n", "R1=R2 DIV R3\n", "SUPA G0 X1=10\n", "L100 P3\n"})
        EXPECT_EQ(formatted("sinumerik", text, close), text);
    EXPECT_EQ(formatted("sinumerik", "R1=R2+R3*2\n", apart), "R1=R2 + R3 * 2\n");
    EXPECT_EQ(formatted("sinumerik", "IF (R1<5)AND( R2>6 ) GOTOF ENDE\nENDE:\n", apart),
              "IF (R1 < 5) AND (R2 > 6) GOTOF ENDE\nENDE:\n");
}

TEST(Spacing, GluesNoNamesOfDinPlus) {
    const auto in_section = [](const std::string& block) {
        return "%a.nc\nBEARBEITUNG\n" + block + "ENDE\n";
    };
    EXPECT_EQ(formatted("dinplus", in_section("N1 G1 X10 Z-5\n"), close), in_section("N1G1X10Z-5\n"));
    EXPECT_EQ(formatted("dinplus", in_section("N1 G1 X#_a Z10\n"), close), in_section("N1G1 X#_a Z10\n"));
    EXPECT_EQ(formatted("dinplus", in_section("N1 #l1=#l2+3\n"), apart), in_section("N1 #l1 = #l2 + 3\n"));
    EXPECT_EQ(formatted("dinplus", in_section("N1 G1X#l1+3Z5\n"), apart), in_section("N1 G1 X#l1+3 Z5\n"));
}

std::vector<std::string> lines_and_codes(const cli::Result& result) {
    std::vector<std::string> all;
    for (const cli::FilteredFinding& filtered : result.findings) {
        const Finding& finding = filtered.finding;
        all.push_back(std::to_string(finding.source->position(finding.span.begin).line) + " " +
                      std::string(finding.rule->code));
    }
    std::ranges::sort(all);
    return all;
}

/// Texts of our own, of all dialects, and of others where they are there.
std::vector<fs::path> programs() {
    std::vector<fs::path> all;
    for (const fs::path& folder :
         {fs::path(MACLINT_SOURCE_DIR) / "corpus", fs::path(MACLINT_SHARED) / "corpus"}) {
        if (!fs::exists(folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(folder))
            if (entry.is_regular_file() && entry.file_size() < 20'000) all.push_back(entry.path());
    }
    std::ranges::sort(all);
    return all;
}

TEST(Spacing, ChangesNoMeaningAndNoFinding) {
    std::size_t changed = 0, tried = 0, kept = 0;
    for (const fs::path& path : programs()) {
        std::ifstream in(path, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        const Detection detection = detect_dialect(Source::from_bytes(path.string(), text));
        if (detection.dialect == nullptr || detection.not_nc_text || ++tried % 7 != 0) continue;
        const Dialect& dialect = *detection.dialect;
        for (const SpacingChoice& choice : {apart, close}) {
            const std::string after = formatted(dialect, text, choice, {0, static_cast<Offset>(text.size())});
            if (after == text) {
                ++kept;
                continue;
            }
            ++changed;
            EXPECT_EQ(describe(read(dialect, after)), describe(read(dialect, text))) << path;
            EXPECT_EQ(formatted(dialect, after, choice, {0, static_cast<Offset>(after.size())}), after)
                << path;
            cli::Overrides overrides;
            overrides.dialect = &dialect;
            EXPECT_EQ(lines_and_codes(lint_texts({{"O1.nc", after}}, overrides)),
                      lines_and_codes(lint_texts({{"O1.nc", text}}, overrides)))
                << path;
        }
    }
    EXPECT_GT(changed, 20U);
    EXPECT_LT(kept, changed) << "most programs have blanks to choose";
}

} // namespace
} // namespace maclint::test
