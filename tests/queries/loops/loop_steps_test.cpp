//! A loop whose every step has a fault never ends.
#include "analyzer/queries/loops/loop_steps.hpp"
#include "tests/support/analysed.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

/// The faults of a macro's loops.
std::vector<StepFault> faults_of(const std::string& text) {
    const auto workspace = test::analyse_fanuc("O9001\n" + text + "N98M99\nN99M99\n");
    std::vector<StepFault> faults;
    for (const EndlessCounter& found : find_endless_counters(workspace->programs().front()))
        faults.push_back(found.fault);
    return faults;
}

using testing::ElementsAre;
using testing::IsEmpty;

TEST(EndlessCounters, StepByWhatMayBeVacant) {
    EXPECT_THAT(faults_of("#33=0\nWHILE[#33LT9]DO1\n#33=#33+#6\nEND1\n"), ElementsAre(StepFault::vacant));
    EXPECT_THAT(faults_of("IF[#6LE0]GOTO98\n#33=0\nWHILE[#33LT9]DO1\n#33=#33+#6\nEND1\n"), IsEmpty());
    // #10 is no argument: that it is vacant is said of it elsewhere.
    EXPECT_THAT(faults_of("X#24\n#33=0\nWHILE[#33LT9]DO1\n#33=#33+#10\nEND1\n"), IsEmpty());
}

TEST(EndlessCounters, StepByZeroOrAwayFromTheBound) {
    EXPECT_THAT(faults_of("#33=0\nWHILE[#33LT9]DO1\n#33=#33+0\nEND1\n"), ElementsAre(StepFault::zero));
    EXPECT_THAT(faults_of("#33=0\nWHILE[#33LT9]DO1\n#33=#33-1\nEND1\n"), ElementsAre(StepFault::wrong_sign));
    EXPECT_THAT(faults_of("#33=9\nWHILE[#33GE0]DO1\n#33=#33+1\nEND1\n"), ElementsAre(StepFault::wrong_sign));
    EXPECT_THAT(faults_of("#33=9\nWHILE[#33GT0]DO1\n#33=#33+1\nEND1\n"), ElementsAre(StepFault::wrong_sign));
    EXPECT_THAT(faults_of("#33=0\nWHILE[#33LE9]DO1\n#33=#33-1\nEND1\n"), ElementsAre(StepFault::wrong_sign));
    EXPECT_THAT(faults_of("#33=9\nWHILE[#33GE0]DO1\n#33=#33-1\nEND1\n"), IsEmpty());
    EXPECT_THAT(faults_of("#33=9\nWHILE[#33NE0]DO1\n#33=#33+1\nEND1\n"), IsEmpty()); // it may wrap around
}

TEST(EndlessCounters, StepAwayFromAllBounds) {
    // Down it comes to 0, though never to 20.
    EXPECT_THAT(faults_of("#33=9\nWHILE[#33GT0]DO1\nIF[#33GE20]GOTO99\n#33=#33-1\nEND1\n"), IsEmpty());
    EXPECT_THAT(faults_of("#33=9\nWHILE[#33LT30]DO1\nIF[#33GE20]GOTO99\n#33=#33-1\nEND1\n"),
                ElementsAre(StepFault::wrong_sign));
}

TEST(EndlessCounters, HaveNoStepThatIsRight) {
    EXPECT_THAT(faults_of("#33=0\nWHILE[#33LT9]DO1\n#33=#33+0\n#33=#33+1\nEND1\n"), IsEmpty());
    EXPECT_THAT(faults_of("#33=0\nWHILE[#33LT9]DO1\n#33=#33+0\n#33=#33-1\nEND1\n"),
                ElementsAre(StepFault::zero));
}

TEST(EndlessCounters, AreNotEndedByAnythingElse) {
    EXPECT_THAT(faults_of("#33=0\nWHILE[#33LT9]DO1\n#33=#33+0\nIF[#501EQ1]THEN#3000=1(NO)\nEND1\n"),
                IsEmpty());
    EXPECT_THAT(faults_of("#33=0\nWHILE[#33LT9]DO1\n#33=#33+0\nM98P77\nEND1\n"), IsEmpty());
}

TEST(EndlessCounters, AreNotAskedOfWhereTheLoopCanStop) {
    const auto with = [](const std::string& block) {
        return faults_of("#33=0\nWHILE[#33LT9]DO1\n#33=#33+0\n" + block + "\nEND1\n");
    };
    for (const std::string stop : {"M00", "M01", "G65P77", "G65P77A#33"})
        EXPECT_THAT(with(stop), IsEmpty()) << stop;
    for (const std::string other : {"G31X5.", "G4X1.", "M8", "X#33"})
        EXPECT_THAT(with(other), ElementsAre(StepFault::zero)) << other;
}

TEST(EndlessCounters, AreOneForLoopsThatStepTogether) {
    EXPECT_THAT(faults_of("#33=0\nN1#33=#33+0\nIF[#33LT5]GOTO1\nIF[#33LT9]GOTO1\n"),
                testing::SizeIs(testing::Le(1U)));
}

} // namespace
} // namespace maclint::queries
