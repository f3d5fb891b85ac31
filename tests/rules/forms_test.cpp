//! Blocks that some controls of the family take and others stop at: what is told of them for which control.
#include "tests/support/linted.hpp"

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

cli::Result lint(std::string_view block, std::string_view control, std::vector<std::string> select = {}) {
    cli::Overrides overrides;
    overrides.control = std::string(control);
    if (!select.empty()) overrides.select = std::move(select);
    return test::lint_texts(
        {{"O1.nc", "O1\n#101=1\n#102=2\n" + std::string(block) + "\nG0X#101Y#102\nN5M30\n"}},
        std::move(overrides));
}

/// "error MAC106", for each finding in the block.
std::vector<std::string> told(std::string_view block, std::string_view control,
                              std::vector<std::string> select = {}) {
    static constexpr const char* severities[] = {"note", "warning", "error"};
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] : lint(block, control, std::move(select)).findings)
        if (finding.source->position(finding.span.begin).line == 4)
            all.push_back(std::string(severities[static_cast<int>(finding.severity)]) + " " +
                          std::string(finding.rule->code));
    return all;
}

/// The block after the fix of its first finding, and whether that is safe: "safe: G01".
std::string mended(std::string_view block) {
    const cli::Result result = lint(block, "fanuc-16i");
    if (result.findings.empty() || result.findings.front().finding.fixes.empty()) return "none";
    const Fix& fix = result.findings.front().finding.fixes.front();
    std::string text(fix.edits.front().source->bytes());
    for (auto edit = fix.edits.rbegin(); edit != fix.edits.rend(); ++edit)
        text.replace(edit->span.begin, edit->span.length(), edit->text);
    const std::string head = "O1\n#101=1\n#102=2\n";
    const std::string rest = text.substr(head.size());
    return (fix.applicability == Applicability::safe ? "safe: " : "unsafe: ") +
           rest.substr(0, rest.find('\n'));
}

std::string message(std::string_view block, std::string_view control) {
    const cli::Result result = lint(block, control);
    return result.findings.empty() ? "" : result.findings.front().finding.message();
}

struct Row {
    const char* block;
    const char* code;
};

// What every series of a Fanuc stops at.
constexpr Row refused[] = {
    {"X", "MAC109"},
    {"G1X Y10.F100", "MAC109"},
    {"G1XY10.F100", "MAC109"},
    {"G1XY-10.F100", "MAC109"},
    {"G1XY[#101-2]F100", "MAC109"},
    {"M6T", "MAC109"},
    {"M99P", "MAC109"},
    {"GO1X1.", "MAC106"},
    {"GO5", "MAC106"},
    {"G0TO5", "MAC106"},
    {"G1X1O.5F100", "MAC106"},
    {"G1R1O.F100", "MAC106"},
    {"G1AOF100", "MAC106"},
    {"G1R1OF100", "MAC106"},
    {"#101=1O", "MAC106"},
    {"#101=O.5", "MAC106"},
    {"#1O1=5", "MAC106"},
    {"IF[#101EQO]GOTO5", "MAC106"},
    {"IF[#101EQ O]GOTO5", "MAC106"},
    {"GOTO5O", "MAC106"},
    {"##101=5", "MAC206"},
    {"GOTO N5", "MAC305"},
    {"IF[#101EQ2]GOTON5", "MAC305"},
    {"GOTO5 G0X0", "MAC307"},
    {"IF[#101EQ2]GOTO5 M8", "MAC307"},
    {"IF[#101EQ2]THEN GOTO5 M8", "MAC307"},
    {"IF #101 EQ 5 GOTO5", "MAC324"},
    {"IF[#101LT0]#102=3", "MAC325"},
    {"IF[#101EQ2]G0TO5", "MAC118"},
    {"IF[#101LT0]M8", "MAC325"},
    {"IF[#101LT0]N005", "MAC325"},
    {"IF[#101LT0]IF[#102EQ2]GOTO5", "MAC325"},
    {"IF[#101LT0]", "MAC325"},
    {"IF[#101LT0]THEN", "MAC118"},
    {"IF[#101LT0]THEN#101=3 #102=4", "MAC326"},
    {"IF[#101LT0]THEN#101=3 M8", "MAC326"},
    {"IF[#101LT0]AND[#102EQ4]GOTO5", "MAC329"},
    {"IF[#101LT0]OR[#102EQ4]OR[#102EQ6]THEN#101=3", "MAC329"},
    {"G90 #101=5", "MAC332"},
    {"#101=5 G0X1.", "MAC332"},
    {"M8 GOTO5", "MAC332"},
    {"M8 IF[#101EQ2]GOTO5", "MAC332"},
    {"M98P", "MAC401"},
    {"#101=SIN 30", "MAC706"},
    {"#101=ABS#102", "MAC706"},
    {"#101=#102 EQ 5", "MAC709"},
    {"G0X[#102EQ5]", "MAC709"},
    {"#101=#102++#101", "MAC716"},
    {"#101=#102--#101", "MAC716"},
    {"#101=#102+-#101*2", "MAC716"},
    {"#101=--#102", "MAC716"},
    {"#101=#30003.036", "MAC121"},
    {"#101=2..5", "MAC121"},
};

