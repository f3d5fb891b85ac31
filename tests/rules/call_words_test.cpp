//! Rules on the words of calls: what stands before them, beside them, and where it arrives.
#include "tests/rules/raised.hpp"
#include "tests/support/linted.hpp"

#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using test::judged;
using test::messages_raised;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// "error MAC404 (129) on line 2" for each finding of the program for the control.
std::vector<std::string> calls_found(const std::string& text, std::string_view control) {
    static constexpr const char* severities[] = {"note", "warning", "error"};
    cli::Overrides overrides;
    overrides.control = std::string(control);
    std::vector<std::string> all;
    for (const auto& [finding, suppressed] :
         test::lint_texts({{"O1.nc", text}}, std::move(overrides)).findings)
        all.push_back(std::string(severities[static_cast<int>(finding.severity)]) + " " +
                      std::string(finding.rule->code) +
                      (finding.alarm.empty() ? "" : " (" + std::string(finding.alarm) + ")") + " on line " +
                      std::to_string(finding.source->position(finding.span.begin).line));
    return all;
}

/// A program with that block, which may call O9001 and O2.
std::string with_block(const std::string& block) {
    return "O1\nG21\n" + block + "\nM30\nO9001\nG0 X#24 Y#25 Z#26 M#13\nM99\nO2\nG91 X1.\nG90\nM99\n";
}

TEST(WordsBeforeACall, AreLostWhereTheyWouldBeArguments) {
    EXPECT_THAT(calls_found(with_block("Z-5. G65 P9001 X1. Y2. M8"), "fanuc-16i"),
                ElementsAre("error MAC403 (129) on line 3"));
    EXPECT_THAT(calls_found(with_block("Z-5. G65 P9001 X1. Y2. M8"), "haas"),
                ElementsAre("warning MAC403 on line 3"));
    EXPECT_THAT(messages_raised("MAC403", with_block("X1. Y2. G65 P9001 Z-5.")),
                ElementsAre(HasSubstr("'X1. Y2.' stand before G65 and are not passed")));
    for (const char* block : {"G90 G54 G65 P9001 X1.", "M8 G65 P9001 X1.", "T5 S800 F100. G65 P9001 X1.",
                              "N30 G65 P9001 X1.", "/G65 P9001 X1.", "X1. M98 P2"})
        EXPECT_THAT(judged("MAC403", with_block(block)), IsEmpty()) << block;
}

TEST(ArgumentsOfACall, AreNeitherCodesNorNumbersOfBlocks) {
    EXPECT_THAT(calls_found(with_block("G65 P9001 X1. Y2. Z3. M8 G3"), "fanuc-30i"),
                ElementsAre("error MAC404 (129) on line 3"));
    EXPECT_THAT(calls_found(with_block("G65 P9001 X1. N5 Y2. Z3. M8"), "fanuc-16i"),
                ElementsAre("error MAC404 (129) on line 3"))
        << "what stands behind N is passed";
    EXPECT_THAT(calls_found(with_block("G65 P9001 X1. Y2. Z3. M8 N5"), "fanuc-30i"),
                ElementsAre("error MAC404 on line 3"))
        << "its alarm 129 is for G alone";
    EXPECT_THAT(judged("MAC404", with_block("G66.1 P9001 X1. G91 Y1.\nG67")), IsEmpty())
        << "called after each block, it takes the codes of the blocks";
    EXPECT_THAT(judged("MAC404", with_block("G66 P9001 X1. G91 Y1.\nG67")), ElementsAre("error 3"));
    EXPECT_THAT(judged("MAC404", with_block("G65 P9001 L2 X1. ,R5.")), IsEmpty());
}

