//! `*.nc` as the shell of Windows leaves it to the program.
#include "cli/input/wildcards.hpp"
#include "tests/support/folder.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace maclint::cli {
namespace {

using testing::ElementsAre;

class Wildcards : public testing::Test {
  protected:
    void SetUp() override {
        for (const char* name :
             {"a.nc", "B.NC", "c.ncs", "part[1].nc", ".hidden.nc", "mill/d.nc", "lathe/e.nc"})
            folder.write(name, "");
    }
    /// What stands for the pattern, below the folder.
    [[nodiscard]] std::vector<std::string> expanded(const std::string& pattern) const {
        const std::string root = folder.path().string() + "/";
        auto paths = with_wildcards_expanded({root + pattern});
        for (std::string& path : paths)
            if (path.starts_with(root)) path.erase(0, root.size());
        return paths;
    }

    test::TemporaryFolder folder;
};

TEST_F(Wildcards, StandForNamesInAnyCaseAndInOrder) {
    EXPECT_THAT(expanded("*.nc"), ElementsAre("B.NC", "a.nc", "part[1].nc"));
    EXPECT_THAT(expanded("?.Nc"), ElementsAre("B.NC", "a.nc"));
}

TEST_F(Wildcards, MayStandForFolders) {
    EXPECT_THAT(expanded("*/?.nc"), ElementsAre("lathe/e.nc", "mill/d.nc"));
    EXPECT_THAT(expanded("*/d.nc"), ElementsAre("mill/d.nc"));
}

TEST_F(Wildcards, TakeBracketsAsTheyAre) { EXPECT_THAT(expanded("part[1]*"), ElementsAre("part[1].nc")); }

TEST_F(Wildcards, WithAPointInBetweenStandForAllNames) {
    EXPECT_THAT(expanded("*.*"), ElementsAre("B.NC", "a.nc", "c.ncs", "lathe", "mill", "part[1].nc"));
}

TEST_F(Wildcards, ReachHiddenFilesOnlyByAPoint) { EXPECT_THAT(expanded(".h*"), ElementsAre(".hidden.nc")); }

TEST_F(Wildcards, ThatNothingFitsStay) {
    EXPECT_THAT(expanded("*.tap"), ElementsAre("*.tap"));
    EXPECT_THAT(expanded("none/*.nc"), ElementsAre("none/*.nc"));
    EXPECT_THAT(with_wildcards_expanded({"gone.nc", "-"}), ElementsAre("gone.nc", "-"));
}

} // namespace
} // namespace maclint::cli
