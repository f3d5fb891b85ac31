//! Rules about loops that do not end as meant: MAC319, MAC320, MAC711.
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
using ::testing::Not;

TEST(UnchangedLoop, NeverEnds) {
    EXPECT_THAT(lines_raised("MAC319", "O9001\nWHILE[#1LT5]DO1\nG91 G0 X1\nEND1\nM99\n"), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC319", "O9001\nN1 G91 G0 X1\nIF[#1EQ5]GOTO1\nM99\n"), ElementsAre(3));
    EXPECT_THAT(messages_raised("MAC319", "O9001\nWHILE[1EQ1]DO1\nG91 G0 X1\nEND1\nM99\n"),
                ElementsAre(HasSubstr("nothing leads out of")));
}

TEST(UnchangedLoop, EndsWhenItsBodyCanLeaveIt) {
    EXPECT_THAT(lines_raised("MAC319", "O9001\nDO1\n#33=#33+1\nIF[#33GT5]GOTO9\nEND1\nN9 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC319", "O9001\nWHILE[#1LT5]DO1\nM00\nEND1\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC319", "O9001\nWHILE[#1LT5]DO1\nG0 X1\n/GOTO9\nEND1\nN9 M99\n"), IsEmpty());
}

TEST(InfiniteLoop, ThatSetsItsCounterBackInEachPassIsOne) {
    EXPECT_THAT(messages_raised("MAC319", "O9001\n#1=0\nWHILE[#1LT5]DO1\n#1=0\nG0X1.\n#1=#1+1\nEND1\nM99\n"),
                ElementsAre(HasSubstr("'[#1LT5]' turns out the same in every pass")));
    EXPECT_THAT(lines_raised("MAC319", "O9001\n#1=0\nWHILE[#1LT5]DO1\nG0X1.\n#1=#1+1\nEND1\nM99\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC319", "O9001\n#1=0\nWHILE[#1LT5]DO1\n#1=#2\nG0X1.\n#1=#1+1\nEND1\nM99\n"),
                IsEmpty());
    // Somebody else may set #500 while the loop waits.
    EXPECT_THAT(lines_raised("MAC319", "O9001\n#500=0\nWHILE[#500LT5]DO1\nG4P100\nEND1\nM99\n"), IsEmpty());
    // Steps away from the end are MAC320's.
    EXPECT_THAT(lines_raised("MAC319", "O9001\n#1=3\nWHILE[#1GT0]DO1\nG0X1.\n#1=#1+1\nEND1\nM99\n"),
                IsEmpty());
}

TEST(UnchangedLoop, MayWaitForTheMachineOrForSomebodyElse) {
    EXPECT_THAT(lines_raised("MAC319", "O9001\nWHILE[#1004EQ0]DO1\nEND1\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC319", "O9001\nN1 IF[#890EQ3]GOTO2\nG04 P1000\nGOTO1\nN2 M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC319", "O9001\nWHILE[#100LT5]DO1\nG91 G0 X1\nEND1\nM99\n"), ElementsAre(2));
}

TEST(UnchangedLoop, IsChangedOnlyByWhatACallCanReach) {
    const std::string callee = "O9002\n#100=#100+1\nM99\n";
    EXPECT_THAT(lines_raised("MAC319", "O9001\nWHILE[#1LT5]DO1\nG65 P9002\nEND1\nM99\n" + callee),
                ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC319", "O9001\nWHILE[#100LT5]DO1\nG65 P9002\nEND1\nM99\n" + callee),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC319", "O9001\nWHILE[#1LT5]DO1\nG65 P9999\nEND1\nM99\n"), IsEmpty());
    EXPECT_THAT(
        lines_raised("MAC319", "O9001\nWHILE[#1LT5]DO1\nG65 P9002\nEND1\nM99\nO9002\n#3000=1(STOP)\nM99\n"),
        IsEmpty());
}

TEST(UnchangedLoop, IsChangedByAStoreThroughAnIndex) {
    EXPECT_THAT(lines_raised("MAC319", "O9001\nWHILE[#1LT5]DO1\n#[#2]=9\nEND1\nM99\n"), IsEmpty());
}

TEST(LoopStep, MayBeAMissingArgument) {
    EXPECT_THAT(lines_raised("MAC320", "O9001\n#33=0\nWHILE[#33LT#1]DO1\n#33=#33+#6\nEND1\nM99\n"),
                ElementsAre(4));
    EXPECT_THAT(
        lines_raised("MAC320", "O9001\nIF[#6LE0]GOTO9\n#33=0\nWHILE[#33LT#1]DO1\n#33=#33+#6\nEND1\nN9 M99\n"),
        IsEmpty());
    EXPECT_THAT(lines_raised("MAC320",
                             "O9001\nIF[#6EQ#0]THEN#6=1\n#33=0\nWHILE[#33LT#1]DO1\n#33=#33+#6\nEND1\nM99\n"),
                IsEmpty());
}

TEST(LoopStep, IsNotSavedByAClampToTheBound) {
    EXPECT_THAT(
        lines_raised("MAC320",
                     "O9001\n#33=0\nWHILE[#33LT#1]DO1\n#33=#33+#6\nIF[#33GT#1]THEN#33=#1\nEND1\nM99\n"),
        ElementsAre(4));
}

TEST(LoopStep, OfTheWrongSignLeadsAway) {
    EXPECT_THAT(messages_raised("MAC320", "O9001\n#33=0\nWHILE[#33LT5]DO1\n#33=#33-1\nEND1\nM99\n"),
                ElementsAre(HasSubstr("leads away")));
    EXPECT_THAT(messages_raised("MAC320", "O9001\n#33=0\nWHILE[-#33GE-5]DO1\n#33=#33-1\nEND1\nM99\n"),
                ElementsAre(HasSubstr("leads away")));
    EXPECT_THAT(lines_raised("MAC320", "O9001\n#33=9\nWHILE[#33GE0]DO1\n#33=#33-1\nEND1\nM99\n"), IsEmpty());
}

TEST(LoopStep, OfNothingIsReported) {
    EXPECT_THAT(messages_raised("MAC320", "O9001\n#33=0\nWHILE[#33LT5]DO1\n#33=#33+0\nEND1\nM99\n"),
                ElementsAre(HasSubstr("its step is 0")));
}

TEST(InexactCounter, LosesOrDoublesItsLastPass) {
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0\nWHILE[#33LE1]DO1\n#33=#33+0.1\nEND1\nM99\n"),
                ElementsAre(4));
    EXPECT_THAT(
        lines_raised("MAC711", "O9001\n#6=360/#6\n#33=0\nWHILE[#33LE360]DO1\n#33=#33+#6\nEND1\nM99\n"),
        ElementsAre(5));
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0.025\nWHILE[#33LE1.025]DO1\n#33=#33+0.1\nEND1\nM99\n"),
                ElementsAre(4));
}

TEST(InexactCounter, LosesAPassWhateverElseEndsTheLoop) {
    EXPECT_THAT(lines_raised("MAC711",
                             "O9001\n#33=0\nWHILE[#33LE1]DO1\nIF[#1004EQ1]GOTO9\n#33=#33+0.1\nEND1\n"
                             "#3000=1\nN9M99\n"),
                ElementsAre(5));
    EXPECT_THAT(lines_raised("MAC711",
                             "O9001\n#33=0\nN1G4X1.\nIF[#1004EQ1]GOTO9\n#33=#33+.05\nIF[#33LT4]GOTO1\n"
                             "#3000=1\nN9M99\n"),
                ElementsAre(5));
}

TEST(InexactCounter, MayBeStoredInByACalledProgram) {
    EXPECT_THAT(
        lines_raised("MAC711", "O9001\n#33=0\nWHILE[#33LT1]DO1\nM98P7\n#33=#33+0.1\nEND1\nG0X#24\nM99\n"),
        ElementsAre(5));
    EXPECT_THAT(
        lines_raised("MAC711", "O9001\n#33=0\nWHILE[#33LT#501]DO1\nG65P7\n#33=#33+0.1\nEND1\nG0X#24\nM99\n"),
        ElementsAre(5));
    // What the text changes is another matter: nobody knows how far it is.
    EXPECT_THAT(
        lines_raised("MAC711", "O9001\n#33=0\nWHILE[#33LT#501]DO1\n#501=#501+0.1\n#33=#33+0.1\nEND1\nM99\n"),
        IsEmpty());
}

TEST(InexactCounter, IsHarmlessWhenExactClampedOrWithRoomAtItsEnd) {
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0.025\nWHILE[#33LE1.075]DO1\n#33=#33+0.1\nEND1\nM99\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0\nWHILE[#33LE1]DO1\n#33=#33+0.5\nEND1\nM99\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0\nWHILE[#33LE10.001]DO1\n#33=#33+0.1\nEND1\nM99\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0\nWHILE[#33LT9.9999]DO1\n#33=#33+0.1\nEND1\nM99\n"),
                IsEmpty());
    // A thousand times as many steps add up to more than that.
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0\nWHILE[#33LT9999.9999]DO1\n#33=#33+0.1\nEND1\nM99\n"),
                ElementsAre(4));
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0\nWHILE[#33LE1.05]DO1\n#33=#33+0.1\nEND1\nM99\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0\nWHILE[#33LE[#1+0.001]]DO1\n#33=#33+0.1\nEND1\nM99\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC711",
                             "O9001\n#33=0\nWHILE[#33LT1]DO1\n#33=#33+0.1\nIF[#33GT1]THEN#33=1\nEND1\nM99\n"),
                IsEmpty());
}

TEST(InexactCounter, ThatMustMeetItsBoundIsNotCuredByAnotherBound) {
    const auto until = [](const std::string& bound) {
        return messages_raised("MAC711",
                               "O9001\n#31=0\nWHILE[#31NE" + bound + "]DO1\n#31=#31+0.1\nEND1\nM99\n");
    };
    const auto says = AllOf(HasSubstr("whether the bound is passed"), Not(HasSubstr("half a step")));
    EXPECT_THAT(until("1"), ElementsAre(says));
    EXPECT_THAT(until("1.05"), ElementsAre(says));
    EXPECT_THAT(messages_raised("MAC711", "O9001\n#31=0\nN1 #31=#31+0.1\nIF[#31EQ1]GOTO2\nGOTO1\nN2 M99\n"),
                ElementsAre(HasSubstr("whether the bound is passed")));
}

TEST(InexactCounter, StartsWhereTheLastAssignmentBeforeTheLoopPutsIt) {
    const std::string loop = "WHILE[#33LE1]DO1\n#33=#33+0.1\nEND1\n";
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0.05\nG0 X#33\n#33=0\n" + loop + "M99\n"), ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0\nG0 X#33\n#33=0.05\n" + loop + "M99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0.05\n" + loop + "#33=0\nG0 X#33\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0.05\nIF[#1EQ1]THEN #33=0\n" + loop + "M99\n"),
                ElementsAre(5));
}

TEST(InexactCounter, HasNoToleranceInWhatIsAStepOrMore) {
    const auto with = [](const std::string& bound) {
        return lines_raised("MAC711",
                            "O9001\n#33=0\nWHILE[#33LT[" + bound + "]]DO1\n#33=#33+0.1\nEND1\nM99\n");
    };
    EXPECT_THAT(with("#1-0.05"), IsEmpty());
    EXPECT_THAT(with("#1-0.5"), ElementsAre(4));
    EXPECT_THAT(with("#1+0.1"), ElementsAre(4));
}

TEST(InexactCounter, HasRoomWhereItsBoundIsBetweenTwoSteps) {
    const auto of = [](const std::string& start, const std::string& condition, const std::string& step) {
        return lines_raised("MAC711", "O9001\n#33=" + start + "\nWHILE[#33" + condition + "]DO1\n#33=#33" +
                                          step + "\nEND1\nM99\n")
            .size();
    };
    EXPECT_EQ(of("1", "GE0", "-0.1"), 1U);
    EXPECT_EQ(of("1", "GE-0.05", "-0.1"), 0U);
    EXPECT_EQ(of("1", "GT0.05", "-0.1"), 0U);
    EXPECT_EQ(of("0.5", "LE1.05", "+0.1"), 0U);
    EXPECT_EQ(of("0.55", "LE1.05", "+0.1"), 1U);
    EXPECT_EQ(of("0", "LE1.0005", "+0.1"), 0U);
    EXPECT_EQ(of("0", "LE1.0000001", "+0.1"), 1U); // as much as the last digits of ten sums may make
    EXPECT_EQ(of("0", "LE1.002", "+0.1"), 0U);
    EXPECT_EQ(of("1", "GT[#1-0.05]", "-0.1"), 0U);
    EXPECT_EQ(of("1", "GT[#1-0.5]", "-0.1"), 1U);
    EXPECT_EQ(of("0", "LT[0.05+#1]", "+0.1"), 0U);
    EXPECT_EQ(of("0", "LT[#1+0]", "+0.1"), 1U);
    EXPECT_EQ(of("0", "LT[#1*0.05]", "+0.1"), 1U);
}

TEST(InexactCounter, OfAStepThatOnlyTheRunningProgramKnowsMayHaveATolerance) {
    const auto with = [](const std::string& bound) {
        return lines_raised("MAC711",
                            "O9001\n#6=#2/3\n#33=0\nWHILE[#33LT[" + bound + "]]DO1\n#33=#33+#6\nEND1\nM99\n")
            .size();
    };
    EXPECT_EQ(with("#1+0.5"), 0U);
    EXPECT_EQ(with("#1+1"), 1U); // as long as a step may be
}

TEST(InexactCounter, IsHarmlessWhereTheLoopGoesOnOnlyAtItsBound) {
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0\nN1#33=#33+0.1\nIF[#33EQ1]GOTO1\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0\nN1#33=#33+0.1\nIF[#33NE1]GOTO1\nM99\n"),
                ElementsAre(3));
    // Of a step that is read, or that a function gives, nobody knows.
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0\nN1#33=#33+#2\nIF[#33LE1]GOTO1\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0\nN1#33=#33+SIN[#2]\nIF[#33LE1]GOTO1\nM99\n"), IsEmpty());
}

TEST(InexactCounter, OfTwoLoopsIsToldOnce) {
    EXPECT_THAT(lines_raised("MAC711", "O9001\n#33=0\nN1G0X#33\nN2#33=#33+0.1\nIF[#33LE1]GOTO2\n"
                                       "IF[#33LE5]GOTO1\nM99\n"),
                ElementsAre(4));
}

TEST(LoopStep, NamedByABlockThatCannotBeReadMayHaveBeenTestedThere) {
    EXPECT_THAT(lines_raised("MAC320",
                             "O9001\nOR[#17EQ#0]GOTO5\n#33=0\nWHILE[#33LT9]DO1\n#33=#33+#17\nG0 X#33\nEND1\n"
                             "N5 M99\n"),
                IsEmpty());
}

TEST(UnchangedLoop, IsExcusedByAnAlarmOfACallOnlyWhereSomethingDecidesItAnew) {
    const auto loop = [](std::string_view call, std::string_view condition, std::string_view loop_step = "") {
        return "O9001\nWHILE[#1LT5]DO1\n" + std::string(call) + "\n" + std::string(loop_step) +
               "END1\nM99\nO9010\nIF[" + std::string(condition) + "]GOTO9\nM99\nN9#3000=1\n";
    };
    EXPECT_THAT(lines_raised("MAC319", loop("G65P9010", "#500EQ1")), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC319", loop("G65P9010", "#1EQ1")), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC319", loop("G65P9010A#2", "#1EQ1")), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC319", loop("G65P9010", "#5043GT1")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC319", loop("G65P9010A#5043", "#1EQ1")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC319", loop("G65P9010", "#500EQ1", "#500=#500+1\n")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC319", loop("G65P9010A#2", "#1EQ1", "#2=#2+1\n")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC319", loop("M98P9010", "#2EQ1", "#2=#2+1\n")), IsEmpty());
    // What each round sets anew from nothing that changes is the same in each.
    EXPECT_THAT(lines_raised("MAC319", loop("#4=#2*2\n#5=#4+1\nG65P9010A#5", "#1EQ1")), ElementsAre(2));
    EXPECT_THAT(lines_raised("MAC319", loop("G65P9010A#4", "#1EQ1", "#4=#2*2\n")), IsEmpty()); // later
    EXPECT_THAT(lines_raised("MAC319", loop("#4=#5043\nG65P9010A#4", "#1EQ1")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC319", loop("IF[#5043GT1]THEN#4=2\nG65P9010A#4", "#1EQ1")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC319", loop("IF[#5043GT1]GOTO2\n#4=2\nN2G65P9010A#4", "#1EQ1")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC319", loop("#4=#6\n#6=#6+1\nG65P9010A#4", "#1EQ1")), IsEmpty());
    // The callee counts itself, or what decides is made of what the machine tells.
    EXPECT_THAT(lines_raised("MAC319", "O9001\nWHILE[#1LT5]DO1\nG65P9010\nEND1\nM99\nO9010\n#500=#500+1\n"
                                       "IF[#500GT9]GOTO9\nM99\nN9#3000=1\n"),
                IsEmpty());
    EXPECT_THAT(lines_raised("MAC319", "O9001\nWHILE[#1LT5]DO1\nG65P9010\nEND1\nM99\nO9010\n#2=#5043-1\n"
                                       "IF[#2GT9]GOTO9\nM99\nN9#3000=1\n"),
                IsEmpty());
}

TEST(UnchangedLoop, ThatJumpsToItsOwnBlockHangsTheControl) {
    EXPECT_THAT(messages_raised("MAC319", "O9001\nN51IF[#26EQ#0]GOTO51\nM99\n"),
                ElementsAre(HasSubstr("its own block")));
}

} // namespace
} // namespace maclint