TEST(Forms, AFanucStopsAtThemAndOnlyOneRuleSaysSo) {
    for (const char* control : {"fanuc-16i", "fanuc-0i-c", "fanuc-0i-d", "fanuc-30i"})
        for (const auto& [block, code] : refused)
            EXPECT_THAT(told(block, control), ElementsAre("error " + std::string(code)))
                << block << " " << control;
}

TEST(Forms, WhatIsRightIsNotTold) {
    for (const char* block : {"G1X5.Y#101F100",
                              "GOTO5",

                              "GOTO[#101+4]",
                              "IF[#101EQ2]GOTO5(M8)",
                              "IF[[#101EQ2]AND[#102EQ4]]GOTO5",
                              "IF[#101EQ2]THEN#101=3",
                              "IF[#101EQ2]THEN GOTO5",
                              "N3#101=5",
                              "/#101=5",
                              "/2N3IF[#101EQ2]GOTO5",
                              "#101=SIN[30]",
                              "#101=-#102",
                              "#101=[-#102]*3",
                              "#101=#102-[-#101]",
                              "#101=#102*-#101",
                              "#3006=1(LOOK)",
                              "G0X-#101",
                              "G65P9000A1.B#101",
                              "#101=#102AND1",
                              "WHILE[#101LT#102]DO1\n#101=#101+1\nEND1"})
        EXPECT_THAT(told(block, "fanuc-16i"), Not(Contains(HasSubstr("error")))) << block;
}

TEST(Forms, AnNctTakesItsOwn) {
    for (const char* block : {"IF[#101LT0]#102=3", "IF[#101LT0]AND[#102EQ4]GOTO5", "#101=SIN 30",
                              "#101=ABS#102", "IF[#101GT0]THEN#101=3 GOTO5", "#101=5 #102=6"})
        EXPECT_THAT(told(block, "nct"), IsEmpty()) << block;
    EXPECT_THAT(told("IF #101 EQ 5 GOTO5", "nct"), ElementsAre("error MAC324"));
    EXPECT_THAT(told("##101=5", "nct"), ElementsAre("error MAC206"));
    EXPECT_THAT(told("GO1X1.", "nct"), ElementsAre("error MAC106"));
    EXPECT_THAT(told("G1X Y10.F100", "nct"), ElementsAre("note MAC109"));
}

TEST(Forms, AHaasTakesItsOwn) {
    for (const char* block :
         {"IF[#101LT0]M8", "IF[#101LT0]THEN M8", "#101=#102 EQ 5", "G90 #101=5", "GOTO N5"})
        EXPECT_THAT(told(block, "haas"), IsEmpty()) << block;
    EXPECT_THAT(told("IF #101 EQ 5 GOTO5", "haas"), ElementsAre("error MAC324"));
    EXPECT_THAT(told("M99P", "haas"), ElementsAre("note MAC109"));
}

TEST(Forms, WhereNobodyNamedTheControlTheFindingAsksForIt) {
    EXPECT_THAT(told("IF[#101LT0]#102=3", "fanuc"), ElementsAre("warning MAC325"));
    EXPECT_THAT(message("IF[#101LT0]#102=3", "fanuc"), EndsWith("(--control nct or haas)."));
    EXPECT_THAT(message("#101=#102 EQ 5", "fanuc"), EndsWith("(--control haas)."));
    EXPECT_THAT(message("#101=ABS#102", "fanuc"),
                AllOf(HasSubstr("assumed control"), EndsWith("(--control nct).")));
    EXPECT_THAT(told("GO1X1.", "fanuc"), ElementsAre("error MAC106")) << "none takes it";
    EXPECT_THAT(message("IF[#101LT0]#102=3", "fanuc-30i"), EndsWith("Write 'THEN #102=3'."));
}

