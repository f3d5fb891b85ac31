//! Rules of syntax: what their examples do not show.
#include "tests/rules/raised.hpp"

#include <gmock/gmock.h>

namespace maclint {
namespace {

TEST(UnknownKeyword, SaysWhatTakesThePlaceOfAnIfWithBlocks) {
    EXPECT_THAT(
        test::messages_raised("MAC118", "O1\nIF[#100EQ1]THEN\n#101=2\nENDIF\nM30\n"),
        ::testing::ElementsAre("'ENDIF' is no word of the control, which stops here. There is no block "
                               "IF: let GOTO jump over the blocks."));
}

} // namespace
} // namespace maclint
