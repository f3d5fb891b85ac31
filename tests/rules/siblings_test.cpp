//! Rules that compare statements with their neighbours: MAC215.
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

std::vector<std::uint32_t> crossed(const std::string& blocks) {
    return lines_raised("MAC215", "O9001\n" + blocks + "M99\n");
}

TEST(CrossedAxes, OfTwoStatementsOneTakesTheVariableOfTheOther) {
    EXPECT_THAT(crossed("#24=#5001+#24\n#25=#5002+#24\n"), ElementsAre(3));
    EXPECT_THAT(crossed("#24=#5001+#25\n#25=#5002+#25\n"), ElementsAre(2));
    EXPECT_THAT(crossed("#24=#5001+#24\n#25=#5002+#25\n#26=#5003+#25\n"), ElementsAre(4));
    EXPECT_THAT(crossed("#101=[#5041-#101]*#1\n#102=[#5042-#101]*#1\n"), ElementsAre(3));
    EXPECT_THAT(crossed("#24=#24*#1\n#25=#24*#2\n"), ElementsAre(3));
    EXPECT_THAT(messages_raised("MAC215", "O9001\n#24=#5001+#24\n#25=#5002+#24\nM99\n"),
                ElementsAre(AllOf(HasSubstr("'#25=#5002+#24'"), HasSubstr("Take #25"))));
}

TEST(CrossedAxes, AreNoneWhereEveryNumberFollows) {
    EXPECT_THAT(crossed("#24=#5001+#24\n#25=#5002+#25\n"), IsEmpty());
    EXPECT_THAT(crossed("#24=#5001+#1\n#25=#5002+#1\n"), IsEmpty());
    EXPECT_THAT(crossed("#24=#5001+#25\n#25=#5002+#24\n"), IsEmpty()); // an exchange
    EXPECT_THAT(crossed("#24=#24+#1\n#25=#24+#1\n"), IsEmpty());       // nothing tells the axis
}

TEST(CrossedAxes, AreOfLettersThatNameAxes) {
    EXPECT_THAT(crossed("#21=#21*#1\n#22=#21*#2\n"), ElementsAre(3)); // U and V
    EXPECT_THAT(crossed("#25=#25*#1\n#26=#25*#2\n"), ElementsAre(3)); // Y and Z
    EXPECT_THAT(crossed("#20=#20*#1\n#21=#20*#2\n"), IsEmpty());      // T and U
}

TEST(CrossedAxes, AreAlikeInEverythingElse) {
    const auto other = [](const std::string& first, const std::string& second) {
        return crossed("#24=" + first + "\n#25=" + second + "\n").size();
    };
    EXPECT_EQ(other("#24*2+#1", "#24*2+#2"), 1U);
    EXPECT_EQ(other("#24*2+#1", "#24*3+#2"), 0U);
    EXPECT_EQ(other("#5001+#24", "#5003+#24"), 0U);
    EXPECT_EQ(other("#5001+#24", "#5001+#24"), 0U);
    EXPECT_EQ(other("#5001+#24", "#5002-#24"), 0U);
    EXPECT_EQ(other("#5001+ABS[#24]", "#5002+ABS[#24]"), 1U);
    EXPECT_EQ(other("#5001+ABS[#24]", "#5002+SIN[#24]"), 0U);
    EXPECT_EQ(other("#5001+#24+#7", "#5002+#24+#8"), 1U);
    EXPECT_EQ(other("#5001+#24+#7", "#5002+#24+#9"), 0U);
    EXPECT_EQ(other("#5001+#24+#24", "#5002+#24+#25"), 1U);
    EXPECT_EQ(other("#5001+#24+#24", "#5002+#24+#24"), 0U); // which of the two is meant is not clear
    EXPECT_EQ(other("#5001+#24", "#5002+#26"), 0U);
}

TEST(CrossedAxes, AreNoSums) {
    EXPECT_THAT(crossed("#101=#101+#501\n#102=#101+#502\n"), IsEmpty());
    EXPECT_THAT(crossed("#24=#5001+#24\nG0X#24\n#25=#5002+#24\n"), IsEmpty());
    EXPECT_THAT(crossed("#24=#5001+#24\n#26=#5003+#24\n"), IsEmpty());
}

} // namespace
} // namespace maclint
