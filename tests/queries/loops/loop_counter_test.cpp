//! Which variable counts the rounds of a loop.
#include "analyzer/queries/loops/loop_counter.hpp"
#include "tests/support/analysed.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace maclint {
namespace {

constexpr SpaceId local = 0;

/// The only loop of a macro.
class Looping {
  public:
    explicit Looping(const std::string& text)
        : workspace_(test::analyse_fanuc("O9001\n" + text + "N98M99\nN99M99\n")) {
        const ProgramAnalysis& program = workspace_->programs().front();
        EXPECT_EQ(program.loops().size(), 1U);
        counter_ = queries::counter_of(program, program.loops().front());
    }
    const queries::Counter* operator->() const { return &*counter_; }
    explicit operator bool() const { return counter_.has_value(); }

  private:
    std::unique_ptr<Workspace> workspace_; // the counter points into its facts
    std::optional<queries::Counter> counter_;
};

/// A WHILE loop of that condition and body.
Looping looping(const std::string& condition, const std::string& body) {
    return Looping("#33=0\nWHILE[" + condition + "]DO1\n" + body + "END1\n");
}

TEST(Counter, StaysInTheLoopAsTheConditionSays) {
    const auto stays = [](const std::string& condition) {
        const Looping found = looping(condition, "#33=#33+1\n");
        if (!found) return Operation::unknown;
        EXPECT_EQ(found->variable, (Variable{local, 33})) << condition;
        return found->tests.front().stays;
    };
    EXPECT_EQ(stays("#33LT#1"), Operation::less);
    EXPECT_EQ(stays("#33NE#1"), Operation::not_equal);
    EXPECT_EQ(stays("#1GE#33"), Operation::less_equal);
    EXPECT_EQ(stays("-#33GT#1"), Operation::less);
    EXPECT_EQ(stays("#1GT-#33"), Operation::greater);
    EXPECT_EQ(stays("#1EQ#33"), Operation::equal);
}

TEST(Counter, StaysInTheLoopUntilAJumpLeavesIt) {
    const Looping found("#33=0\nN1#33=#33+1\nIF[#33GE#1]GOTO98\nGOTO1\n");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->tests.front().stays, Operation::less);
    const Looping back("#33=0\nN1#33=#33+1\nIF[#33LE#1]GOTO1\n");
    ASSERT_TRUE(back);
    EXPECT_EQ(back->tests.front().stays, Operation::less_equal);
}

TEST(Counter, HasABoundThatStaysWhatItIs) {
    const auto bound = [](const std::string& condition) {
        const Looping found = looping(condition, "#33=#33+1\n");
        return found ? found->tests.front().bound_value->constant() : std::nullopt;
    };
    EXPECT_EQ(bound("#33LT9"), 9);
    EXPECT_EQ(bound("9GT#33"), 9);
    EXPECT_FALSE(looping("#33LT[#1+#2]", "#33=#33+1\n#2=#2+1\n"));
    EXPECT_FALSE(looping("#33LT[#1+#2]", "#33=#33+1\n#1=#1+1\n"));
    EXPECT_TRUE(looping("#33LT[#1+#2]", "#33=#33+1\n#3=#3+1\n"));
    EXPECT_FALSE(looping("#33LT#[#1]", "#33=#33+1\n")); // who knows what that is
    EXPECT_FALSE(looping("#33LT[#33+#1]", "#33=#33+1\n"));
    EXPECT_FALSE(looping("[#33+1]LT#1", "#33=#33+1\n")); // the variable alone, or minus it
}

TEST(Counter, IsCheckedAtEveryWayOut) {
    EXPECT_FALSE(looping("#33LT9", "#33=#33+1\n#32=#32+1\nIF[#32GT5]GOTO99\n")); // two that count
    EXPECT_FALSE(looping("#33LT9", "#33=#33+1\nIF[#2EQ#0]GOTO99\n"));
    EXPECT_FALSE(looping("#33LT9", "#33=#33+1\nIF[[#33GT5]AND[#33LT8]]GOTO99\n"));
    EXPECT_FALSE(looping("[#33LT9]AND[#33LT#1]", "#33=#33+1\n"));
    const Looping twice = looping("#33LT9", "#33=#33+1\nIF[#33GT#2]GOTO99\n");
    ASSERT_TRUE(twice);
    ASSERT_EQ(twice->tests.size(), 2U);
    EXPECT_EQ(twice->tests[1].stays, Operation::less_equal);
}

TEST(Counter, OnlyStepsAndIsClamped) {
    const auto count = [](const std::string& body) {
        const Looping found = looping("#33LT9", body);
        return found ? std::pair(found->steps.size(), found->clamps.size())
                     : std::pair<std::size_t, std::size_t>();
    };
    using Sizes = std::pair<std::size_t, std::size_t>;
    constexpr Sizes none{};
    EXPECT_EQ(count("#33=#33+1\n"), Sizes(1, 0));
    EXPECT_EQ(count("#33=1+#33\n#33=#33-0.5\n"), Sizes(2, 0));
    EXPECT_EQ(count("#33=#33+1\nIF[#33GT8]THEN#33=8\n"), Sizes(1, 1));
    EXPECT_EQ(count("#33=#33+1\nIF[#2GT8]THEN#33=8\n"), none); // another's condition
    EXPECT_EQ(count("#33=#33+1\nIF[#33LE8]GOTO5\nN6#33=8\nN5\n"), Sizes(1, 1));
    EXPECT_EQ(count("#33=#33+1\nIF[#3EQ1]GOTO6\nIF[#33LE8]GOTO5\nN6#33=8\nN5\n"), none); // or by GOTO6
    EXPECT_EQ(count("#33=#33+1\n#33=8\n"), none);
    EXPECT_EQ(count("#33=#33*2\n"), none);
    EXPECT_EQ(count("IF[#33LT8]THEN#33=8\n"), none); // it never steps
    EXPECT_EQ(count("#2=#2+1\n"), none);
}

} // namespace
} // namespace maclint
