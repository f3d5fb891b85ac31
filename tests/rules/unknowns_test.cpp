//! What stores through an index, calls and computed jumps leave known, seen through the rules that ask.
#include "tests/rules/raised.hpp"

#include <gmock/gmock.h>

namespace maclint {
namespace {

using test::lines_raised;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A variable that one of two paths does not set, after a block.
std::string set_on_one_path_after(std::string_view block) {
    return "O9001\n" + std::string(block) + "\nIF[#24GT1.]GOTO1\n#31=1.\nN1G0X#31\nM99\n";
}

TEST(StoreThroughAnIndex, OfAToolOffsetChangesNoVariable) {
    const std::string store = "#11=#4111\n#[10000+#11]=#5063\n";
    EXPECT_THAT(lines_raised("MAC209", set_on_one_path_after("#11=#4111\n#[10000+#11]=#5063")),
                ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC503", "O9001\n#6=#4003\n" + store + "G91G1X#24F#514\nG#6\nM99\n"),
                ElementsAre(5));
    EXPECT_THAT(lines_raised("MAC505", "O9001\n#6=#4003\n" + store + "G1X#24F#6\nM99\n"), ElementsAre(5));
}

TEST(StoreThroughAnIndex, FromABaseOrACommonVariableReachesNoLocal) {
    for (const std::string_view block :
         {"#[2000+#3]=0", "#[#3+2000]=0", "#[100+#3]=0", "#[500-#3]=0", "#[#111+6]=0", "#[#501+#3]=0"})
        EXPECT_THAT(lines_raised("MAC209", set_on_one_path_after(block)), ElementsAre(5)) << block;
    for (const std::string_view block : {"#[#3]=0", "#[#3+6]=0", "#[99+#3]=0", "#[#111]=0", "#[#3-#111]=0"})
        EXPECT_THAT(lines_raised("MAC209", set_on_one_path_after(block)), IsEmpty()) << block;
}

TEST(StoreThroughAnIndex, ThatAnAssignmentGivesABaseReachesNoLocal) {
    const auto with_index = [](std::string_view assignments) {
        return set_on_one_path_after(std::string(assignments) + "\n#[#10]=0");
    };
    EXPECT_THAT(lines_raised("MAC209", with_index("#10=5221+[#3-54]*20")), ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC209", with_index("#10=5221+#3\n#10=#10+20")), ElementsAre(7)); // a step
    EXPECT_THAT(lines_raised("MAC209", with_index("#10=5221+#3\nIF[#3EQ1]THEN#10=7001+#4")), ElementsAre(7));
    EXPECT_THAT(lines_raised("MAC209", set_on_one_path_after("#10=95+#3\n#[#10+5]=0")), ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC209", with_index("#10=99+#3")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", with_index("#10=5221+#3\nIF[#3EQ1]THEN#10=#4")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", with_index("#11=5221+#3\n#10=#3")), IsEmpty());
}

TEST(StoreThroughAnIndex, ThatACallMayPassReachesLocals) {
    const auto with_index = [](std::string_view before) {
        return set_on_one_path_after(std::string(before) + "\n#[#1]=0");
    };
    EXPECT_THAT(lines_raised("MAC209", with_index("#1=500+#3")), ElementsAre(6)); // whatever is passed
    EXPECT_THAT(lines_raised("MAC209", with_index("#2=#1\n#1=500+#3")), ElementsAre(7));
    EXPECT_THAT(lines_raised("MAC209", with_index("IF[#1EQ#0]THEN#1=500+#3")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", with_index("IF[#1NE#0]GOTO2\n#1=500+#3\nN2")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", with_index("/#1=500+#3")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", with_index("WHILE[#1EQ#0]DO1\n#1=500+#3\nEND1")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", set_on_one_path_after("#[#1]=0\n#1=500+#3")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", with_index("IF[#3EQ1]GOTO2\n#1=500+#3\nGOTO3\nN2#1=7001+#4\nN3")),
                ElementsAre(10)); // whichever way is taken
    // #10 is no argument.
    EXPECT_THAT(lines_raised("MAC209", set_on_one_path_after("#10=600\nIF[#3EQ1]THEN#10=500+#3\n#[#10]=0")),
                ElementsAre(7));
}

TEST(StoreThroughAnIndex, MayChangeCommonVariables) {
    const auto after = [](std::string_view block) {
        return "O9001\n#100=0\n" + std::string(block) + "\n#5=#2/#100\nM99\n";
    };
    EXPECT_THAT(lines_raised("MAC702", after("#[2000+#3]=1")), ElementsAre(4));
    EXPECT_THAT(lines_raised("MAC702", after("#[500+#3]=1")), ElementsAre(4));
    for (const std::string_view block : {"#[100+#3]=1", "#[#111+6]=1", "#[#3]=1"})
        EXPECT_THAT(lines_raised("MAC702", after(block)), IsEmpty()) << block;
}

TEST(StoreThroughAnIndex, InALoopReachesTheRangeOfTheLoop) {
    const auto cleared = [](std::string_view first, std::string_view last) {
        return "#27=" + std::string(first) + "\nWHILE[#27LE" + std::string(last) +
               "]DO1\n#[#27]=1\n#27=#27+1\nEND1";
    };
    EXPECT_THAT(lines_raised("MAC209", set_on_one_path_after(cleared("135", "149"))), ElementsAre(9));
    EXPECT_THAT(lines_raised("MAC209", set_on_one_path_after(cleared("30", "33"))), IsEmpty());
}

TEST(StoreThroughAnIndex, SparesWhatCountsIt) {
    EXPECT_THAT(lines_raised("MAC320", "O9001\n#1=135\nWHILE[#1LE149]DO1\n#[#1]=#0\n#1=#1-1\nEND1\nM99\n"),
                ElementsAre(5));
    EXPECT_THAT(lines_raised("MAC319", "O9001\nWHILE[#1LT5]DO1\n#[#1]=9\nEND1\nM99\n"), ElementsAre(2));
}

/// A variable that a path with an error does not set; that path ends with the blocks.
std::string not_set_after(std::string_view error, std::string_view callee) {
    return "O9001\nIF[#26NE#0]GOTO1\n" + std::string(error) + "\nGOTO2\nN1#31=#26\nN2G0Z#31\nM99\n" +
           std::string(callee);
}

TEST(CallThatEndsInAnAlarm, ForANumberInACommonVariableDoesNotComeBack) {
    const std::string by_jump = "O9700\nGOTO#149\nN260#3000=91(Z MISSING)\nN500M99\n";
    const std::string by_test = "O9700\nIF[#149NE260]GOTO500\n#3000=91(Z MISSING)\nN500M99\n";
    for (const std::string& callee : {by_jump, by_test}) {
        EXPECT_THAT(lines_raised("MAC209", not_set_after("#149=260\nG65P9700", callee)), IsEmpty());
        EXPECT_THAT(lines_raised("MAC209", not_set_after("#149=260\nM98P9700", callee)), IsEmpty());
        EXPECT_THAT(lines_raised("MAC209", not_set_after("#149=500\nG65P9700", callee)), ElementsAre(7));
        EXPECT_THAT(lines_raised("MAC209", not_set_after("#149=#500\nG65P9700", callee)), ElementsAre(7));
    }
}

TEST(CallThatEndsInAnAlarm, ForAnArgumentDoesNotComeBack) {
    const std::string callee =
        "O9700\nIF[#8EQ#0]GOTO1\n#149=#8\nN1\nGOTO#149\nN260#3000=91(Z MISSING)\nN500M99\n";
    EXPECT_THAT(lines_raised("MAC209", not_set_after("G65P9700E260.", callee)), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", not_set_after("G65P9700E500.", callee)), ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC209", not_set_after("G65P9700E#8", callee)), ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC209", not_set_after("#149=260\nG65P9700", callee)), IsEmpty());
}

TEST(ComputedJump, GoesWhereTheNumbersThatReachItLead) {
    const auto program = [](std::string_view second) {
        return "O9001\n#32=50\nN50IF[#24LE#7]GOTO56\n#32=" + std::string(second) +
               "\nGOTO63\nN56IF[#1EQ#0]GOTO58\n#29=#17\nGOTO64\nN58GOTO#32\nN63GOTO#32\nN64G0X#29\nM99\n";
    };
    EXPECT_THAT(lines_raised("MAC209", program("56")), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", program("64")), ElementsAre(11));
}

TEST(ComputedJump, ToWhatIsUnknownOnOnePathGoesAnywhere) {
    const auto program = [](std::string_view number) {
        return "O9001\n#32=10\nIF[#1EQ1]THEN#32=" + std::string(number) +
               "\nGOTO#32\nN10M99\nN15G0X#29\nM99\n";
    };
    EXPECT_THAT(lines_raised("MAC209", program("#2")), ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC209", program("15")), ElementsAre(6));
    EXPECT_THAT(lines_raised("MAC209", program("20")), IsEmpty());
}

TEST(GCodeOfTheShop, TakesItsWordsAsArguments) {
    const std::string caller = "O1\nG65P9001\nG1X1.\nM30\n";
    EXPECT_THAT(lines_raised("MAC503", caller + "O9001\nG180A#1F#9X#24\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC503", caller + "O9001\nG1A#1F#9X#24\nM99\n"), ElementsAre(6));
}

TEST(GCodeOfTheShop, MaySetTheLocalThatAWordNames) {
    EXPECT_THAT(lines_raised("MAC209", "O9001\nG0310R8178P28\nG0X#28Y#24\nM99\n"), IsEmpty());
    EXPECT_THAT(lines_raised("MAC209", "O9001\nG0310R8178P28\nG0X#29Y#24\nM99\n"), ElementsAre(3));
    EXPECT_THAT(lines_raised("MAC209", "O9001\nG31P28\nG0X#28Y#24\nM99\n"), ElementsAre(3));
}

} // namespace
} // namespace maclint
