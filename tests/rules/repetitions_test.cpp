//! Rules on text that says the same twice, or almost: MAC337, MAC719, MAC726.
#include "tests/rules/raised.hpp"

#include <gmock/gmock.h>

namespace maclint {
namespace {

using test::lines_raised;
using test::messages_raised;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::uint32_t> equal(const std::string& blocks) {
    return lines_raised("MAC337", "O9001\n" + blocks + "M99\n");
}

TEST(EqualBranches, DoTheSame) {
    EXPECT_THAT(equal("IF[#1EQ1]GOTO4\n#33=#24\n#32=#25\nGOTO5\nN4#33=#24(X)\nN6 #32 = #25\nN5G0X#33Y#32\n"),
                ElementsAre(2));
    EXPECT_THAT(equal("IF[#1EQ1]GOTO4\nG0X5.\nGOTO5\nN4G0X5.\nN5G0Y5.\n"), ElementsAre(2));
    EXPECT_THAT(equal("IF[#1EQ1]GOTO4\nM08\nGOTO5\nN4M08\nN5G0Y#25\n"), ElementsAre(2));
    EXPECT_THAT(equal("IF[#1EQ1]GOTO4\nG0X#24\nM99\nN4G0X#24\n"), ElementsAre(2));
    EXPECT_THAT(
        messages_raised("MAC337", "O9001\nIF[#1EQ1]GOTO4\n#33=#24\nGOTO5\nN4#33=#24\nN5G0X#33\nM99\n"),
        ElementsAre(AllOf(HasSubstr("line 5"), HasSubstr("line 3"))));
}

TEST(EqualBranches, DifferInAnything) {
    EXPECT_THAT(equal("IF[#1EQ1]GOTO4\n#33=#24\nGOTO5\nN4#33=-#24\nN5G0X#33\n"), IsEmpty());
    EXPECT_THAT(equal("IF[#1EQ1]GOTO4\nM08\nGOTO5\nN4M09\nN5G0Y#25\n"), IsEmpty());
    // M21 and M22 are what the builder of the machine makes of them.
    EXPECT_THAT(equal("IF[#1EQ1]GOTO4\nG0X#24M21\nGOTO5\nN4G0X#24M22\nN5G0Y#25\n"), IsEmpty());
    EXPECT_THAT(equal("IF[#1EQ1]GOTO4\nG0X#24M21\nGOTO5\nN4G0X#24M21\nN5G0Y#25\n"), ElementsAre(2));
    EXPECT_THAT(equal("IF[#1EQ1]GOTO4\nF#9M21\nGOTO5\nN4F#9M22\nN5G1Y#25\n"), IsEmpty());
    EXPECT_THAT(equal("IF[#1EQ1]GOTO4\nF#9M21\nGOTO5\nN4F#9M21\nN5G1Y#25\n"), ElementsAre(2));
    EXPECT_THAT(equal("IF[#1EQ1]GOTO4\n#33=#24\nGOTO6\nN4#33=#24\nN5G0X#33\nN6G0Y#33\n"), IsEmpty());
    // a third path comes to one of them
    EXPECT_THAT(equal("IF[#2EQ1]GOTO4\nIF[#1EQ1]GOTO4\n#33=#24\nGOTO5\nN4#33=#24\nN5G0X#33\n"), IsEmpty());
}

TEST(EqualBranches, AreNoneThatOnlyLeave) {
    EXPECT_THAT(equal("G0X#24\nIF[#1EQ1]GOTO4\nM99\nN4"), IsEmpty());
    EXPECT_THAT(equal("IF[#1EQ2]GOTO5\nIF[#1EQ1]GOTO4\nN4G0X#24\nN5"),
                IsEmpty()); // the last test of a list goes on to its case
}

std::vector<std::uint32_t> twice(const std::string& blocks) {
    return lines_raised("MAC719", "O9001\n" + blocks + "N9M99\n");
}

TEST(DuplicateSubcondition, StandsTwiceInOneCondition) {
    EXPECT_THAT(twice("IF[[#1EQ0]AND[#1EQ0]]GOTO9\nG0X#24\n"), ElementsAre(2));
    EXPECT_THAT(twice("IF[[#1EQ#0]OR[[#2EQ#0]OR[#1EQ#0]]]GOTO9\nG0X#24\n"), ElementsAre(2));
    EXPECT_THAT(twice("IF[[#1EQ0]AND[#2EQ0]]GOTO9\nG0X#24\n"), IsEmpty());
    EXPECT_THAT(twice("IF[[#1GT0]AND[#1LT5]]GOTO9\nG0X#24\n"), IsEmpty());
    EXPECT_THAT(twice("IF[[[#1EQ0]AND[#2EQ0]]OR[[#1EQ0]AND[#3EQ0]]]GOTO9\nG0X#24\n"), IsEmpty());
}

TEST(DuplicateSubcondition, DecidesOverOneVariableTwice) {
    EXPECT_THAT(twice("IF[#1EQ1]THEN#33=4\nIF[#1EQ2]THEN#33=5\nIF[#1EQ2]THEN#33=6\nG0X#33\n"),
                ElementsAre(4));
    EXPECT_THAT(twice("IF[#4120EQ1]THEN#33=#901003\nIF[#4120EQ1]THEN#33=#6*SQRT[2]\nG0X#33\n"),
                ElementsAre(3));
    EXPECT_THAT(twice("IF[#1EQ1]THEN#33=4\nIF[#1EQ1]THEN#33=#[30+#2]\nG0X#33\n"), IsEmpty());
    EXPECT_THAT(messages_raised("MAC719", "O9001\nIF[#1EQ2]THEN#33=5\nIF[#1EQ2]THEN#33=6\nG0X#33\nM99\n"),
                ElementsAre(AllOf(HasSubstr("line 2"), HasSubstr("#33=5"))));
    EXPECT_THAT(twice("IF[#1EQ1]THEN#33=4\nIF[#1EQ1]THEN#32=5\nG0X#33Y#32\n"), IsEmpty());
    EXPECT_THAT(twice("IF[#1EQ1]THEN#33=4\nG0X#33\nIF[#1EQ1]THEN#33=5\nG0X#33\n"), IsEmpty());
    EXPECT_THAT(twice("IF[#1EQ1]THEN#33=4\nIF[#1EQ1]THEN#33=#33+1\nG0X#33\n"), IsEmpty());
    EXPECT_THAT(twice("IF[#1GT9]THEN#1=#1-9\nIF[#1GT9]THEN#1=9\nG0X#1\n"), IsEmpty());
    EXPECT_THAT(twice("IF[#1EQ1]THEN#33=4\nIF[#33EQ4]THEN#1=2\nIF[#1EQ1]THEN#33=5\nG0X#33\n"), IsEmpty());
    EXPECT_THAT(twice("/IF[#1EQ1]THEN#33=4\nIF[#1EQ1]THEN#33=5\nG0X#33\n"), IsEmpty());
}

TEST(DuplicateSubcondition, IsLookedForInEveryBracket) {
    EXPECT_THAT(twice("IF[[#3EQ1]OR[[#1EQ0]AND[#1EQ0]]]GOTO9\nG0X#24\n"), ElementsAre(2));
    EXPECT_THAT(twice("IF[[[#1EQ0]OR[#2EQ0]]OR[#1EQ0]]GOTO9\nG0X#24\n"), ElementsAre(2));
    EXPECT_THAT(twice("IF[[#1EQ0]OR[[#1EQ0]AND[#2EQ0]]]GOTO9\nG0X#24\n"), IsEmpty());
}

TEST(DuplicateSubcondition, MayHaveOtherCasesInBetweenThatLeaveItsAnswerAlone) {
    const auto between = [](const std::string& other) {
        return twice("IF[#1EQ1]THEN#33=4\nIF[" + other + "\nIF[#1EQ1]THEN#33=5\nG0X#33\n");
    };
    EXPECT_THAT(between("#2EQ1]THEN#32=1"), ElementsAre(4));
    EXPECT_THAT(between("#2EQ1]THEN#32=#33"), IsEmpty()); // the first has served
    EXPECT_THAT(between("#33EQ1]THEN#32=1"), IsEmpty());
    EXPECT_THAT(between("#2EQ1]THEN#1=1"), IsEmpty());
    EXPECT_THAT(between("#2EQ1]THEN#2=1"), IsEmpty());
    EXPECT_THAT(between("#2EQ1]GOTO9"), IsEmpty());
}

TEST(DuplicateSubcondition, IsToldWithTheNearestBefore) {
    EXPECT_THAT(messages_raised("MAC719",
                                "O9001\nIF[#1EQ2]THEN#33=4\nIF[#1EQ2]THEN#33=5\nIF[#1EQ2]THEN#33=6\n"
                                "G0X#33\nM99\n"),
                ElementsAre(AllOf(HasSubstr("line 2"), HasSubstr("#33=4")),
                            AllOf(HasSubstr("line 3"), HasSubstr("#33=5"))));
    EXPECT_THAT(twice("GOTO9\nIF[#1EQ1]THEN#33=4\nIF[#1EQ1]THEN#33=5\nG0X#33\n"), IsEmpty());
}

TEST(DuplicateSubcondition, LeavesGuardsThatLeaveToAnotherRule) {
    EXPECT_THAT(twice("IF[#1EQ0]GOTO9\nIF[#1EQ0]GOTO9\nG0X#24\n"), IsEmpty());
}

std::vector<std::uint32_t> exact(const std::string& blocks) {
    return lines_raised("MAC726", "O9001\n" + blocks + "M99\nN9#3000=1(NO CONTACT)\n");
}

TEST(MissingTolerance, StandsWhereTheOthersHaveOne) {
    const std::string tolerant = "G31X#24F100\nIF[#5001GT[#1+#24-0.001]]GOTO9\n";
    EXPECT_THAT(exact(tolerant + "G31Z[#3-#26]\nIF[#5003LT[#3-#26]]GOTO9\n"), ElementsAre(5));
    EXPECT_THAT(exact(tolerant + "G31Y5.Z5.\nIF[#5002GT[#2+.001]]GOTO9\nIF[#3LT#5003]GOTO9\n"),
                ElementsAre(6));
    EXPECT_THAT(exact(tolerant + "G31Z[#3-#26]\nIF[#5003LT[#3-#26+0.001]]GOTO9\n"), IsEmpty());
}

TEST(MissingTolerance, IsOfComparisonsThatAskForAnOrder) {
    const auto compared = [](const std::string& condition) {
        return exact("G31X#24F100\nIF[#5001GT[#1+#24-0.001]]GOTO9\nG0Z#26\nIF[" + condition + "]GOTO9\n");
    };
    for (const std::string order : {"#5003LT#26", "#5003LE#26", "#5003GT#26", "#5003GE#26", "#26LT#5003"})
        EXPECT_THAT(compared(order), ElementsAre(5)) << order;
    for (const std::string other : {"#5003EQ#26", "#5003NE#26", "#5003LT#5001", "#5003LT-10.", "#5003LT[2*3]",
                                    "#5221LT#26", "#3001LT#26"})
        EXPECT_THAT(compared(other), IsEmpty()) << other;
    for (const std::string tolerant :
         {"#5003LT[#26-0.009]", "#5003LT[0.0005+#26]", "#5003LT[#26+#1+0.005]", "#5003LT[#26-[#1+0.005]]"})
        EXPECT_THAT(compared(tolerant), IsEmpty()) << tolerant;
    for (const std::string no_tolerance : {"#5003LT[#26-0.01]", "#5003LT[#26-0]", "#5003LT[#26*0.005]"})
        EXPECT_THAT(compared(no_tolerance), ElementsAre(5)) << no_tolerance;
}

TEST(MissingTolerance, IsOfPositionsThatTheControlMeasures) {
    // A timer runs by itself, too.
    EXPECT_THAT(exact("G31X#24F100\nIF[#3001GT[#1+#24-0.001]]GOTO9\nG0Z#26\nIF[#3001LT#26]GOTO9\n"),
                IsEmpty());
}

TEST(MissingTolerance, MayStandBehindOtherTests) {
    const auto behind = [](const std::string& blocks) {
        return exact("G31X#24F100\nIF[#5001GT[#1+#24-0.001]]GOTO9\n" + blocks + "IF[#5003LT#26]GOTO9\n")
            .size();
    };
    const auto tests = [](int count) {
        std::string text = "G0Z#26\n";
        for (int i = 0; i < count; ++i) text += "IF[#" + std::to_string(i + 2) + "EQ1]GOTO9\n";
        return text;
    };
    EXPECT_EQ(behind(tests(1)), 1U);
    EXPECT_EQ(behind(tests(7)), 1U);
    EXPECT_EQ(behind(tests(8)), 0U); // a bound on the search
    EXPECT_EQ(behind("Z5.\nX6.\n"), 1U);
    EXPECT_EQ(behind("M8\n"), 0U);
    EXPECT_EQ(behind("G0Z#26\n#3=1\n"), 0U);
    EXPECT_EQ(behind("G0Z#26\nGOTO5\nN5"), 0U); // where a jump leads, others may come from elsewhere
}

TEST(MissingTolerance, IsNoneOfWhatIsNoEndOfAMove) {
    const std::string tolerant = "G31X#24F100\nIF[#5001GT[#1+#24-0.001]]GOTO9\n";
    EXPECT_THAT(exact("G31Z[#3-#26]\nIF[#5003LT[#3-#26]]GOTO9\n"), IsEmpty()); // none has one
    EXPECT_THAT(exact(tolerant + "#32=#2\nIF[#5003LT#26]GOTO9\n"), IsEmpty());
    EXPECT_THAT(exact(tolerant + "G0Z#26\nIF[#5003LT100.]GOTO9\n"), IsEmpty());
    EXPECT_THAT(exact(tolerant + "G0Z#26\nIF[#5063LT#26]GOTO9\n"), IsEmpty()); // of another kind
    EXPECT_THAT(exact(tolerant + "G0Z#26\nIF[#1LT#26]GOTO9\n"), IsEmpty());
}

} // namespace
} // namespace maclint
