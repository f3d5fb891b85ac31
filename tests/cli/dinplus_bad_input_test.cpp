//! What bad input in DIN PLUS gets from the executable. The neighbour is a Fanuc program: one run lints both.
#include "tests/support/bad_input.hpp"

#include <random>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ElementsAre;
using testing::EndsWith;
using testing::IsEmpty;

class BadDinPlus : public BadInput {
  protected:
    /// Findings in the bytes as a file of that name, which is linted without a word on standard error.
    [[nodiscard]] std::vector<std::string> findings_in(const std::string& name,
                                                       std::string_view bytes) const {
        folder.write(name, bytes);
        const Finished finished = lint({"."});
        EXPECT_EQ(finished.status, 1);
        EXPECT_THAT(finished.err, IsEmpty());
        return codes(finished, name);
    }
    [[nodiscard]] std::vector<std::string> findings_in_fixture(const std::string& name) const {
        const fs::path fixtures = fs::path(MACLINT_SOURCE_DIR) / "tests/fixtures/dinplus/bad-input";
        return findings_in(name, read_file(fixtures / name));
    }
};

TEST_F(BadDinPlus, UnclosedCommentToTheEndOfTenMegabytes) {
    const std::string text =
        "%part.nc\nMACHINING\nN1 G0 X1\n[open\n" + repeated("never closed again\n", 10'000'000);
    EXPECT_THAT(findings_in("part.nc", text), Contains("4:1 MAC102"));
}

TEST_F(BadDinPlus, SeventyThousandCommentsInOneBlock) {
    std::string comments;
    for (int i = 0; i < 70'000; ++i) comments += "[]";
    for (const std::string& block :
         {"N1 G1 X5 " + comments, comments + "N1 G1 X5", "N1 G1 " + comments + "X5"})
        EXPECT_THAT(findings_in("part.nc", "%part.nc\nMACHINING\n" + block + "\nN2 #l1==5\nN3 M30\nEND\n"),
                    ElementsAre("3:1 MAC004", "4:7 DIN326"));
}

TEST_F(BadDinPlus, StringOverALineEnd) {
    EXPECT_THAT(findings_in_fixture("string-over-line-end.nc"), ElementsAre("20:11 MAC121"));
}

TEST_F(BadDinPlus, SectionWordTwice) {
    EXPECT_THAT(findings_in_fixture("section-twice.nc"),
                ElementsAre("12:1 DIN106", "25:1 DIN106", "29:1 DIN103"));
}

TEST_F(BadDinPlus, HalfAProgram) {
    EXPECT_THAT(findings_in_fixture("half-a-program.nc"), ElementsAre("17:1 DIN102"));
}

TEST_F(BadDinPlus, SubprogramFileWithoutSubprogram) {
    EXPECT_THAT(findings_in_fixture("without-frame.ncs"), ElementsAre("3:8 DIN331", "3:14 DIN331"));
}

TEST_F(BadDinPlus, CallOfAFolder) {
    fs::create_directory(folder.path() / "PART.ncs");
    EXPECT_THAT(
        findings_in("main.nc", "MACHINING\nN1 L\"PART\" V1\nN2 L\"PART.ncs\" V1\nN3 L\"..\" V1\nEND\n"),
        IsEmpty());
}

TEST_F(BadDinPlus, MegabyteOfNoiseBetweenTwoGoodPrograms) {
    std::mt19937 random(5);
    std::string noise(1'000'000, '\n');
    for (char& c : noise)
        if (const auto pick = static_cast<char>(random() % 96); pick != 95) c = static_cast<char>(' ' + pick);
    const std::string good = "%part.nc\nMACHINING\nN1 #l1==5\nN2 M30\nEND\n"; // == assigns nothing: DIN326
    const std::vector<std::string> found = findings_in("part.nc", good + noise + '\n' + good);
    EXPECT_THAT(found, Contains("3:7 DIN326"));
    EXPECT_THAT(found, Contains(EndsWith(":7 DIN326")).Times(testing::Ge(2)));
}

TEST_F(BadDinPlus, ForeignCodePage) { EXPECT_THAT(findings_in_fixture("code-page-1251.nc"), IsEmpty()); }

} // namespace
} // namespace maclint::test
