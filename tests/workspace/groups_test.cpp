//! Which files calls connect.
#include "analyzer/workspace/groups.hpp"

#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint {
namespace {

using testing::ElementsAre;

/// A file with one program of that number, which calls others.
FileOutline file(std::string path, std::int64_t number, std::initializer_list<std::int64_t> called) {
    ProgramOutline program{.language = "fanuc", .number = number, .names = {}, .calls = {}};
    for (const std::int64_t other : called) program.calls.push_back({other});
    return {std::move(path), ProgramOutlines({std::move(program)})};
}

TEST(Groups, FilesWithoutCallsStandAlone) {
    EXPECT_THAT(groups_of(std::vector{file("a.nc", 1, {}), file("b.nc", 2, {})}),
                ElementsAre(ElementsAre(0), ElementsAre(1)));
    EXPECT_THAT(groups_of({}), ElementsAre());
}

TEST(Groups, CallersAndTheCalledAreTogetherHoweverFarApart) {
    EXPECT_THAT(groups_of(std::vector{file("a.nc", 1, {3}), file("b.nc", 2, {}), file("c.nc", 3, {4}),
                                      file("d.nc", 4, {}), file("e.nc", 5, {4})}),
                ElementsAre(ElementsAre(0, 2, 3, 4), ElementsAre(1)));
}

TEST(Groups, TheNearestProgramOfANumberIsMeantAndNoOther) {
    EXPECT_THAT(groups_of(std::vector{file("a/main.nc", 1, {2}), file("a/sub.nc", 2, {}),
                                      file("b/main.nc", 1, {2}), file("b/sub.nc", 2, {})}),
                ElementsAre(ElementsAre(0, 1), ElementsAre(2, 3)));
}

TEST(Groups, AllThatMayBeMeantAreTogether) {
    EXPECT_THAT(groups_of(std::vector{file("main.nc", 1, {2}), file("a/sub.nc", 2, {}),
                                      file("b/sub.nc", 2, {}), file("b/c/sub.nc", 2, {})}),
                ElementsAre(ElementsAre(0, 1, 2), ElementsAre(3)));
}

TEST(Groups, AComputedCallConnectsNothing) {
    ProgramOutline program = file("a.nc", 1, {}).programs[0];
    program.calls.push_back({ComputedName{}});
    const FileOutline computing{"a.nc", ProgramOutlines({std::move(program)})};
    EXPECT_THAT(groups_of(std::vector{computing, file("b.nc", 2, {})}),
                ElementsAre(ElementsAre(0), ElementsAre(1)));
}

} // namespace
} // namespace maclint
