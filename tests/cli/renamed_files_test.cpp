//! Which gone file a new one was.
#include "cli/gate/renamed_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Pair;

NamedLines file(const std::string& path, std::string_view text) { return {path, LineBag(text)}; }

constexpr std::string_view torus = "%\nO9010 (TORUS)\n#1=#4003\nG91 G1 Z-#26\nM99\n%\n";
constexpr std::string_view torus_edited = "%\r\nO9010 (TORUS)\r\n#1=#4003\r\nG90 G1 Z-#26\r\nM99\r\n%\r\n";
constexpr std::string_view pocket = "%\nO9020 (POCKET)\nWHILE[#1LT5]DO1\n#1=#1+1\nEND1\nM99\n%\n";

TEST(Renames, GoByWhatIsTheSame) {
    const auto renames = find_renames({file("old/O9010.nc", torus), file("old/O9020.nc", pocket)},
                                      {file("new/P.nc", pocket), file("new/T.nc", torus)});
    EXPECT_THAT(renames.gone_by_new,
                ElementsAre(Pair("new/P.nc", "old/O9020.nc"), Pair("new/T.nc", "old/O9010.nc")));
}

TEST(Renames, TakeHalfForEnoughAndLineEndsForNothing) {
    EXPECT_THAT(find_renames({file("O9010.nc", torus)}, {file("T.nc", torus_edited)}).gone_by_new,
                ElementsAre(Pair("T.nc", "O9010.nc")));
    EXPECT_THAT(find_renames({file("O9010.nc", torus)}, {file("P.nc", pocket)}).gone_by_new, IsEmpty());
    EXPECT_THAT(find_renames({file("A", "1234\n1234\n")}, {file("B", "1234\nabcd\n")}).gone_by_new,
                ElementsAre(Pair("B", "A")));
    EXPECT_THAT(find_renames({file("A", "1234\n1234\n")}, {file("B", "1234\nabcde\n")}).gone_by_new,
                IsEmpty());
}

TEST(Renames, GiveAGoneFileToOneNewFileAlone) {
    EXPECT_THAT(
        find_renames({file("O9010.nc", torus)}, {file("A.nc", torus), file("B.nc", torus)}).gone_by_new,
        ElementsAre(Pair("A.nc", "O9010.nc")));
    EXPECT_THAT(find_renames({file("O9010.nc", torus)}, {file("A.nc", torus_edited), file("B.nc", torus)})
                    .gone_by_new,
                ElementsAre(Pair("B.nc", "O9010.nc")));
}

TEST(Renames, PreferANameThatWasKept) {
    EXPECT_THAT(
        find_renames({file("a/1.nc", torus)}, {file("b/0.nc", torus), file("b/1.nc", torus)}).gone_by_new,
        ElementsAre(Pair("b/1.nc", "a/1.nc")));
    EXPECT_THAT(
        find_renames({file("a/1.nc", torus)}, {file("b/0.nc", torus_edited), file("b/1.nc", torus_edited)})
            .gone_by_new,
        ElementsAre(Pair("b/1.nc", "a/1.nc")));
}

TEST(Renames, PairOnlyWhatIsTheSameOrHasItsNameWhereThereIsTooMuch) {
    std::vector<NamedLines> gone;
    std::vector<NamedLines> added;
    for (int i = 0; i < 4000; ++i) {
        gone.push_back(file("a" + std::to_string(i), "N" + std::to_string(i) + " X1\n"));
        added.push_back(file("b" + std::to_string(i), "M" + std::to_string(i) + " X1\n"));
    }
    gone.push_back(file("z", torus));
    added.push_back(file("y", torus));
    gone.push_back(file("old/O9020.nc", pocket));
    added.push_back(file("new/O9020.nc", std::string(pocket) + "(END)\n"));
    const auto renames = find_renames(gone, added);
    EXPECT_THAT(renames.gone_by_new, ElementsAre(Pair("new/O9020.nc", "old/O9020.nc"), Pair("y", "z")));
    EXPECT_TRUE(renames.bound_was_met);
    EXPECT_FALSE(find_renames({file("z", torus)}, {file("y", torus)}).bound_was_met);
}

} // namespace
} // namespace maclint::cli
