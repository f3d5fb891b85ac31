//! What a loop may change.
#include "tests/support/analysed.hpp"

#include <string>

#include <gtest/gtest.h>

namespace maclint {
namespace {

TEST(LoopChanges, AreWhatTheBodyStoresAndWhatACallMayStore) {
    const auto changes = [](const std::string& body) {
        const auto workspace =
            test::analyse_fanuc("O9001\n#33=0\nWHILE[#33LT9]DO1\n#33=#33+1\n" + body + "END1\nM99\n");
        return workspace->programs().front().loops().at(0).changes;
    };
    constexpr SpaceId local = 0, common = 1, retained = 2;
    const Variable own{local, 33}, other{local, 2}, shared{common, 100}, kept{retained, 500};
    const auto plain = changes("");
    EXPECT_TRUE(plain.may_change(own));
    EXPECT_FALSE(plain.clobbered(own));
    EXPECT_FALSE(plain.may_change(other));
    EXPECT_FALSE(plain.may_change(shared));
    const auto called = changes("G65P77\n");
    EXPECT_TRUE(called.clobbered(shared));
    EXPECT_TRUE(called.clobbered(kept));
    EXPECT_FALSE(called.may_change(other));         // a macro has locals of its own
    const auto indexed = changes("#[1+#1000]=5\n"); // #1 or #2
    EXPECT_TRUE(indexed.clobbered(other));
    EXPECT_TRUE(indexed.clobbered({local, 1}));
    EXPECT_FALSE(indexed.may_change({local, 3}));
    EXPECT_FALSE(indexed.may_change(shared));
}

} // namespace
} // namespace maclint