TEST(ArgumentsOfACall, ComeInTenSetsAtMost) {
    std::string sets;
    for (int set = 1; set <= 10; ++set) sets += "I1. J2.";
    EXPECT_THAT(judged("MAC404", with_block("G65 P9001 " + sets + "K3.")), IsEmpty());
    EXPECT_THAT(judged("MAC404", with_block("G65 P9001 " + sets + "J3.")), ElementsAre("error 3"));
    EXPECT_THAT(messages_raised("MAC404", with_block("G65 P9001 " + sets + "I1. J2. I3.")),
                ElementsAre(HasSubstr("'I1.' begins or fills set 11 of G65, the last of which is set 10")));
}

TEST(ArgumentsOutOfOrder, MatterWhereTheProgramReadsThemByTheirLetters) {
    const auto macro_call = [](const std::string& arguments, const std::string& reads) {
        return "O1\nG65 P9001 " + arguments + "\nM30\nO9001\nG0 " + reads + "\nM99\n";
    };
    EXPECT_THAT(messages_raised("MAC405", macro_call("K1. I2.", "X#4 Y#6")),
                ElementsAre(AllOf(HasSubstr("'I2.' stands behind 'K1.'"),
                                  HasSubstr("arrives as #7, but O9001 reads #4"))));
    EXPECT_THAT(judged("MAC405", macro_call("K1. J3. I2.", "X#4 Y#6 Z#5")), ElementsAre("warning 2"));
    EXPECT_THAT(judged("MAC405", macro_call("I2. K1.", "X#4 Y#6")), IsEmpty());
    EXPECT_THAT(judged("MAC405", macro_call("K1. I2.", "X#7 Y#6")), IsEmpty()) << "a second set is meant";
    EXPECT_THAT(judged("MAC405", macro_call("I1. K1. I2. K3.", "X#4 Y#6 Z#7 A#9")), IsEmpty());
}

TEST(ArgumentsWithoutAPoint, AreLengthsWhereTheProgramMovesToThemAndTheOthersHaveOne) {
    const auto macro_call = [](const std::string& arguments, const std::string& body) {
        return "O1\nG65 P9001 " + arguments + "\nM30\nO9001\n" + body + "\nM99\n";
    };
    EXPECT_THAT(
        messages_raised("MAC408", macro_call("X100 Y36.", "G0 X#24 Y#25")),
        ElementsAre(AllOf(HasSubstr("'X100' counts in least increments"), HasSubstr("O9001 moves to X#24"),
                          HasSubstr("'Y36.' beside it has a point"))));
    EXPECT_THAT(judged("MAC408", macro_call("X0 Y36.", "G0 X#24 Y#25")), IsEmpty());
    EXPECT_THAT(judged("MAC408", macro_call("X100 Y36", "G0 X#24 Y#25")), IsEmpty()) << "all are written so";
    EXPECT_THAT(judged("MAC408", macro_call("R3 Y36.", "G0 Y[#25+#18*2]")), IsEmpty()) << "R may be a count";
    EXPECT_THAT(judged("MAC408", macro_call("X100 Y36.", "T#24\nY#25")), IsEmpty());
}

TEST(G67, EndsNothingBehindG65) {
    EXPECT_THAT(messages_raised("MAC414", with_block("G65 P9001 X1. Y2. Z3. M8\nX5.\nG67")),
                ElementsAre(HasSubstr("'G67' follows 'G65' on line 3")));
    EXPECT_THAT(judged("MAC414", with_block("G66 P9001 X1. Y2. Z3. M8\nX5.\nG67\nG65 P9001 X2.\nG67")),
                ElementsAre("warning 7"))
        << "selected alone, the rule tells of every one that ends nothing";
    EXPECT_THAT(judged("MAC414", "O1\nG65 P9009 X1.\nG67\nM30\n"), ElementsAre("warning 3"))
        << "what O9009 does nobody knows, but this program begins none";
    EXPECT_THAT(judged("MAC414", "O9001\nG65 P2 X1.\nG67\nM99\n"), IsEmpty())
        << "a caller's G66 may be meant";
}

