//! Comments that allow findings, and what is said about those that allow nothing.
#include "tests/support/linted.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A main program with one jump to a label that is not there (MAC301) on line `3`, and room for comments.
std::string program(const std::string& before, const std::string& beside, const std::string& after) {
    return "O1(TEST)\n" + before + "\nGOTO 99 " + beside + "\n" + after + "\nM30\n";
}

std::vector<std::string> codes_of(const std::string& text) { return codes(lint_text(text)); }

std::vector<std::string> under_select(const std::string& text, const std::string& rule) {
    cli::Overrides overrides;
    overrides.select = {rule};
    return codes(lint_texts({{"O1.nc", text}}, overrides));
}

/// The text with the fixes of its findings applied.
std::string fixed(const std::string& text) {
    const auto result = lint_text(text);
    std::string out = text;
    for (const auto& [finding, suppressed] : result.findings)
        for (const Fix& fix : finding.fixes)
            for (const Edit& edit : fix.edits) out.replace(edit.span.begin, edit.span.length(), edit.text);
    return out;
}

TEST(Suppression, TheTestProgramHasOneFinding) {
    EXPECT_THAT(codes_of(program("", "", "")), ElementsAre("MAC301"));
}

TEST(OneCause, OfTwoRulesOnlyTheOwnerIsHeard) {
    const std::string forgotten = "O1\nG65 P9001 X1. Z1. F5.\nG1 X9.\nM30\n"
                                  "O9001(UP)\n#5=#24\nG91 G1 Z#26 F#9\nM99\n";
    EXPECT_THAT(codes_of(forgotten), ElementsAre("MAC501"));
    EXPECT_THAT(under_select(forgotten, "MAC503"), ElementsAre("MAC503"));
    EXPECT_THAT(codes_of("O9001(UP)\n#5=#24\nG91 G1 Z5. F100\nM99\n"),
                ElementsAre("MAC501")); // a plain block
}

TEST(Suppression, AtTheEndOfABlockIsForThatBlock) {
    EXPECT_THAT(codes_of(program("", "(MACLINT ALLOW MAC301 - WANTED)", "")), IsEmpty());
    EXPECT_THAT(codes_of(program("G0 X1. (MACLINT ALLOW MAC301)", "", "")), ElementsAre("MAC001", "MAC301"));
}

TEST(Suppression, ThatIsTiedToItsNameAllowsNothingAndIsTold) {
    for (const std::string comment :
         {"(MACLINT: ALLOW MAC301)", "(MACLINT:ALLOW MAC301)", "(MACLINT-ALLOW MAC301)",
          "(maclint: allow mac301 - later)", "(MACLINT=OFF MAC301)"})
        EXPECT_THAT(codes_of(program("", comment, "")), ElementsAre("MAC301", "MAC002")) << comment;
    for (const std::string comment : {"(MACLINT: SEE THE MANUAL)", "(MACLINTS ALLOW)", "(MACLINT-CLEAN)"})
        EXPECT_THAT(codes_of(program("", comment, "")), ElementsAre("MAC301")) << comment;
    const std::string mended = fixed(program("", "(MACLINT: ALLOW MAC301 - X)", ""));
    EXPECT_THAT(mended, HasSubstr("(MACLINT ALLOW MAC301 - X)"));
    EXPECT_THAT(codes_of(mended), IsEmpty());
}

TEST(Suppression, AloneIsForTheNextBlock) {
    EXPECT_THAT(codes_of(program("(MACLINT ALLOW MAC301)", "", "")), IsEmpty());
    EXPECT_THAT(codes_of(program("(MACLINT ALLOW MAC301)\n(WHY)", "", "")), IsEmpty());
    EXPECT_THAT(codes_of(program("", "", "(MACLINT ALLOW MAC301)")), ElementsAre("MAC301", "MAC001"));
}

