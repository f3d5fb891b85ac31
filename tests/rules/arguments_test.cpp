//! Rules about what calls pass, in corner cases: MAC211.
#include "tests/rules/raised.hpp"
#include "tests/support/analysed.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace maclint {
namespace {

using test::judged;
using test::lines_raised;
using test::messages_raised;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A program that calls another one with these arguments.
std::string call(const std::string& arguments, const std::string& body) {
    return "O1\nG65 P9001 " + arguments + "\nM30\nO9001\n" + body + "M99\n";
}

TEST(ArgumentUnused, IsOneThatNoBlockReadsOrThatIsOverwrittenFirst) {
    EXPECT_THAT(judged("MAC211", call("X1. Z2.", "G0 X#24 Z#26\n")), IsEmpty());
    // I behind K: as which variable it arrives a parameter decides.
    EXPECT_THAT(judged("MAC211", call("X1. K2. I3.", "G0 X#24 Z#6\n")), IsEmpty());
    EXPECT_THAT(judged("MAC211", call("X1. K2. D3.", "G0 X#24 Z#6\n")), ElementsAre("warning 2"));
    for (const char* arguments : {"X1. J2.", "x1. j2."})
        EXPECT_THAT(judged("MAC211", call(arguments, "#5=3\nG0 X#24 Y#5\n")), ElementsAre("warning 2"));
    EXPECT_THAT(messages_raised("MAC211", call("X1. Z2.", "G0 X#24\n")),
                ElementsAre(HasSubstr("O9001 does not read #26 (Z), which 'Z2.' passes")));
    EXPECT_THAT(messages_raised("MAC211", call("X1. Z2. R3. Q4.", "G0 X#24\n")),
                ElementsAre(HasSubstr("reads none of #26 (Z), #18 (R) and #17 (Q)")));
    EXPECT_THAT(
        messages_raised("MAC211", call("X1. F2.", "#9=80.\nG1 X#24 F#9\n")),
        ElementsAre(HasSubstr("O9001 sets #9 (F), which 'F2.' passes, on line 5 before it reads it")));
    EXPECT_THAT(judged("MAC211", call("X1. F2.", "IF[#9EQ#0]THEN #9=80.\nG1 X#24 F#9\n")), IsEmpty());
}

TEST(ArgumentUnused, CountsReadsOfVariablesThatNoLetterButASetReaches) {
    const std::string sets = "I1. J2. K3. I4. J5. K6. I7. J8.";
    const std::string first = "#100=#4+#5+#6+#7+#8+#9\n";
    EXPECT_THAT(judged("MAC211", call(sets, first + "#106=#10\nG0 X#11\n")), IsEmpty());
    EXPECT_THAT(judged("MAC211", call(sets, first + "G1 Z[#10+1.] Y-#11\n")), IsEmpty());
    EXPECT_THAT(messages_raised("MAC211", call(sets, first + "G0 X#11\n")),
                ElementsAre(HasSubstr("O9001 does not read #10, which 'I7.' passes")));
    // All ten sets: K10 is #33.
    std::string all;
    for (int set = 0; set < 10; ++set) all += "I1.J2.K3.";
    std::string reads;
    for (int number = 4; number <= 33; ++number) reads += "X#" + std::to_string(number) + "\n";
    EXPECT_THAT(judged("MAC211", call(all, reads)), IsEmpty());
    // A set of its own that the program reads is no sign of one that is still to be written.
    EXPECT_THAT(lines_raised("MAC211", call("A1. I1. I2. I3. D4.", "G0 X#10\n")), ElementsAre(2));
}

TEST(ArgumentUnused, IsUnknownWhereTheProgramMayReadAllOfThem) {
    EXPECT_THAT(judged("MAC211", call("X1. Z2.", "#100=#[#24]\n")), IsEmpty());
    EXPECT_THAT(judged("MAC211", call("X1. Z2.", "G0 X#24\nM98 P9002\n")), IsEmpty());
    EXPECT_THAT(judged("MAC211", call("X1. Z2.", "G0 X#24\nHERE IT ENDS\n")), IsEmpty());
    // Another call has locals of its own.
    EXPECT_THAT(lines_raised("MAC211", call("X1. Z2.", "G0 X#24\nG65 P9002 A1.\n")), ElementsAre(2));
    // M98 passes nothing, and nothing is known of who else reads the variables.
    EXPECT_THAT(
        judged("MAC211", "O1\nG65 P9001 X1. Z2.\nM30\nO9001\nG0 X#24\nM98 P9002\nM99\nO9002\nZ#26\nM99\n"),
        IsEmpty());
}

TEST(ArgumentUnused, IsMeantForAProgramThatIsNotWrittenYet) {
    EXPECT_THAT(judged("MAC211", call("X1. Z2.", "")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC211", call("X1. Z2.", "(#26: DEPTH)\nG0 X#24\n")), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC211", call("X1. Z2.", "G0 X#24\nM99\nG0 Z#26\n")), ElementsAre(2));
    EXPECT_THAT(judged("MAC211", "O9001\nIF[#24EQ1]GOTO5\nG65 P9001 X1. Z2.\nN5 M99\n"), IsEmpty());
}

TEST(ArgumentUnused, IsToldOnceForAllCallsOfAProgram) {
    EXPECT_THAT(
        lines_raised("MAC211", "O1\nG65 P9001 X1. Z2.\nG65 P9001 X1. Z2.\nM30\nO9001\nG0 X#24\nM99\n"),
        ElementsAre(2));
}

/// The places beside the only finding.
std::vector<std::string> told_beside(const std::string& text) {
    const auto workspace = test::analyse_fanuc(text);
    const auto findings = run_rules(*workspace, {{find_rule("MAC211")}}, 1);
    std::vector<std::string> told;
    if (findings.size() != 1) return {"no finding, or several"};
    for (const RelatedLocation& place : findings.front().related)
        told.push_back(std::to_string(place.source->position(place.span.begin).line) + " " + place.text);
    return told;
}

TEST(ArgumentUnused, IsToldWithAllCallsThatPassSomeOfThem) {
    const std::string macro = "M30\nO9001\nG0 X#24\nM99\n";
    EXPECT_THAT(told_beside("O1\nG65 P9001 X1. Z2.\nG65 P9001 X1. Z2.\n" + macro),
                ElementsAre("3 this call passes it, too"));
    EXPECT_THAT(
        told_beside("O1\nG65 P9001 X1. Z2. R3.\nG65 P9001 X1. R3.\nG65 P9001 R3. Z2.\n" + macro),
        ElementsAre("3 this call passes #18 (R), too", "4 this call passes #26 (Z) and #18 (R), too"));
}

} // namespace
} // namespace maclint