TEST(M98, MayHoldItsRepeatsInTheProgramNumber) {
    const std::string both = "O1\nM98 P51002\nM30\nO1002\nX1.\nM99\nO51002\nX2.\nM99\n";
    EXPECT_THAT(messages_raised("MAC417", both),
                ElementsAre(HasSubstr("runs O1002 5 times, and O51002 is there")));
    EXPECT_THAT(calls_found("O1\nM98 P51002\nM30\nO1002\nX1.\nM99\n", "fanuc-16i"), IsEmpty());
    EXPECT_THAT(calls_found("O1\nM98 P51002\nM30\nO1002\nX1.\nM99\n", "haas"),
                ElementsAre("warning MAC417 on line 2"));
    EXPECT_THAT(calls_found("O1\nM98 P51002\nM30\nO51002\nX1.\nM99\n", "haas"), IsEmpty());
}

TEST(M98, PassesNoArguments) {
    const auto macro_call = [](const std::string& before, const std::string& block) {
        return "O1\n" + before + block + "\nM30\nO2\nG91 G1 Z-#4 F#9\nG90\nM99\n";
    };
    EXPECT_THAT(messages_raised("MAC418", macro_call("", "M98 P2 I5. F100.")),
                ElementsAre(AllOf(HasSubstr("M98 passes none, so 'I5. F100.' does not reach O2"),
                                  HasSubstr("which reads #4 and #9"))));
    EXPECT_THAT(judged("MAC418", macro_call("#4=5.\n#9=100.\n", "M98 P2 I5. F100.")), IsEmpty());
    EXPECT_THAT(judged("MAC418", macro_call("", "M98 P2 X10.")), IsEmpty()) << "a move before the call";
    EXPECT_THAT(judged("MAC418", macro_call("", "G65 P2 I5. F100.")), IsEmpty());
    EXPECT_THAT(judged("MAC418", "O1\nG65 P2 I5.\nM30\nO2\nM98 P3 I5.\nM99\nO3\nG1 Z#4\nM99\n"), IsEmpty())
        << "O2 has a #4 of its own";
}

TEST(M98, StartsWhereQSays) {
    const auto call = [](const std::string& words) {
        return "O1\nM98 P2 " + words + "\nM30\nO2\nN100 X1.\nM99\n";
    };
    EXPECT_THAT(calls_found(call("Q200"), "fanuc-30i"), ElementsAre("error MAC426 (078) on line 2"));
    EXPECT_THAT(calls_found(call("Q200"), "fanuc"), ElementsAre("warning MAC426 on line 2"));
    EXPECT_THAT(calls_found(call("Q200"), "fanuc-16i"), IsEmpty()) << "nobody knows what it makes of Q";
    EXPECT_THAT(calls_found(call("Q100"), "fanuc-30i"), IsEmpty());
    EXPECT_THAT(calls_found(call("L3"), "fanuc-30i"), IsEmpty());
}

TEST(MacroA, IsACalculationThatMacroBTakesForACall) {
    EXPECT_THAT(messages_raised("MAC124", "O1\nG65 H02 P#102 Q100.0 R0\n#103=#102+10.\nG0 X#103\nM30\n"),
                ElementsAre(HasSubstr("'G65 H02 P#102 Q100.0 R0' is a statement of macro A")));
    EXPECT_THAT(judged("MAC124", "O1\nG65 H02 P#102 Q100.0 R0\nG0 X#102\nM30\n"), IsEmpty())
        << "nothing shows macro B";
    EXPECT_THAT(judged("MAC124", "O1\n#102=9001\nG65 P#102 H2. Q100. R0\nM30\n"), IsEmpty());
    EXPECT_THAT(judged("MAC124", "O1\n#102=9001\nG65 H2 P#102 Q100. X5.\nM30\n"), IsEmpty());
}