TEST(Suppression, BesideANumberAloneIsForThatBlockAndTheNext) {
    const auto told = [](const std::string& text) { return under_select(text, "MAC462"); };
    // Two blocks have the number that is jumped to: MAC462 stands on the second.
    const auto twice = [](const std::string& second) {
        return "O1\nIF[#500EQ1]GOTO5\nN5\nX1.\n" + second + "\nX2.\nM30\n";
    };
    ASSERT_THAT(told(twice("N5")), ElementsAre("MAC462"));
    EXPECT_THAT(told(twice("N5 (MACLINT ALLOW MAC462 - T)")), IsEmpty());
    EXPECT_THAT(told(twice("(MACLINT ALLOW MAC462 - T) N5")), IsEmpty());
    EXPECT_THAT(told(twice("N5; (MACLINT ALLOW MAC462 - T)")), IsEmpty());
    EXPECT_THAT(codes_of(program("N1 (MACLINT ALLOW MAC301)", "", "")), IsEmpty());
    EXPECT_THAT(codes_of(program("N1 (MACLINT ALLOW MAC303)", "", "")), ElementsAre("MAC001", "MAC301"));
}

TEST(Suppression, AfterTheLastBlockTakesNothingFromTheFirst) {
    EXPECT_THAT(codes_of("GOTO99 (MACLINT ALLOW MAC301)\nM30\n(MACLINT ALLOW MAC301)\n"),
                ElementsAre("MAC001"));
}

TEST(Suppression, LeavesTheOtherPlacesOfTheSameCause) {
    const auto lines_told = [](const std::string& comment) {
        const auto result = lint_text("O1\nQQ" + comment + "\nX1\nQQ\nX2\nQQ\nM30\n");
        std::vector<std::uint32_t> lines;
        for (const auto& [finding, suppressed] : result.findings) {
            if (finding.rule->code == "MAC001" || suppressed) continue;
            lines.push_back(finding.source->position(finding.span.begin).line);
            for (const RelatedLocation& place : finding.repeats)
                lines.push_back(place.source->position(place.span.begin).line);
        }
        return lines;
    };
    EXPECT_THAT(lines_told(""), ElementsAre(2, 4, 6));
    EXPECT_THAT(lines_told(" (MACLINT ALLOW MAC121)"), ElementsAre(4, 6));
}

TEST(Suppression, OnlyTheFirstUnknownWordsGetProposals) {
    std::string words;
    for (int i = 0; i < 12; ++i) words += " MAC30l";
    const auto result = lint_text(program("(MACLINT ALLOW" + words + ")", "", ""));
    const auto proposals = std::ranges::count_if(result.findings, [](const cli::FilteredFinding& filtered) {
        return filtered.finding.message().find("MAC301") != std::string::npos &&
               filtered.finding.rule->code == "MAC002";
    });
    EXPECT_EQ(proposals, 8);
}

TEST(Suppression, TakesNamesPrefixesListsAndAnyCase) {
    EXPECT_THAT(codes_of(program("", "(maclint allow jump-target-missing)", "")), IsEmpty());
    EXPECT_THAT(codes_of(program("", "(MACLINT ALLOW MAC3 - ALL JUMPS)", "")), IsEmpty());
    EXPECT_THAT(codes_of(program("", "(MACLINT ALLOW MAC303, MAC301)", "")), ElementsAre("MAC001"));
    EXPECT_THAT(codes_of(program("", "(MACLINT ALLOW ALL)", "")), IsEmpty());
}

TEST(Suppression, OfAFileHoldsEverywhere) {
    EXPECT_THAT(codes_of(program("", "", "(MACLINT ALLOW-FILE MAC301)")), IsEmpty());
}

