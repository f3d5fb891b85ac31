//! Pages of codes: `maclint explain G860`, and the chapters that `rules --write-codes` writes.
#include "cli/report/code_page.hpp"
#include "rules/words/word_list.hpp"
#include "tests/support/in_repository.hpp"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

namespace fs = std::filesystem;

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class CodePages : public InRepository {};

TEST_F(CodePages, TellWordsPlaceRulesAndSource) {
    const Finished page = run({"explain", "g0895", "--dialect", "dinplus"});
    EXPECT_EQ(page.status, 0);
    EXPECT_THAT(page.out,
                AllOf(StartsWith("G895 "), HasSubstr("(dinplus, turning cycles)\n"),
                      HasSubstr("Where it may stand:\n\n    MACHINING and SUBPROGRAM\n"),
                      ContainsRegex("\n    V: [^\n]+ \\(0, 1, 2, 3 or 4"), HasSubstr("    MAC576/G895.V: "),
                      HasSubstr("    MAC581/G895: "), HasSubstr("Source:\n\n    HEIDENHAIN, ")));
}

TEST_F(CodePages, AreThoseOfEachPlaceOfACode) {
    const std::string page = run({"explain", "G1", "--dialect", "dinplus"}).out;
    EXPECT_THAT(page, AllOf(HasSubstr("(dinplus, contour of the part)"),
                            HasSubstr("(dinplus, moves, feeds and speeds)")));
}

TEST_F(CodePages, TellOfSections) {
    for (const std::string name : {"CHUCKING EQUIPMENT", "chucking_equipment"})
        EXPECT_THAT(run({"explain", name}).out,
                    AllOf(ContainsRegex("\n    Q: [^\n]+ \\(4 or 5\\)"),
                          HasSubstr("DIN109 section-parameter"), Not(HasSubstr("Where it may stand"))));
}

TEST_F(CodePages, AreThoseOfEveryLanguageMachineAndMaker) {
    EXPECT_THAT(run({"explain", "G83"}).out,
                AllOf(HasSubstr("(dinplus, "), HasSubstr("(FANUC mills, canned cycles of mills)"),
                      HasSubstr("(FANUC lathes, "), HasSubstr("(Haas mills, "), HasSubstr("MAC523/G83.Q")));
    EXPECT_THAT(run({"explain", "G83", "--dialect", "dinplus"}).out, Not(HasSubstr("FANUC")));
    EXPECT_THAT(run({"explain", "G83", "--dialect", "fanuc"}).out,
                AllOf(HasSubstr("MAC523/G83.Q"), Not(HasSubstr("(dinplus"))));
}

TEST_F(CodePages, AreThoseOfOneControl) {
    const std::string page = run({"explain", "G83", "--control", "fanuc-30i"}).out;
    EXPECT_THAT(page, AllOf(StartsWith("G83 "),
                            HasSubstr("(FANUC Series 30i/31i/32i, mill, canned cycles of mills)"),
                            HasSubstr("In force:\n\n    canned cycle, until G73, "),
                            HasSubstr("(alarm 045 on FANUC 30i/0i-D)"), Not(HasSubstr("Haas")),
                            Not(HasSubstr("only on"))));
    EXPECT_THAT(run({"explain", "G83", "--control", "fanuc-16i"}).out, Not(HasSubstr("alarm 045")));
    const Finished unknown = run({"explain", "G999", "--control", "fanuc-16i"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.err, HasSubstr("no such code or alarm of that control"));
}

TEST_F(CodePages, TellTheSystemsOfLathes) {
    EXPECT_THAT(run({"explain", "G92", "--control", "fanuc-16i-lathe"}).out, HasSubstr("G code system A"));
    EXPECT_THAT(run({"explain", "G76"}).out, HasSubstr("(FANUC lathes, system A or B, "));
}

TEST_F(CodePages, AreNoneForWordsThatAreNoCodes) {
    EXPECT_EQ(run({"explain", "G999999", "--dialect", "dinplus"}).status, 2);
    EXPECT_EQ(run({"explain", "G"}).status, run({"explain", "G", "--dialect", "dinplus"}).status);
    const Finished unknown = run({"explain", "G860", "--dialect", "dinplsu"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.err, HasSubstr("Did you mean 'dinplus'?"));
}

TEST_F(CodePages, HoldEveryWordOfTheirCodes) {
    for (const CodePage& page : all_code_pages()) {
        const std::string text = cli::plain_code_page(page, nullptr, {});
        for (const BookLine& line : page.lines) {
            if (line.kind != BookLine::Kind::word) continue;
            EXPECT_THAT(
                text, HasSubstr("\n    " + std::string(line.row.words) + ": " + std::string(line.row.means)));
        }
    }
}

TEST_F(CodePages, AreWrittenByChapters) {
    ASSERT_EQ(run({"rules", "--write-codes", "codes"}).status, 0);
    folder.write("codes/dinplus/gone.md", "a chapter of before");
    ASSERT_EQ(run({"rules", "--write-codes", "codes"}).status, 0);
    EXPECT_FALSE(fs::exists(folder.path() / "codes/dinplus/gone.md"));
    const std::string index = read_file(folder.path() / "codes/dinplus/README.md");
    for (const CodePage& page : all_code_pages()) {
        const fs::path codes = folder.path() / "codes" / std::string(page.book->language);
        const std::string file = cli::chapter_file(*page.book);
        EXPECT_THAT(page.book->language == "dinplus" ? index : read_file(codes / "README.md"),
                    HasSubstr("| " + all_of(page.head->row.code) + " | " + std::string(page.head->row.means) +
                              " | ["));
        EXPECT_TRUE(fs::exists(codes / file)) << file;
    }
    EXPECT_THAT(read_file(folder.path() / "codes/dinplus/turning-cycles.md"),
                AllOf(StartsWith("# turning cycles\n"), HasSubstr("\n## G860 "),
                      ContainsRegex("\n. V . [^|\n]+ . 0, 1, 2, 3 or 4[^|\n]* . [0-9]+ .\n"),
                      HasSubstr("`MAC576/G895.V`")));
}

TEST_F(CodePages, AreNotWrittenIntoAFolderOfSomebodyElse) {
    folder.write("codes/dinplus/README.md", "# Notes of the shop\n");
    EXPECT_EQ(run({"rules", "--write-codes", "codes"}).status, 2);
    EXPECT_EQ(read_file(folder.path() / "codes/dinplus/README.md"), "# Notes of the shop\n");
}

} // namespace
} // namespace maclint::test
