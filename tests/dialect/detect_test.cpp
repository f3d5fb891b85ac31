//! Which dialect a file is for, and what else it may be.
#include "analyzer/dialect/dialect.hpp"

#include <filesystem>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using ::testing::HasSubstr;

Detection detect(std::string path, std::string_view text) {
    return detect_dialect(Source::from_bytes(std::move(path), std::string(text)));
}

std::string_view dialect_of(const Detection& detection) {
    return detection.dialect ? detection.dialect->name : "";
}

TEST(Detection, FanucProgramsAreOursWhateverTheirExtension) {
    for (const char* path : {"O9100.nc", "O9100", "part.txt", "job.tap", "x.cnc"})
        EXPECT_EQ(dialect_of(detect(path, "%\nO9100(DRILL)\n#1=#2\nM99\n%")), "fanuc") << path;
    EXPECT_EQ(dialect_of(detect("x.nc", "(ONLY A COMMENT)\n")), "fanuc");
    EXPECT_EQ(dialect_of(detect("x.nc", "")), "fanuc");
}

TEST(Detection, NctIsToldByItsForms) {
    EXPECT_EQ(dialect_of(detect("x.nc", "%O9601(POCKET)\nG1ZI#23F#9\nM99%")), "nct");
    EXPECT_EQ(dialect_of(detect("x.nc", "%O9601(POCKET)\nG1Z#23F#9\nM99%")), "fanuc");
}

TEST(Detection, OtherControlsAreNamed) {
    EXPECT_THAT(detect("a.h", "0 BEGIN PGM DEMO MM\n1 TOOL CALL 5 Z S2000\n").reason, HasSubstr("Klartext"));
    EXPECT_THAT(detect("a.MPF", "G0 X10\nM30").reason, HasSubstr("SINUMERIK"));
    EXPECT_THAT(detect("a.nc", "DEF REAL DEPTH\nR1=5 R2=R1+3\nMSG(\"HELLO\")\nM17").reason,
                HasSubstr("SINUMERIK"));
    EXPECT_THAT(detect("a.ngc", "o100 sub\nG1 X#1\no100 endsub\n").reason, HasSubstr("LinuxCNC"));
    EXPECT_THAT(detect("a.nc", "PROGRAM HEAD\n#UNIT METRIC\nMACHINING\nN1 G0 X5\nEND").reason,
                HasSubstr("DIN PLUS"));
    for (const char* text : {"o100 sub\nG1 X#1\no100 endsub\n", "0 BEGIN PGM DEMO MM\n"}) {
        EXPECT_EQ(detect("a.nc", text).dialect, nullptr);
        EXPECT_FALSE(detect("a.nc", text).not_nc_text);
    }
}

TEST(Detection, WhatIsNoNcTextIsToldSo) {
    const auto expect_none = [](std::string_view text, std::string_view reason) {
        const Detection detection = detect("a.nc", text);
        EXPECT_EQ(detection.dialect, nullptr);
        EXPECT_TRUE(detection.not_nc_text);
        EXPECT_THAT(detection.reason, HasSubstr(std::string(reason)));
    };
    expect_none("{\"a\": 1}", "JSON");
    expect_none("#include <stdio.h>\nint main() {\n  return 0;\n}\n", "C source");
    expect_none("<?xml version=\"1.0\"?>\n<a/>", "XML");
    expect_none(std::string_view("\x7F"
                                 "ELF\x02\x01\x01\0\0\0\0\0\0\0\0\0\x03\0>\0\x01\0\0\0",
                                 24),
                "binary");
    expect_none("Dear customer,\nplease find attached the drawing.\nKind regards\n", "no NC program");
}

TEST(Detection, ExtensionsWorthOpening) {
    EXPECT_TRUE(has_nc_extension("parts/A.NC"));
    EXPECT_TRUE(has_nc_extension("O9100"));
    EXPECT_FALSE(has_nc_extension("README"));
    EXPECT_FALSE(has_nc_extension("a.cpp"));
}

TEST(Detection, EveryFanucFileOfTheOuterCorpusIsOurs) {
    const std::filesystem::path corpus = std::filesystem::path(MACLINT_SHARED) / "corpus";
    if (!std::filesystem::exists(corpus)) GTEST_SKIP() << "the outer corpus is not at " << corpus;
    const auto count = [&](const char* group, bool ours) {
        std::size_t wrong = 0;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(corpus / group)) {
            if (!entry.is_regular_file()) continue;
            const auto source = Source::read_file(entry.path().string());
            const Detection detection = detect_dialect(std::get<Source>(source));
            if ((detection.dialect != nullptr) != ours) ++wrong;
        }
        return wrong;
    };
    EXPECT_EQ(count("fanuc-macro", true), 9U); // nine wire-erosion programs stand among the macros
    EXPECT_EQ(count("fanuc-plain", true), 0U);
    EXPECT_EQ(count("sinumerik", false), 0U);
    EXPECT_EQ(count("heidenhain-tnc", false), 0U);
}

} // namespace
} // namespace maclint
