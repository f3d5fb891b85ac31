//! Machines that callers tell.
#include "analyzer/workspace/lathes_of_callers.hpp"

#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;

constexpr char mill = 0, none = 0;
constexpr MachineSigns shown{.tell = true}, not_shown{.tell = false};

/// A file with one program of that number, for a lathe of that system or a mill, which calls others.
FileOutline file(std::int64_t number, char system, MachineSigns signs,
                 std::initializer_list<std::int64_t> called = {}) {
    ProgramOutline program{.language = "fanuc", .number = number, .names = {}, .calls = {}};
    for (const std::int64_t other : called) program.calls.push_back({other});
    return {"O" + std::to_string(number) + ".nc", ProgramOutlines({std::move(program)}), system, signs};
}

TEST(LathesOfCallers, AreThoseOfTheFileThatShowsNone) {
    EXPECT_THAT(lathes_of_callers(std::vector{file(1, 'A', shown, {2, 3}), file(2, mill, not_shown),
                                              file(3, mill, shown), file(4, mill, not_shown)}),
                ElementsAre(none, 'A', none, none));
}

TEST(LathesOfCallers, AreHandedOnOverOthersAndRoundCycles) {
    EXPECT_THAT(lathes_of_callers(std::vector{file(1, 'B', shown, {2}), file(2, mill, not_shown, {3}),
                                              file(3, mill, not_shown, {2, 4}), file(4, mill, not_shown)}),
                ElementsAre(none, 'B', 'B', 'B'));
    EXPECT_THAT(lathes_of_callers(std::vector{file(1, 'B', shown, {2}), file(2, mill, shown, {3}),
                                              file(3, mill, not_shown)}),
                ElementsAre(none, none, none))
        << "a file that shows a mill hands on its own";
    EXPECT_THAT(lathes_of_callers(std::vector{file(1, 'B', shown, {2}), file(2, 'A', shown, {3}),
                                              file(3, mill, not_shown)}),
                ElementsAre(none, none, 'A'))
        << "and nothing else";
}

TEST(LathesOfCallers, AreNoneWhereTheyAreOfTwoKinds) {
    EXPECT_THAT(lathes_of_callers(std::vector{file(1, 'A', shown, {3}), file(2, mill, shown, {3}),
                                              file(3, mill, not_shown)}),
                ElementsAre(none, none, none));
    EXPECT_THAT(lathes_of_callers(std::vector{file(1, 'A', shown, {3}), file(2, 'C', shown, {3}),
                                              file(3, mill, not_shown)}),
                ElementsAre(none, none, none));
}

TEST(LathesOfCallers, OfSystemACallNothingThatHasDistanceCodes) {
    const MachineSigns absolute{.tell = false, .has_distance_code = true};
    EXPECT_THAT(lathes_of_callers(std::vector{file(1, 'A', shown, {2}), file(2, mill, absolute)}),
                ElementsAre(none, none));
    EXPECT_THAT(lathes_of_callers(std::vector{file(1, 'B', shown, {2}), file(2, mill, absolute)}),
                ElementsAre(none, 'B'));
}

} // namespace
} // namespace maclint
