//! Rules of syntax: what their examples do not show.
#include "tests/rules/raised.hpp"

#include <gmock/gmock.h>

namespace maclint {
namespace {

TEST(UnknownKeyword, SaysWhatTakesThePlaceOfAnIfWithBlocks) {
    const std::string refused =
        " is no word of the control, which stops here (alarm 114). There is no block IF: ";
    EXPECT_THAT(
        test::messages_raised("MAC118", "O1\nIF[#100EQ1]THEN\n#101=2\nELSE\n#101=3\nENDIF\nM30\n"),
        ::testing::ElementsAre("'ELSE'" + refused + "let GOTO jump over the blocks.",
                               "'ENDIF'" + refused + "delete the word, or let GOTO jump over the blocks."));
}

} // namespace
} // namespace maclint
