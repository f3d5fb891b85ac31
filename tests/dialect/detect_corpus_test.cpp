//! The programs of other people, the seeds and the manual's examples: what every one of them is, by folder
//! and, for the odd ones, by name. Each row stands for what a look at the files showed.
#include "tests/dialect/detecting.hpp"

#include <filesystem>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace maclint {
namespace {

namespace fs = std::filesystem;
using test::reported;

struct Kind {
    std::string_view folder; ///< beginning of the path
    std::string_view name;   ///< part of the path; empty for all others of the folder
    std::string_view reported;
};

// The first row that fits counts.
// clang-format off
constexpr std::string_view hobby = "G-code for LinuxCNC, GRBL, a 3D printer or the like";
constexpr Kind kinds[] = {
    {"corpus/fanuc-macro/treyne__CNC-macros",          "",                      "wire erosion"},
    {"corpus/fanuc-macro",                             "",                      "fanuc"},
    // An engraving, a pocket and a drag knife's path, as LinuxCNC and its relatives name their files.
    {"corpus/fanuc-plain",                             ".ngc",                  "LinuxCNC"},
    {"corpus/fanuc-plain/graelo__gcode-language-server", "complex_cnc",         hobby},
    {"corpus/fanuc-plain/graelo__gcode-language-server", "",                    "a 3D printer"},
    // The raw output of a CAM system: remarks after ';' and prose.
    {"corpus/fanuc-plain/karlo-c277__APT-Gcode",       "",                      hobby},
    {"corpus/fanuc-plain/placrosse__tree-sitter-gcode", "basic.gcode",          hobby},
    {"corpus/fanuc-plain",                             "",                      "fanuc"},
    {"corpus/heidenhain-tnc",                          "",                      "HEIDENHAIN Klartext"},
    {"corpus/linuxcnc",                                "",                      "LinuxCNC"},
    {"corpus/sinumerik",                               "",                      "sinumerik"},
    // One or two blocks that any control would take: nothing in them tells.
    {"reference/dinplus-examples",                     "010-block-allowed.nc",  "fanuc"},
    {"reference/dinplus-examples",                     "011-block-forbidden.nc", "fanuc"},
    {"reference/dinplus-examples",                     "",                      test::din_plus},
    {"reference/seed-programs",                        ".mpf",                  "sinumerik"},
    {"reference/seed-programs",                        "O9601.",                "nct"},
    // The other NCT programs are Fanuc code to the letter, or nearly.
    {"reference/seed-programs",                        "",                      "fanuc"},
    // Our own fixtures.
    {"tests/fixtures/dinplus/programs",                "",                      test::din_plus},
    {"tests/fixtures/dinplus/bad-input",               "utf16-le.nc",           "UTF-16 text, which no control reads"},
    {"tests/fixtures/dinplus/bad-input",               "png-header.ncs",        "a binary file"},
    {"tests/fixtures/dinplus/bad-input",               "all-bytes.nc",          "a binary file"},
    {"tests/fixtures/dinplus/bad-input",               "noise.nc",              "a binary file"},
    {"tests/fixtures/dinplus/bad-input",               "only-comment.nc",       "text of another kind"},
    {"tests/fixtures/dinplus/bad-input",               "note.txt",              "text of another kind"},
    {"tests/fixtures/dinplus/bad-input",               "iso-program.nc",        "fanuc"},
    {"tests/fixtures/dinplus/bad-input",               "",                      test::din_plus},
    {"tests/fixtures/bad-input",                       "klartext",              "HEIDENHAIN Klartext"},
    {"tests/fixtures/bad-input",                       "json.nc",               "JSON"},
    {"tests/fixtures/bad-input",                       "c-source.nc",           "C source"},
    {"tests/fixtures/bad-input",                       "utf16-le.nc",           "UTF-16 text, which no control reads"},
    {"tests/fixtures/bad-input",                       "png-header.nc",         "a binary file"},
    {"tests/fixtures/bad-input",                       "all-bytes.nc",          "a binary file"},
    {"tests/fixtures/bad-input",                       "",                      "fanuc"},
};
// clang-format on

const Kind* find_kind(std::string_view path) {
    for (const Kind& kind : kinds)
        if (path.starts_with(kind.folder) && path.find(kind.name) != std::string_view::npos) return &kind;
    return nullptr;
}

/// Detects every program under `root/folder`; gives how many there were.
std::size_t expect_kinds(const fs::path& root, const char* folder) {
    std::size_t files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
        const std::string extension = entry.path().extension().string();
        if (!entry.is_regular_file() || extension == ".md" || extension == ".json" || extension == ".tsv")
            continue;
        const std::string path = fs::relative(entry.path(), root).generic_string();
        const Kind* kind = find_kind(path);
        if (kind == nullptr) continue;
        const auto source = Source::read_file(entry.path().string());
        const Detection detection = detect_dialect(std::get<Source>(source));
        EXPECT_EQ(reported(detection), kind->reported) << path << ": " << detection.reason;
        ++files;
    }
    return files;
}

TEST(DetectionOfFiles, EveryFixtureIsWhatItWasWrittenToBe) {
    EXPECT_GT(expect_kinds(MACLINT_SOURCE_DIR, "tests/fixtures"), 100U);
}

TEST(DetectionOfFiles, EveryFileOfTheOuterCorpusIsWhatItIs) {
    if (!fs::exists(fs::path(MACLINT_SHARED) / "corpus"))
        GTEST_SKIP() << "the outer corpus is not at " << MACLINT_SHARED;
    EXPECT_GT(expect_kinds(MACLINT_SHARED, "corpus"), 850U);
}

TEST(DetectionOfFiles, EveryProgramOfTheReferenceIsWhatItIs) {
    if (!fs::exists(fs::path(MACLINT_SHARED) / "reference"))
        GTEST_SKIP() << "the reference is not at " << MACLINT_SHARED;
    EXPECT_GT(expect_kinds(MACLINT_SHARED, "reference"), 290U);
}

} // namespace
} // namespace maclint
