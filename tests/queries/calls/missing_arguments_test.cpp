//! Arguments that no call passes, and with which a program calculates all the same.
#include "analyzer/queries/calls/missing_arguments.hpp"
#include "tests/support/analysed.hpp"

#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::queries {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// The numbers of the variables that O9 lacks, which these programs call.
std::vector<std::int32_t> missing_in(const std::string& blocks,
                                     const std::string& callers = "O1\nG65P9A1.\nM30\n") {
    const auto workspace = test::analyse_fanuc(callers + "O9\n" + blocks);
    std::vector<std::int32_t> numbers;
    for (const MissingArgument& missing : find_missing_arguments(workspace->programs().back()))
        numbers.push_back(missing.read->variable.number);
    return numbers;
}

TEST(MissingArguments, AreCalculatedWithOnAPathThatTheCallGoes) {
    EXPECT_THAT(missing_in("Z[#26+1.]\nM99\n"), ElementsAre(26));
    EXPECT_THAT(missing_in("#5=#26*2\n#6=#26*3\nM99\n"), ElementsAre(26));
    EXPECT_THAT(missing_in("IF[#1EQ1]GOTO5\nZ[#26+1.]\nN5M99\n"), IsEmpty()); // another argument chooses
    EXPECT_THAT(missing_in("IF[#1EQ2]GOTO5\nZ[#26+1.]\nN5M99\n"), ElementsAre(26));
    EXPECT_THAT(missing_in("IF[#2EQ#0]GOTO5\nZ[#26+1.]\nN5M99\n"), IsEmpty()); // B is left out, too
    EXPECT_THAT(missing_in("IF[#500EQ0]GOTO5\nZ[#26+1.]\nN5M99\n"), ElementsAre(26));
    EXPECT_THAT(missing_in("IF[#1EQ2]GOTO5\nGOTO6\nN5#3000=1\nN6Z[#26+1.]\nM99\n"), ElementsAre(26));
    EXPECT_THAT(missing_in("IF[#1EQ1]GOTO5\nGOTO6\nN5#3000=1\nN6Z[#26+1.]\nM99\n"), IsEmpty()); // the alarm
}

TEST(MissingArguments, AreMissedOnAnyWayThatTheCallCanGo) {
    // Where #1 is 2 the program goes the shorter way; the call, which passes 1, goes the other one.
    EXPECT_THAT(missing_in("IF[#1EQ2]GOTO5\n#500=1\nN5Z[#26+1.]\nM99\n"), ElementsAre(26));
    const std::string sets_it = "IF[#1EQ2]GOTO5\n#26=1.\nGOTO9\nN5Z[#26+1.]\nN9M99\n";
    EXPECT_THAT(missing_in(sets_it), IsEmpty());
    EXPECT_THAT(missing_in(sets_it, "O1\nG65P9A1.\nG65P9A2.\nM30\n"), ElementsAre(26));
    // #500 decides twice, the same both times: no call goes the one way there and the other one here.
    EXPECT_THAT(missing_in("IF[#500EQ2]GOTO4\n#26=1.\nN4IF[#500EQ2]GOTO5\nZ[#26+1.]\nN5M99\n",
                           "O1\nG65P9A1.\nG65P9A2.\nM30\n"),
                IsEmpty());
}

TEST(MissingArguments, AreNotThoseThatSomeCallPasses) {
    EXPECT_THAT(missing_in("Z[#1+1.]\nM99\n"), IsEmpty());
    EXPECT_THAT(missing_in("Z[#26+1.]\nM99\n", "O1\nG65P9A1.\nG65P9Z1.\nM30\n"), IsEmpty());
    EXPECT_THAT(missing_in("Z[#26+1.]\nM99\n", ""), IsEmpty()); // nobody is known to call
    EXPECT_THAT(missing_in("Z[#26+1.]\nM99\n", "O1\nM98P9\nM30\n"), IsEmpty());
    EXPECT_THAT(missing_in("Z[#33+1.]\nM99\n"), IsEmpty()); // no letter reaches it
}

TEST(MissingArguments, AreNotThoseThatAreAskedForOrSet) {
    EXPECT_THAT(missing_in("IF[#26EQ#0]THEN#26=2.\nZ[#26+1.]\nM99\n"), IsEmpty());
    EXPECT_THAT(missing_in("#5=#26\nIF[#5EQ#0]GOTO9\nN9Z[#26+1.]\nM99\n"), IsEmpty());
    EXPECT_THAT(missing_in("#26=2.\nZ[#26+1.]\nM99\n"), IsEmpty());
    EXPECT_THAT(missing_in("Z#26\nM99\n"), IsEmpty()); // the word is left out, as many mean it
}

} // namespace
} // namespace maclint::queries
