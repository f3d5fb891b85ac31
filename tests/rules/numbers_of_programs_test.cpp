//! Numbers of programs and blocks that a control cannot have, or has already.
#include "tests/rules/raised.hpp"
#include "tests/support/linted.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// "O2.nc:1 error MAC453"
std::vector<std::string> judged_in(std::string_view code, const std::vector<LintedText>& texts,
                                   std::string_view control, bool complete = false) {
    static constexpr const char* names[] = {"note", "warning", "error"};
    cli::Overrides overrides;
    overrides.dialect = find_dialect("fanuc");
    if (control != "fanuc") overrides.control = control;
    overrides.select = {std::string(code)};
    if (complete) overrides.complete = true;
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] : lint_texts(texts, std::move(overrides)).findings)
        all.push_back(finding.source->path() + ":" +
                      std::to_string(finding.source->position(finding.span.begin).line) + " " +
                      names[static_cast<int>(finding.severity)]);
    return all;
}

const std::string plate = "O1001(PLATE)\nG0X1.\nM30\n";
const std::string spare = "%\nO1001(SPARE)\nG0X2.\nM30\n%\n";
const std::string other = "O1002\nG0X1.\nM30\n";

TEST(FileAndNumber, AreTwoProgramsWhereTheyDiffer) {
    EXPECT_THAT(judged_in("MAC471", {{"cnc/O1002.nc", plate}}, "fanuc-16i"),
                ElementsAre("cnc/O1002.nc:1 note"));
    for (const char* const name :
         {"O1001.nc", "O01001", "o1001.txt", "PLATE.nc", "O1002-NEW.nc", "1002.nc", "O1.nc"})
        EXPECT_THAT(judged_in("MAC471", {{name, plate}}, "fanuc-16i"), IsEmpty()) << name;
    EXPECT_THAT(judged_in("MAC471", {{"O1002.nc", plate + other}}, "fanuc-16i"), IsEmpty()) << "several";
}

TEST(ProgramNumberInTwoFiles, IsToldWhereFilesBearTheirNumbersAsNames) {
    EXPECT_THAT(judged_in("MAC453", {{"cnc/O1001.nc", plate}, {"cnc/SPARE.nc", spare}}, "fanuc-16i"),
                ElementsAre("cnc/SPARE.nc:2 error"));
    EXPECT_THAT(judged_in("MAC453", {{"cnc/O1001.nc", plate}, {"cnc/SPARE.nc", spare}}, "fanuc"),
                ElementsAre("cnc/SPARE.nc:2 warning"));
}

TEST(ProgramNumberInTwoFiles, IsNothingInOtherFoldersVersionsAndCopiesOfAMemory) {
    EXPECT_THAT(judged_in("MAC453", {{"a/O1001.nc", plate}, {"b/SPARE.nc", spare}}, "fanuc-16i"), IsEmpty());
    EXPECT_THAT(judged_in("MAC453", {{"a/O1001.nc", plate}, {"a/O1001_OLD.nc", spare}}, "fanuc-16i"),
                IsEmpty());
    EXPECT_THAT(judged_in("MAC453", {{"a/O1001.nc", plate}, {"a/ALL-PROG.TXT", spare + other}}, "fanuc-16i"),
                IsEmpty());
    EXPECT_THAT(judged_in("MAC453", {{"a/PLATE.nc", plate}, {"a/SPARE.nc", spare}}, "fanuc-16i"), IsEmpty());
}

TEST(ProgramNumberInTwoFiles, IsNothingWhereMostNumbersAreThereTwice) {
    std::vector<LintedText> texts;
    for (int i = 1001; i < 1011; ++i) {
        const std::string text = "O" + std::to_string(i) + "\nG0X1.\nM30\n";
        texts.push_back({"a/O" + std::to_string(i) + ".nc", text});
        texts.push_back({"a/PART" + std::string(1, static_cast<char>('A' + i - 1001)) + ".nc", text});
    }
    EXPECT_THAT(judged_in("MAC453", texts, "fanuc-16i"), IsEmpty());
}

TEST(ProgramNumberInOneFile, IsToldOnceForEachFolderOfTheControl) {
    EXPECT_THAT(judged_in("MAC453", {{"X.nc", plate + other + plate}}, "fanuc-30i"),
                ElementsAre("X.nc:7 error"));
    EXPECT_THAT(judged_in("MAC453", {{"X.nc", "&F=/A/\n" + plate + "&F=/B/\n" + plate}}, "fanuc-30i"),
                IsEmpty());
    EXPECT_THAT(judged_in("MAC453", {{"X.nc", "O1001\n" + plate}}, "fanuc-30i"), IsEmpty()) << "a head alone";
}

TEST(BlockNumbers, AreHeldAgainstTheSeries) {
    const std::string text = "O1\nN99999G0X1.\nN100000X2.\nN100001X3.\nM30\n";
    EXPECT_THAT(judged_in("MAC464", {{"X.nc", text}}, "fanuc-16i"), ElementsAre("X.nc:3 error"));
    EXPECT_THAT(judged_in("MAC464", {{"X.nc", text}}, "fanuc-30i"), IsEmpty());
    EXPECT_THAT(judged_in("MAC464", {{"X.nc", text}}, "fanuc"), IsEmpty()) << "it may be a 30i";
    EXPECT_THAT(judged_in("MAC464", {{"X.nc", "O1\nN123456789G0X#1\nM30\n"}}, "fanuc"),
                ElementsAre("X.nc:2 warning"));
}

TEST(BlockNumbers, ZeroIsToldOnceAProgramAmongPlainBlocksToo) {
    EXPECT_THAT(judged("MAC463", "O1\nN0G0X1.\nN00X2.\nN10X3.\nM30\n"), ElementsAre("warning 2"));
    EXPECT_THAT(judged("MAC463", "O1\nN0#1=5\nN10X3.\nM30\n"), ElementsAre("warning 2"));
}

TEST(BlockNumbers, BehindAMacroCallAreArguments) {
    EXPECT_THAT(judged("MAC465", "O1\nG65P9001N5\nM30\n"), IsEmpty());
    EXPECT_THAT(judged("MAC465", "O1\n/2N5M9\nM30\n"), IsEmpty());
    EXPECT_THAT(judged("MAC465", "O1\nX8.\nM1N02\nM30\n"), ElementsAre("note 3"));
}

TEST(TextBehindTheTape, IsToldWhereNoMarkOpensAnotherOne) {
    EXPECT_THAT(lines_raised("MAC112", "%\nO1\nM30\n%\nO2\nM99\n%\n"), ElementsAre(5));
    EXPECT_THAT(lines_raised("MAC112", "%\nO1\nM30\n%\n(NOTES)\nG0X1.\n"), ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC112", "%\nO1\nM30\n%\n%\nO2\nM99\n%\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC112", "%\nO1\nM30\n%\nMADE BY HAND\n(50 FEET)\n"), IsEmpty());
}

TEST(PercentSigns, InCommentsAreTold) {
    EXPECT_THAT(lines_raised("MAC125", "%\nO1(A)(50%)\nG0X1.(10%)(20%)\nM30\n%\n"), ElementsAre(2, 3, 3));
}

TEST(SmallLettersAndBlanks, AreToldOnceAFileWhereSomebodyAsks) {
    EXPECT_THAT(lines_raised("MAC104", "O1(first)\nG0X1.\ng1x2.(small)\nz3.\nM30\n"), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC115", "O1\nG0 X 1.\nX1 0.(A 1 0)\nX2 0.\nM30\n"), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC115", "O1\n/2 G0 X1.\nM30\n"), IsEmpty());
}

} // namespace
} // namespace maclint::test