TEST(WordsAfterThen, AreAWarningOnOlderSeriesAndANoteWhereNoManualTells) {
    const char* const block = "IF[#101LT0]THEN G0X1.";
    EXPECT_THAT(told(block, "fanuc-16i"), ElementsAre("warning MAC327"));
    EXPECT_THAT(told(block, "fanuc-30i"), ElementsAre("note MAC327"));
    EXPECT_THAT(told(block, "fanuc"), ElementsAre("note MAC327"));
    EXPECT_THAT(told(block, "haas"), IsEmpty());
    EXPECT_THAT(told("IF[#101LT0]THEN G65P9000", "fanuc-16i"), Not(Contains(HasSubstr("MAC327"))))
        << "a macro call is a statement";
}

TEST(Remedies, WriteWhatTheTextSays) {
    EXPECT_EQ(mended("GO1XO"), "safe: G01XO") << "a finding each";
    EXPECT_EQ(mended("G1R1OO.O5"), "safe: G1R100.05");
    EXPECT_EQ(mended("G1R1OF100"), "safe: G1R10F100");
    EXPECT_EQ(mended("IF[#101EQO]GOTO5"), "safe: IF[#101EQ0]GOTO5");
    EXPECT_EQ(mended("N4GO5"), "unsafe: N4G05") << "or a GOTO";
    EXPECT_EQ(mended("GO5X1."), "safe: G05X1.");
    EXPECT_EQ(mended("#101=##102"), "safe: #101=#[#102]");
    EXPECT_EQ(mended("GOTO N5"), "safe: GOTO 5");
    EXPECT_EQ(mended("IF #101 EQ 5 GOTO5"), "safe: IF [#101 EQ 5] GOTO5");
    EXPECT_EQ(mended("IF[#101LT0]AND[#102EQ4]GOTO5"), "safe: IF[[#101LT0]AND[#102EQ4]]GOTO5");
    EXPECT_EQ(mended("IF[#101LT0]#102=3"), "safe: IF[#101LT0]THEN #102=3");
    EXPECT_EQ(mended("IF[#101LT0]M8"), "none") << "THEN takes no words either";
    EXPECT_EQ(mended("#101=SIN 30"), "safe: #101=SIN [30]");
    EXPECT_EQ(mended("#101=ABS#102*2"), "unsafe: #101=ABS[#102]*2") << "or ABS[#102*2]";
    EXPECT_EQ(mended("#101=#102--#101"), "unsafe: #101=#102-[-#101]");
}

TEST(Remedies, MendedBlocksAreRight) {
    for (const auto& [block, code] : refused) {
        const std::string text = mended(block);
        if (text == "none") continue;
        EXPECT_THAT(told(text.substr(text.find(':') + 2), "fanuc-16i"),
                    Not(Contains("error " + std::string(code))))
            << text;
    }
}

TEST(LetterO, IsNoFigureWhereAProgramBegins) {
    EXPECT_THAT(told("M99O0810", "fanuc-16i"), IsEmpty());
    EXPECT_THAT(told("G1R1.O0810", "fanuc-16i"), ElementsAre("error MAC121"));
}

TEST(TwoStatements, AreANoteBecauseNoManualTells) {
    for (const char* block : {"#101=5 #102=6", "#101=5 IF[#102EQ2]GOTO5"}) {
        EXPECT_THAT(told(block, "fanuc-16i"), IsEmpty()) << "on request: " << block;
        EXPECT_THAT(told(block, "fanuc-16i", {"MAC332"}), ElementsAre("note MAC332")) << block;
    }
    EXPECT_THAT(told("#101=5 GOTO5", "fanuc-16i"), ElementsAre("warning MAC332")) << "tried at machines";
    EXPECT_THAT(told("#101=5 GOTO5", "haas"), IsEmpty());
}

TEST(LetterO, AloneMayBeAJump) {
    EXPECT_THAT(message("GO5", "fanuc-16i"), HasSubstr("a GOTO without its TO"));
    EXPECT_THAT(message("GO5X1.", "fanuc-16i"), Not(HasSubstr("GOTO")));
}

TEST(MissingValue, BeforeAnIIsOneWhereThatIsNoOperator) {
    EXPECT_THAT(told("G1ZI5.F100", "fanuc-16i"), ElementsAre("error MAC109"));
    EXPECT_THAT(told("G1ZI#101F100", "fanuc"), ElementsAre("warning MAC109"));
    EXPECT_THAT(told("G1ZI5.F100", "nct"), IsEmpty());
    EXPECT_THAT(told("G2X5.I5.F100", "fanuc-16i"), IsEmpty());
}

TEST(MissingValue, InRoundBracketsIsToldAsThose) {
    EXPECT_THAT(told("G1X(#101+1)Y2.F100", "fanuc-16i"), ElementsAre("error MAC116"));
    EXPECT_THAT(told("G1X Y(#101+1)F100", "fanuc-16i"), ElementsAre("error MAC116"));
}

} // namespace
} // namespace maclint