TEST(TwoCallsInABlock, AreAnErrorAndSoIsAnEndBesideACall) {
    EXPECT_THAT(
        calls_found(with_block("G65 P9001 X5. Y1. Z1. M8 G66 P9001 X1. Y2. Z3. M8\nG67"), "fanuc-30i"),
        ElementsAre("error MAC423 (1092) on line 3"));
    EXPECT_THAT(calls_found(with_block("G65 P9001 X5. Y1. Z1. M8 G65 P9001 X1. Y2. Z3. M8"), "fanuc-16i"),
                ElementsAre("error MAC423 (129) on line 3"));
    EXPECT_THAT(calls_found(with_block("M98 P2 M98 P2"), "fanuc-30i-lathe"),
                ElementsAre("error MAC423 (1091) on line 3"));
    EXPECT_THAT(calls_found(with_block("M98 P2 M98 P2"), "haas"), ElementsAre("warning MAC423 on line 3"));
    EXPECT_THAT(messages_raised("MAC423", with_block("M98 P2 M30")),
                ElementsAre(HasSubstr("'M98' beside 'M30'")));
    EXPECT_THAT(messages_raised("MAC423", "O1\nG65 P9001 X1. M30\nO9001\nG0 X#24\nM99\n"),
                ElementsAre(HasSubstr("'M30' passes a value that O9001 does not read, and ends nothing")));
    EXPECT_THAT(messages_raised("MAC423", with_block("M30 G65 P9001 X1. Y2. Z3.")),
                ElementsAre(HasSubstr("'G65' beside 'M30'")));
    EXPECT_THAT(judged("MAC423", with_block("G65 P9001 X1. Y2. Z3. M30")), IsEmpty()) << "O9001 reads #13";
    EXPECT_THAT(judged("MAC423", with_block("IF[#1EQ1]THEN G65 P9001 X1.\nM98 P2")), IsEmpty());
}

TEST(M99, StandsAloneInAProgramCalledAfterEveryMove) {
    const auto called = [](const std::string& call, const std::string& end) {
        return "O1\nG90\n" + call + " P9001 Z-5.\nX10.\nG67\nM30\nO9001\nG1 Z#26 F100.\n" + end + "\n";
    };
    EXPECT_THAT(calls_found(called("G66", "G0 Z5. M99"), "fanuc-30i"),
                ElementsAre("error MAC425 (1093) on line 9"));
    EXPECT_THAT(calls_found(called("G66", "N5 M99 P10 L2"), "fanuc-30i"),
                testing::Not(testing::Contains(HasSubstr("MAC425"))));
    EXPECT_THAT(calls_found(called("G66", "G0 Z5.\nM99"), "fanuc-30i"), IsEmpty());
    EXPECT_THAT(calls_found(called("G66", "G0 Z5. M99"), "fanuc-16i"), IsEmpty())
        << "nothing is known of its alarms";
    EXPECT_THAT(judged("MAC425", called("G66", "G0 Z5. M99")), ElementsAre("warning 9"))
        << "a newer control may be meant";
    EXPECT_THAT(judged("MAC425", "O1\nG66 P9001 Z-5.\nX10. M99\n"), ElementsAre("warning 3"));
    EXPECT_THAT(judged("MAC425", "O1\nG66 P9001 Z-5.\nX10.\nG67\nX0 M99\n"), IsEmpty());
}

TEST(CannedCycleBesideACall, IsToldWhereItStandsBeforeTheCall) {
    EXPECT_THAT(calls_found(with_block("G81 G65 P9001 X1."), "fanuc-30i"),
                testing::Contains("warning MAC423 on line 3"));
    EXPECT_THAT(judged("MAC423", with_block("G80 G65 P9001 X1.")), IsEmpty());
    EXPECT_THAT(judged("MAC423", with_block("G90 G65 P9001 X1.")), IsEmpty());
    EXPECT_THAT(judged("MAC423", with_block("G65 P9001 X1. G81")), IsEmpty())
        << "an argument, which MAC404 tells";
}

} // namespace
} // namespace maclint