TEST(Suppression, OffHoldsUntilOn) {
    EXPECT_THAT(codes_of(program("(MACLINT OFF MAC301)", "", "(MACLINT ON MAC301)")), IsEmpty());
    EXPECT_THAT(codes_of(program("(MACLINT OFF MAC301)", "", "")), IsEmpty());
    EXPECT_THAT(codes_of(program("(MACLINT OFF MAC301)\n(MACLINT ON MAC301)", "", "")),
                ElementsAre("MAC001", "MAC301"));
    EXPECT_THAT(codes_of(program("(MACLINT OFF MAC3)\n(MACLINT ON)", "", "")),
                ElementsAre("MAC001", "MAC301"));
    EXPECT_THAT(codes_of(program("(MACLINT OFF MAC3)\n(MACLINT ON MAC303)", "", "")), IsEmpty());
}

TEST(Suppression, KeepsTheFindingWithItsReason) {
    const auto result = lint_text(program("", "(MACLINT ALLOW MAC301 - O99 IS LOADED LATER)", ""));
    ASSERT_EQ(result.findings.size(), 1U);
    ASSERT_TRUE(result.findings[0].suppressed);
    EXPECT_EQ(result.findings[0].suppressed->reason, "O99 IS LOADED LATER");
}

TEST(UnusedSuppression, IsRemovedByItsFix) {
    EXPECT_EQ(fixed("O1\nG0 X1. (MACLINT ALLOW MAC301)\nM30\n"), "O1\nG0 X1.\nM30\n");
    EXPECT_EQ(fixed("O1\n(MACLINT ALLOW MAC301)\nM30\n"), "O1\nM30\n");
    EXPECT_EQ(fixed("O1\n(MACLINT OFF MAC301)\r\nM30\n"), "O1\nM30\n");
}

TEST(UnusedSuppression, LosesOnlyTheWordThatIsOfNoUse) {
    EXPECT_EQ(fixed(program("", "(MACLINT ALLOW MAC303 MAC301 - X)", "")),
              program("", "(MACLINT ALLOW MAC301 - X)", ""));
    EXPECT_EQ(fixed(program("", "(MACLINT ALLOW MAC301, MAC303 - X)", "")),
              program("", "(MACLINT ALLOW MAC301 - X)", ""));
}

TEST(UnusedSuppression, IsToldWhateverElseIsSelected) {
    const std::string used = program("", "(MACLINT ALLOW MAC301)", "");
    const std::string unused = program("", "(MACLINT ALLOW MAC301 MAC303)", "");
    EXPECT_THAT(under_select(used, "MAC001"), IsEmpty());
    EXPECT_THAT(under_select(unused, "MAC001"), ElementsAre("MAC001"));
    EXPECT_THAT(under_select(unused, "MAC303"), IsEmpty());
}

TEST(UnknownRule, IsToldWithTheLikelyOne) {
    const auto result = lint_text(program("", "(MACLINT ALLOW MAC301 JUMP-INTO-LOP)", ""));
    ASSERT_THAT(codes(result), ElementsAre("MAC002"));
    EXPECT_THAT(result.findings.back().finding.message(), HasSubstr("'jump-into-loop'"));
}

TEST(UnknownRule, IsToldForCommentsThatSayTooLittle) {
    EXPECT_THAT(codes_of("O1\nM30 (MACLINT)\n"), ElementsAre("MAC002"));
    EXPECT_THAT(codes_of("O1\nM30 (MACLINT ALLOW)\n"), ElementsAre("MAC002"));
    EXPECT_THAT(codes_of("O1\nM30 (MACLINT ALLOW - BECAUSE)\n"), ElementsAre("MAC002"));
    EXPECT_THAT(codes_of("O1\nM30 (MACLINT IGNORE MAC301)\n"), ElementsAre("MAC002"));
    EXPECT_THAT(codes_of("O1\nM30 (CHECKED WITH MACLINT)\n"), IsEmpty());
}

TEST(UnknownRule, InAnOtherwiseUsefulCommentDoesNotHideIt) {
    EXPECT_THAT(codes_of(program("", "(MACLINT ALLOW MAC999 MAC301)", "")), ElementsAre("MAC002"));
}

} // namespace
} // namespace maclint::test
